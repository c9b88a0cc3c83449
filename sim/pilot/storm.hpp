// Storms to sail through, half hour by half hour.
//
// A synthetic one (seeded, the same on every machine) of 30 h:
//   wind sea   Hs = h0 + (h1 - h0) g(t), h0 1 ... 2 m, h1 4 ... 9 m; g rises as exp(-(t - tp)^2 / 2 a^2) and
//              falls with b: tp 9 ... 16 h, a 3 ... 6 h, b 4 ... 8 h. Tp = c sqrt(Hs), c 4.1 ... 4.9
//              s/sqrt(m), JONSWAP 3.3, spreading 30 degrees. It comes from d0 (anywhere) and veers or backs
//              by 30 ... 120 degrees along tanh((t - tp) / 6 h): a depression that passes.
//   swell      Hs 1 ... 3 m, Tp 11 ... 16 s, spreading 15 degrees, from d0 + 40 ... 140 degrees to either
//              side; grows from a third to the whole over the first half.
//   voyage     a course (a multiple of 5 degrees, anywhere) and 14 ... 18 kn.
// The ranges are ours: growth and veering as of a depression in the North Atlantic, and a peak at which a
// container ship of 175 m is in trouble on some courses, but not on all.
// A measured one: a series of spectra over a span of time; the newest record counts (none older than 90 min).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/angles.hpp"
#include "core/sea/sea_state.hpp"
#include "sim/sea_files/sea_series.hpp"

namespace quickstrip::pilot {

inline constexpr double kHalfHour_s = 1800.0;

/// By half hours: one of the two lists, the other is empty.
struct Storm {
  std::string name;
  Heading intended;
  double intended_speed = 0.0;  // m/s
  std::vector<SeaState> states;
  std::vector<const SeaRecord*> records;  // of the caller's series

  [[nodiscard]] std::size_t num_half_hours() const { return states.empty() ? records.size() : states.size(); }
};

Storm synthetic_storm(std::uint64_t seed);

/// From `from_us` on until `to_us` or the first gap.
Storm measured_storm(const std::string& name, const SeaSeries& series, std::int64_t from_us,
                     std::int64_t to_us, Heading intended, double intended_speed);

}  // namespace quickstrip::pilot
