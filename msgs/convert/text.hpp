// Text in messages: byte[N], UTF-8, NUL-padded, always with a final NUL. Written in place, no heap; what does
// not fit is cut between characters.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace quickstrip {

/// Bytes of `text` that fit into `room` without cutting a UTF-8 character.
inline std::size_t fitting_bytes(std::string_view text, std::size_t room) {
  if (text.size() <= room) {
    return text.size();
  }
  std::size_t n = room;
  while (n > 0 && (static_cast<unsigned char>(text[n]) & 0xC0u) == 0x80u) {
    --n;
  }
  return n;
}

inline void put_text(std::string_view text, std::span<std::uint8_t> field) {
  const std::size_t n = fitting_bytes(text, field.size() - 1);
  for (std::size_t i = 0; i < field.size(); ++i) {
    field[i] = i < n ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
  }
}

/// Up to the first NUL, or the whole field.
inline std::string_view get_text(std::span<const std::uint8_t> field) {
  std::size_t n = 0;
  while (n < field.size() && field[n] != 0) {
    ++n;
  }
  return {reinterpret_cast<const char*>(field.data()), n};
}

/// Appends to a buffer of its own; one final NUL's room is kept by put_text.
class Sentence {
 public:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    const std::size_t room = sizeof(bytes_) - size_;
    const auto result = fmt::format_to_n(bytes_ + size_, room, format, std::forward<Args>(args)...);
    size_ += result.size < room ? result.size : room;
  }
  void capitalise() {
    if (size_ > 0 && bytes_[0] >= 'a' && bytes_[0] <= 'z') {
      bytes_[0] = static_cast<char>(bytes_[0] - 'a' + 'A');
    }
  }
  /// The whole part, or nothing of it where `most_bytes` would be passed.
  bool add_whole(const Sentence& part, std::size_t most_bytes) {
    const bool fits = size_ + part.size_ <= most_bytes && most_bytes <= sizeof(bytes_);
    if (fits) {
      add("{}", part.view());
    }
    return fits;
  }
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }

 private:
  char bytes_[512] = {};  // above the longest text field, 256
  std::size_t size_ = 0;
};

}  // namespace quickstrip
