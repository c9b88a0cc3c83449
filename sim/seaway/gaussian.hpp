// Seeded normal numbers, the same on every machine that has IEEE arithmetic: xoshiro256++ [Blackman, Vigna
// 2021] fed by splitmix64, and the polar method [Marsaglia, Bray 1964]. Cost: some 15 ns a number.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quickstrip::seaway {

class Gaussian {
 public:
  /// Streams of one seed do not depend on each other: a block can be made without those before it.
  Gaussian(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t state = seed;
    state = next_splitmix(state) ^ (stream * 0xD1342543DE82EF95ULL);
    for (std::uint64_t& word : state_) {
      word = next_splitmix(state);
    }
  }

  struct Pair {
    double first = 0.0;
    double second = 0.0;
  };
  /// Two independent normal numbers of variance 1.
  Pair pair() {
    for (;;) {  // ends: each turn succeeds with probability pi/4
      const double u = 2.0 * uniform() - 1.0;
      const double v = 2.0 * uniform() - 1.0;
      const double s = u * u + v * v;
      if (s > 0.0 && s < 1.0) {
        const double factor = std::sqrt(-2.0 * std::log(s) / s);
        return {u * factor, v * factor};
      }
    }
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

 private:
  static std::uint64_t rotate(std::uint64_t x, unsigned k) { return (x << k) | (x >> (64U - k)); }
  static std::uint64_t next_splitmix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  std::uint64_t next() {
    const std::uint64_t result = rotate(state_[0] + state_[3], 23U) + state_[0];
    const std::uint64_t t = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotate(state_[3], 45U);
    return result;
  }

  std::array<std::uint64_t, 4> state_{};
};

}  // namespace quickstrip::seaway
