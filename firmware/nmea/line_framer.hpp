// Bytes as they come into lines. No heap: a line that the fixed buffer does not hold is dropped to its end
// and counted, so that a sender without line ends costs nothing but its own lines.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "firmware/nmea/sentence.hpp"

namespace quickstrip::nmea {

class LineFramer {
 public:
  /// `take(line)` for each line that `bytes` completes, without its end (CR LF, LF or CR; empty lines are
  /// passed over); `drop()` for each that was too long.
  template <typename Take, typename Drop>
  void feed(std::string_view bytes, const Take& take, const Drop& drop) {
    for (const char c : bytes) {
      if (c == '\n' || c == '\r') {
        end_line(take, drop);
      } else if (size_ < line_.size()) {
        line_[size_++] = c;
      } else {
        is_too_long_ = true;
      }
    }
  }

  /// The end of a datagram or a file: what is left is a line.
  template <typename Take, typename Drop>
  void finish(const Take& take, const Drop& drop) {
    end_line(take, drop);
  }

 private:
  template <typename Take, typename Drop>
  void end_line(const Take& take, const Drop& drop) {
    if (is_too_long_) {
      drop();
    } else if (size_ > 0) {
      take(std::string_view(line_.data(), size_));
    }
    size_ = 0;
    is_too_long_ = false;
  }

  std::array<char, kMaxLine> line_{};
  std::size_t size_ = 0;
  bool is_too_long_ = false;
};

}  // namespace quickstrip::nmea
