// Brings an object that is needed soon into the nearer memory of the processor: a hint, which changes no
// value.
#pragma once

#include <cstddef>

#include "core/base/capacity.hpp"

namespace quickstrip {

template <typename T>
void prefetch(const T& object) {
  constexpr bool kHasLines = kCacheLine > alignof(double);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&object);
  for (std::size_t i = 0; kHasLines && i < sizeof(T); i += kCacheLine) {
    __builtin_prefetch(bytes + i);
  }
}

}  // namespace quickstrip
