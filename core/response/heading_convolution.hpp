// One channel, at one speed and one level of roll damping, from relative directions to headings: integrals
// over the bands of the sea at every direction, then their convolution with what each system takes of a band.
// The two steps of heading_moments.hpp, whose workspace they share.
#pragma once

#include <cstddef>

#include "core/base/static_vector.hpp"
#include "core/response/direction_response.hpp"
#include "core/response/heading_moments.hpp"

namespace quickstrip {

/// One channel at one speed, or the waves themselves (null), and what is wanted of it.
struct SweepSubject {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Channel* channel;
  std::size_t wave;  // place among the incident waves
  const SeaEnergy& sea;
  std::size_t num_levels;  // of roll damping, 1 ... kRollDampingLevels
  StaticVector<Moment, 3> moments;

  [[nodiscard]] bool has_sides() const { return channel != nullptr && !is_symmetric(*channel); }
};

/// Integrals by relative direction and band, even and odd in direction, one set a level and moment.
void integrate(const SweepSubject& subject, SweepWorkspace& work);

/// Column `column` of the transforms back to direction, times `scale`, by heading: waves from d meet a ship
/// heading for h at m = h + half a turn - d.
void read_headings(const SweepWorkspace& work, std::size_t column, double scale, ByHeading& out);

/// The moments of one level, into columns of the transforms back to direction: the first by system, then one
/// column each for all systems together.
void convolve(const SweepSubject& subject, std::size_t level, SweepWorkspace& work);

/// A column, what is no more than rounding taken away.
void read_moment(const SweepWorkspace& work, std::size_t column, ByHeading& out);

}  // namespace quickstrip
