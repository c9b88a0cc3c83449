// Name: a short text in place (UTF-8, zero-padded), for points, criteria and profiles.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/base/capacity.hpp"

namespace quickstrip {

struct Name {
  std::array<char, kMaxNameBytes> bytes{};

  Name() = default;
  /// Text longer than kMaxNameBytes - 1 is cut; readers of files refuse it before.
  explicit Name(std::string_view text) {
    for (std::size_t i = 0; i < text.size() && i + 1 < kMaxNameBytes; ++i) {
      bytes[i] = text[i];
    }
  }
  [[nodiscard]] std::string_view view() const {
    std::size_t n = 0;
    while (n < kMaxNameBytes && bytes[n] != '\0') {
      ++n;
    }
    return {bytes.data(), n};
  }
  bool operator==(const Name&) const = default;
};

}  // namespace quickstrip
