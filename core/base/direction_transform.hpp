// Fourier transform around the compass: the convolution of a response with the wave energy over heading is a
// product there.
//
// An even function of relative direction has a cosine transform, an odd one a sine transform; both are their
// own inverses but for the factor 1/N. Several functions at once, side by side in the rows of a table, so
// that the processor's vectors run over them. Folded about a quarter turn and, for even wave numbers, about
// an eighth: N^2/10 multiply-adds a function. Sums run in a fixed order: same bits on every run. Expected
// error: rounding, some 1e-16 of the largest value at any direction. No state.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/capacity.hpp"
#include "core/base/check.hpp"

namespace quickstrip {

/// table[m][c]: function c at direction 2 pi m / kNumDirections, m = 0 ... half a turn; or at wave number m.
template <std::size_t Width>
using HalfCircle = std::array<std::array<double, Width>, kNumSolvedDirections>;

namespace direction_transform {

inline constexpr std::size_t kHalf = kNumDirections / 2;
inline constexpr std::size_t kQuarter = kNumDirections / 4;
static_assert(kNumDirections % 4 == 0 && 72 % kNumDirections == 0);

// cos of 0, 5 ... 90 degrees.
inline constexpr std::array<double, 19> kQuarterWave = {1.0,
                                                        0.99619469809174553230,
                                                        0.98480775301220805937,
                                                        0.96592582628906828675,
                                                        0.93969262078590838405,
                                                        0.90630778703664996324,
                                                        0.86602540378443864676,
                                                        0.81915204428899178968,
                                                        0.76604444311897803520,
                                                        0.70710678118654752440,
                                                        0.64278760968653932632,
                                                        0.57357643635104609611,
                                                        0.5,
                                                        0.42261826174069943619,
                                                        0.34202014332566873304,
                                                        0.25881904510252076235,
                                                        0.17364817766693034885,
                                                        0.08715574274765817356,
                                                        0.0};

using Circle = std::array<double, kNumDirections>;

constexpr Circle cosines() {
  constexpr std::size_t kStride = 72 / kNumDirections;
  Circle out{};
  for (std::size_t j = 0; j < kNumDirections; ++j) {
    const std::size_t i = j <= kHalf ? j : kNumDirections - j;
    out[j] = i <= kQuarter ? kQuarterWave[i * kStride] : -kQuarterWave[(kHalf - i) * kStride];
  }
  return out;
}

constexpr Circle sines() {
  constexpr Circle kCosines = cosines();
  Circle out{};
  for (std::size_t j = 0; j < kNumDirections; ++j) {
    out[j] = kCosines[(j + kNumDirections - kQuarter) % kNumDirections];
  }
  return out;
}

/// circle[k m mod N] by wave number k and direction m of a quarter turn.
using Turns = std::array<std::array<double, kQuarter + 1>, kNumSolvedDirections>;

constexpr Turns turns(const Circle& circle) {
  Turns out{};
  for (std::size_t k = 0; k <= kHalf; ++k) {
    for (std::size_t m = 0; m <= kQuarter; ++m) {
      out[k][m] = circle[k * m % kNumDirections];
    }
  }
  return out;
}

inline constexpr Turns kCosine = turns(cosines());
inline constexpr Turns kSine = turns(sines());

/// Functions side by side: rows are padded to a multiple of this.
inline constexpr std::size_t kBlock = 4;
using Block = std::array<double, kBlock>;

// What even and odd wave numbers see of a function folded about a quarter turn, weights included; and what
// every other even one sees of the even ones' folded again.
template <std::size_t NumRows>
struct Folded {
  std::array<Block, NumRows> sum{};
  std::array<Block, NumRows> difference{};
};

// f at m and at N/2 - m; the quarter turn itself once.
template <std::size_t Width>
Folded<kQuarter + 1> fold(const HalfCircle<Width>& in, std::size_t first, double at_ends) {
  Folded<kQuarter + 1> out;
  for (std::size_t m = 0; m <= kQuarter; ++m) {
    const double weight = m == 0 ? at_ends : m == kQuarter ? 1.0 : 2.0;
    for (std::size_t j = 0; j < kBlock; ++j) {
      const double near = in[m][first + j];
      const double far = in[kHalf - m][first + j];
      out.sum[m][j] = weight * (near + far);
      out.difference[m][j] = weight * (near - far);
    }
  }
  return out;
}

// f at m and at N/4 - m; an eighth of a turn, where there is one, as it is.
inline Folded<kQuarter / 2 + 1> fold_again(const std::array<Block, kQuarter + 1>& in) {
  Folded<kQuarter / 2 + 1> out;
  for (std::size_t m = 0; m <= kQuarter / 2; ++m) {
    const double weight = 2 * m == kQuarter ? 0.0 : 1.0;
    for (std::size_t j = 0; j < kBlock; ++j) {
      const double far = weight * in[kQuarter - m][j];
      out.sum[m][j] = in[m][j] + far;
      out.difference[m][j] = in[m][j] - far;
    }
  }
  return out;
}

// Sums of turns[k][m] rows[m] for two wave numbers: enough sums in flight for the latency of an addition.
struct Pair {
  Block first{};
  Block second{};
};

template <std::size_t NumRows>
Pair turn(const std::array<Block, NumRows>& rows, const Turns& turns, std::size_t k, std::size_t other) {
  Pair out;
  for (std::size_t m = 0; m < NumRows; ++m) {
    const double by = turns[k][m];
    const double other_by = turns[other][m];
    for (std::size_t j = 0; j < kBlock; ++j) {
      out.first[j] += by * rows[m][j];
      out.second[j] += other_by * rows[m][j];
    }
  }
  return out;
}

template <std::size_t Width>
std::size_t whole_blocks(std::size_t count) {
  static_assert(Width % kBlock == 0);
  QS_CHECK(count <= Width);
  return (count + kBlock - 1) / kBlock * kBlock;
}

// Wave numbers k = from, from + step ... N/2.
template <std::size_t NumRows, std::size_t Width>
void turn_all(const std::array<Block, NumRows>& rows, const Turns& turns, std::size_t from, std::size_t step,
              std::size_t first, HalfCircle<Width>& out) {
  for (std::size_t k = from; k <= kHalf; k += 2 * step) {
    const std::size_t other = k + step <= kHalf ? k + step : k;
    const Pair sums = turn(rows, turns, k, other);
    for (std::size_t j = 0; j < kBlock; ++j) {
      out[k][first + j] = sums.first[j];
      out[other][first + j] = sums.second[j];
    }
  }
}

}  // namespace direction_transform

inline constexpr std::size_t kTransformBlock = direction_transform::kBlock;

/// out[k][c] = sum over the whole circle of f_c cos(2 pi k m / N), f even: in[0] + (-1)^k in[N/2] +
/// 2 sum of in[m] cos. Functions 0 ... count - 1, rounded up to whole blocks. `out` may be `in`.
template <std::size_t Width>
void cosine_transform(const HalfCircle<Width>& in, std::size_t count, HalfCircle<Width>& out) {
  const std::size_t end = direction_transform::whole_blocks<Width>(count);
  for (std::size_t first = 0; first < end; first += kTransformBlock) {
    const auto folded = direction_transform::fold(in, first, 1.0);
    // cos k(pi - x) = (-1)^k cos kx; of k = 2 l, cos k(pi/2 - x) = (-1)^l cos kx
    const auto again = direction_transform::fold_again(folded.sum);
    direction_transform::turn_all(again.sum, direction_transform::kCosine, 0, 4, first, out);
    direction_transform::turn_all(again.difference, direction_transform::kCosine, 2, 4, first, out);
    direction_transform::turn_all(folded.difference, direction_transform::kCosine, 1, 2, first, out);
  }
}

/// out[k][c] = sum over the whole circle of f_c sin(2 pi k m / N), f odd: 2 sum of in[m] sin. in[0] and
/// in[N/2] are taken as zero.
template <std::size_t Width>
void sine_transform(const HalfCircle<Width>& in, std::size_t count, HalfCircle<Width>& out) {
  const std::size_t end = direction_transform::whole_blocks<Width>(count);
  for (std::size_t first = 0; first < end; first += kTransformBlock) {
    const auto folded = direction_transform::fold(in, first, 0.0);
    // sin k(pi - x) = -(-1)^k sin kx; of k = 2 l, sin k(pi/2 - x) = -(-1)^l sin kx
    const auto again = direction_transform::fold_again(folded.difference);
    direction_transform::turn_all(again.difference, direction_transform::kSine, 0, 4, first, out);
    direction_transform::turn_all(again.sum, direction_transform::kSine, 2, 4, first, out);
    direction_transform::turn_all(folded.sum, direction_transform::kSine, 1, 2, first, out);
  }
}

/// A row for every band of a sea.
inline constexpr std::size_t kBandWidth =
    (kMaxEnergyBands + kTransformBlock - 1) / kTransformBlock * kTransformBlock;

}  // namespace quickstrip
