// The S-175 in a simulated sea, and what the advisor says of it.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "core/strip/transfer_functions.hpp"
#include "sim/seaway/questions.hpp"
#include "sim/seaway/simulation.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::seaway {

inline WaveSystem wave_system(double hs, double t1, double from_deg, double spreading_deg) {
  WaveSystem system;
  system.hs = hs;
  system.period = t1;
  system.period_kind = PeriodKind::kMean;
  system.from = WaveFrom{wrap_two_pi(radians(from_deg))};
  system.spreading = radians(spreading_deg);
  return system;
}

/// Heading north: waves from `from_deg` travel at mu = 180 - from.
class Scene {
 public:
  Scene(double hs, double t1, double mu_deg, double spreading_deg, double speed_kn)
      : hull(std::make_unique<Hull>(test::s175())), loaded(std::make_unique<LoadedHull>()) {
    QS_CHECK(load(*hull, hull->loading, {}, *loaded).ok());
    QS_CHECK(list_channels(*hull, hull->loading, loaded->hydrostatics, SwellUp::kOff, watch).ok());
    QS_CHECK(sea.systems.push_back(wave_system(hs, t1, 180.0 - mu_deg, spreading_deg)));
    plan.speed = speed_kn * 1852.0 / 3600.0;
  }
  /// Only these are simulated, counted and stated.
  void watch_only(const std::vector<std::pair<Quantity, std::uint8_t>>& wanted) {
    Watch few;
    few.gravity = watch.gravity;
    for (const auto& [quantity, place] : wanted) {
      QS_CHECK(few.channels.push_back(watch.channels[find_channel(watch, quantity, place)]));
    }
    watch = few;
  }
  [[nodiscard]] Beams beams() const {
    const auto transfer = std::make_unique<TransferFunctions>();
    choose_frequencies(*loaded, *transfer);
    const Result<Beams> out =
        beams_of(sea, {transfer->omega[0], transfer->omega[transfer->num_frequencies - 1]});
    QS_CHECK(out.ok());
    return *out;
  }
  [[nodiscard]] Simulation simulation() const {
    const Result<Simulation> out = prepare(*loaded, watch, beams(), plan);
    QS_CHECK(out.ok());
    return *out;
  }
  [[nodiscard]] Stated said() const {
    const Result<Stated> out = stated(*hull, *loaded, watch, {&sea, nullptr}, plan.heading, plan.speed, 0);
    QS_CHECK(out.ok());
    return *out;
  }

  std::unique_ptr<Hull> hull;
  std::unique_ptr<LoadedHull> loaded;
  Watch watch;
  SeaState sea;
  Plan plan;
};

}  // namespace quickstrip::seaway
