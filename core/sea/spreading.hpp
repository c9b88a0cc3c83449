// How the energy of a wave system is spread over the 72 directions of the grid.
//
// D(theta) = cos^2s((theta - mean)/2), s = 2/sigma^2 - 1, sigma the circular standard deviation
// sqrt(2 (1 - r1)) (contract §3). The weight of a grid direction is the integral of D times the direction's
// hat function, as it is for frequencies: exact for a response that is linear between the directions, and the
// limit sigma -> 0 is the linear split between the two neighbours. The hat itself spreads by 2.04 degrees;
// D is made narrower by as much, so that the weights have the sigma asked for.
//
// Long-crested, and every sigma below 2.04 degrees: the energy goes to the two neighbouring grid directions,
// by distance, so that the mean direction is the one given (within 0.001 degrees); their own circular
// deviation is at most 2.5 degrees. Consequence for a needle: on a grid direction the response is that of
// long-crested waves exactly; between two it is the mean of two. In beam seas a needle at mu = 90 + delta is
// thus read off the chord between |H|^2 at neighbouring directions, at most (5 deg)^2 / 8 = 0.1 % of the
// second derivative from the truth: low at a maximum (roll in beam seas, |H|^2 like sin^2: 0.2 % of it), high
// at a zero (roll in head seas, 0.2 % of the beam value where the truth is less): on the safe side there.
//
// Range: spreading in [0, sqrt 2] rad (81 degrees: isotropic). The weights sum to 1 (rounding), are mirrored
// about the mean direction, and turn with it: a turn by 5 degrees shifts them by one, bit for bit (the mean
// direction is rounded to 5e-6 degrees for this).
// Cost: about 400 exponentials for 30 degrees.
#pragma once

#include <array>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"

namespace quickstrip {

using DirectionWeights = std::array<double, kNumDirections>;

/// s of cos^2s(theta/2). spreading in (0, sqrt 2] [rad].
inline constexpr double spreading_exponent(double spreading) {
  return 2.0 / (spreading * spreading) - 1.0;
}

/// Shares of the energy, sum 1. Errors: kNotFinite, kOutOfRange.
Result<DirectionWeights> direction_weights(WaveFrom mean, double spreading);

/// Mean direction [rad, in [0, 2 pi)] and circular standard deviation [rad] of energy over evenly spaced
/// directions, from the first Fourier coefficient: cosine and sine sums, and the whole energy > 0.
struct MeanDirection {
  WaveFrom from;
  double spreading = 0.0;
};
MeanDirection mean_direction(double cosine_sum, double sine_sum, double energy);

}  // namespace quickstrip
