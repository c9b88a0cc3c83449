#include "tests/bench/cycle_case.hpp"

#include <cmath>

#include "core/advice/nordforsk.hpp"
#include "core/base/constants.hpp"

namespace quickstrip::bench {
namespace {

SeaState sea_of(std::size_t num_systems) {
  SeaState sea;
  for (std::size_t s = 0; s < num_systems; ++s) {
    const auto i = static_cast<double>(s);
    static_cast<void>(sea.systems.push_back({3.0 - 0.3 * i, 7.0 + 2.0 * i, PeriodKind::kPeak,
                                             WaveFrom{radians(220.0 + 35.0 * i)}, radians(30.0 - 3.0 * i),
                                             SpectrumShape::kJonswap, 3.3}));
  }
  return sea;
}

// A wave buoy's 47 bands on 72 directions, two crossing systems.
void fill_measured(DirectionalSpectrum& out) {
  constexpr std::size_t kBands = 47;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    static_cast<void>(out.directions.push_back(kTwoPi * static_cast<double>(d) / kNumDirections));
  }
  for (std::size_t f = 0; f < kBands; ++f) {
    const double omega = 0.2 + 0.06 * static_cast<double>(f);
    static_cast<void>(out.frequencies.push_back(omega));
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      const double direction = out.directions[d];
      const auto bump = [&](double peak, double width, double from, double height) {
        const double x = (omega - peak) / width;
        return height * std::exp(-x * x) * std::pow(std::cos(0.5 * (direction - from)), 20);
      };
      out.density[f][d] = bump(0.5, 0.1, 3.8, 3.0) + bump(0.9, 0.2, 5.2, 1.0);
    }
  }
}

}  // namespace

Criteria every_response(const Hull& hull) {
  Criteria out = *nordforsk_merchant(hull);
  const auto add = [&out](Quantity quantity, std::size_t place, Statistic statistic, double limit) {
    static_cast<void>(out.push_back({.quantity = quantity,
                                     .place = static_cast<std::uint8_t>(place),
                                     .statistic = statistic,
                                     .limit = limit}));
  };
  for (const Quantity motion :
       {Quantity::kSurge, Quantity::kSway, Quantity::kHeave, Quantity::kPitch, Quantity::kYaw}) {
    add(motion, 0, Statistic::kRms, 1e3);
  }
  for (std::size_t p = 0; p < hull.points.size(); ++p) {
    for (const Quantity acceleration : {Quantity::kLongitudinalAcceleration, Quantity::kLateralAcceleration,
                                        Quantity::kVerticalAcceleration}) {
      add(acceleration, p, Statistic::kRms, 1e3);
    }
  }
  return out;
}

std::unique_ptr<Case> make_case(std::size_t num_systems) {
  auto out = std::make_unique<Case>();
  out->sea = sea_of(num_systems);
  fill_measured(out->measured);
  out->inputs.own_ship = &out->ship;
  if (num_systems == 0) {
    out->inputs.spectrum = &out->measured;
  } else {
    out->inputs.sea_state = &out->sea;
  }
  return out;
}

}  // namespace quickstrip::bench
