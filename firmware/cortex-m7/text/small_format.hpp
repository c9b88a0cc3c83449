// What the sentences of msgs/convert use of libfmt, for a machine without a heap: libfmt's numbers go through
// a buffer that may grow, so that a program with it asks for operator new. The same characters as libfmt
// gives (tests/cortex_m7): rounding is that of the exact binary value, ties to even.
//
// Fields: {} of text or of an integer, {:.Nf} and {:0W.Nf} with N = 0 ... 3 of a double below 2^53 (beyond
// it, infinite or NaN: "inf" or "nan"). Anything else in a format string does not compile.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace quickstrip::small_format {

struct Result {
  char* out = nullptr;
  std::size_t size = 0;  // of the whole text, also of what did not fit
};

/// How a field is written.
struct Field {
  bool is_number = false;
  unsigned width = 0;  // with zeros in front
  unsigned decimals = 0;
};

/// Characters into room that may be too small; counts them all.
class Writer {
 public:
  Writer(char* out, std::size_t room) : out_(out), room_(room) {}
  void put(char c) {
    if (size_ < room_) {
      out_[size_] = c;
    }
    ++size_;
  }
  void put(std::string_view text) {
    for (const char c : text) {
      put(c);
    }
  }
  [[nodiscard]] Result result() const { return {out_ + std::min(size_, room_), size_}; }

 private:
  char* out_;
  std::size_t room_;
  std::size_t size_ = 0;
};

/// Of a field; text and integers ignore width and decimals.
void write(Writer& out, const Field& field, double value);
void write(Writer& out, const Field& field, std::int64_t value);
inline void write(Writer& out, const Field& /*field*/, std::string_view text) {
  out.put(text);
}
template <std::integral Integer>
void write(Writer& out, const Field& field, Integer value) {
  write(out, field, static_cast<std::int64_t>(value));
}

/// Called where a format string is not understood: not constexpr, so that it stops the compiler.
inline void this_field_is_not_known_to_small_format() {}

/// From just behind the '{' to just behind the '}'.
constexpr Field parse_field(std::string_view format, std::size_t& at) {
  const auto peek = [&](std::size_t ahead = 0) {
    return format.size() - at > ahead && at <= format.size() ? format[at + ahead] : '\0';
  };
  Field field;
  if (peek() == ':') {
    ++at;
    field.is_number = true;
    if (peek() == '0') {
      field.width = static_cast<unsigned>(peek(1) - '0');
      at += 2;
    }
    if (peek() != '.' || peek(1) < '0' || peek(1) > '3' || peek(2) != 'f' || field.width > 9) {
      this_field_is_not_known_to_small_format();
    }
    field.decimals = static_cast<unsigned>(peek(1) - '0');
    at += 3;
  }
  if (peek() != '}') {
    this_field_is_not_known_to_small_format();
  }
  ++at;
  return field;
}

template <typename... Args>
class CheckedFormat {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as libfmt's
  consteval CheckedFormat(const char* text) : text_(text) {
    constexpr std::array<bool, sizeof...(Args) + 1> kIsDouble{
        std::is_floating_point_v<std::remove_cvref_t<Args>>..., false};
    std::size_t num_fields = 0;
    for (std::size_t at = 0; at < text_.size();) {
      if (text_[at] == '}') {
        this_field_is_not_known_to_small_format();
      }
      if (text_[at++] == '{') {
        const Field field = parse_field(text_, at);
        if (num_fields >= sizeof...(Args) || field.is_number != kIsDouble[num_fields]) {
          this_field_is_not_known_to_small_format();
        }
        ++num_fields;
      }
    }
    if (num_fields != sizeof...(Args)) {
      this_field_is_not_known_to_small_format();
    }
  }
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};
template <typename... Args>
using format_string = CheckedFormat<std::type_identity_t<Args>...>;

/// Up to the next field, which it reads.
Field next_field(std::string_view format, std::size_t& at, Writer& out);

template <typename... Args>
Result format_to_n(char* out, std::size_t room, format_string<Args...> format, Args&&... args) {
  Writer writer(out, room);
  std::size_t at = 0;
  (write(writer, next_field(format.text(), at, writer), args), ...);
  static_cast<void>(next_field(format.text(), at, writer));
  return writer.result();
}

}  // namespace quickstrip::small_format
