#include "msgs/files/toml_letters.hpp"

#include <algorithm>
#include <array>

#include "msgs/files/printable.hpp"

namespace quickstrip {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Where the string that begins at `at` with `mark` ends: behind its last quote, or the end of the text.
std::size_t end_of_string(std::string_view text, std::size_t at, std::string_view mark) {
  const bool has_escapes = mark.front() == '"';
  const bool is_of_one_line = mark.size() == 1;
  std::size_t i = at + mark.size();
  while (i < text.size()) {
    if (has_escapes && text[i] == '\\') {
      i += 2;
    } else if (is_of_one_line && text[i] == '\n') {
      return i;  // not closed: toml++ refuses it here
    } else if (text.substr(i).starts_with(mark)) {
      i += mark.size();
      for (int more = 0; mark.size() == 3 && more < 2 && i < text.size() && text[i] == mark.front(); ++more) {
        ++i;  // one or two quotes before the closing three belong to the text
      }
      return i;
    } else {
      ++i;
    }
  }
  return text.size();
}

/// The quotes at the front of `text`; empty when there are none.
std::string_view opening_mark(std::string_view text) {
  constexpr std::array<std::string_view, 4> kMarks{"\"\"\"", "'''", "\"", "'"};
  const auto* const found =
      std::find_if(kMarks.begin(), kMarks.end(), [text](std::string_view m) { return text.starts_with(m); });
  return found == kMarks.end() ? std::string_view{} : *found;
}

}  // namespace

std::optional<LetterOutsideQuotes> letter_outside_quotes(std::string_view text) {
  std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  while (i < text.size()) {
    if (static_cast<unsigned char>(text[i]) >= 0x80) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n');
      std::size_t end = i + 1;
      while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) {
        ++end;
      }
      return LetterOutsideQuotes{static_cast<std::size_t>(line),
                                 printable(text.substr(i, std::min<std::size_t>(end - i, 4)))};
    }
    if (text[i] == '#') {
      i = std::min(text.size(), text.find('\n', i));
      continue;
    }
    const std::string_view mark = opening_mark(text.substr(i));
    i = mark.empty() ? i + 1 : end_of_string(text, i, mark);
  }
  return std::nullopt;
}

}  // namespace quickstrip
