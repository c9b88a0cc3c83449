#include "msgs/files/printable.hpp"

namespace quickstrip {
namespace {

/// Bytes of the UTF-8 character at the front of `text` (not empty); 0 when there is none, or a control
/// character. Overlong forms and surrogates are not looked for: they do no harm on a terminal.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) {
    return first >= 0x20 && first != 0x7F ? 1 : 0;
  }
  const std::size_t length = first >= 0xF5   ? 0
                             : first >= 0xF0 ? 4
                             : first >= 0xE0 ? 3
                             : first >= 0xC2 ? 2
                                             : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) {
      return 0;
    }
  }
  const bool is_control = first == 0xC2 && byte(1) < 0xA0;  // U+0080 ... U+009F
  return is_control ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text, std::size_t max_bytes) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = character_bytes(text);
    if (shown.size() + (length == 0 ? 1 : length) > max_bytes) {
      return shown + "...";
    }
    shown += length == 0 ? std::string_view("?") : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

}  // namespace quickstrip
