#include "core/response/swell_up.hpp"

#include <algorithm>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// [Tasaki1963]
constexpr Interval kBlockCoefficients{0.60, 0.80};
constexpr Interval kFroudeNumbers{0.16, 0.29};
constexpr Interval kFrequencyNumbers{1.60, 2.60};  // omega_e^2 L/g
constexpr double kBowWave = 0.75;                  // of (B/L_E) V^2/g
constexpr double kStagnation = 0.5;                // of V^2/g

// Of the greatest half-breadth: what is left to digitised offsets of a parallel body.
constexpr double kReached = 0.999;

/// Waterline of the hull: fore end and the length from there to the greatest breadth.
struct Entrance {
  double fore_end = 0.0;
  double length = 0.0;
};

Result<Entrance> entrance_of(const Hull& hull, const Loading& loading) {
  const auto half_breadth = [&](std::size_t i) {
    return half_breadth_at(hull.stations[i], waterline_height(hull, loading, hull.stations[i].x));
  };
  double greatest = 0.0;
  std::size_t foremost = 0;
  for (std::size_t i = 0; i < hull.stations.size(); ++i) {
    const double y = half_breadth(i);
    greatest = std::max(greatest, y);
    foremost = y > 0.0 ? i : foremost;
  }
  if (!(greatest > 0.0)) {
    return Error::kOutOfRange;
  }
  const std::size_t end = std::min(foremost + 1, hull.stations.size() - 1);  // it closes at the next station
  const double reached = kReached * greatest;
  double ahead = end == foremost ? half_breadth(end) : 0.0;
  std::size_t i = end;
  while (i > 0 && ahead < reached) {  // bounded: i falls each time
    const double y = half_breadth(i - 1);
    if (y >= reached) {
      const double part = (reached - ahead) / (y - ahead);
      const double x = hull.stations[i].x + part * (hull.stations[i - 1].x - hull.stations[i].x);
      return Entrance{hull.stations[end].x, hull.stations[end].x - x};
    }
    ahead = y;
    --i;
  }
  return Entrance{hull.stations[end].x, 0.0};  // as broad as anywhere at its very end: a barge
}

DynamicSwellUp at_entrance(double block_coefficient, double lpp, double gravity) {
  DynamicSwellUp out{.elsewhere = kSwellUpFactor};
  if (kBlockCoefficients.holds(block_coefficient)) {
    const double speed_unit = std::sqrt(gravity * lpp);
    const double frequency_unit = std::sqrt(gravity / lpp);
    out.speeds = {kFroudeNumbers.from * speed_unit, kFroudeNumbers.to * speed_unit};
    out.frequencies = {std::sqrt(kFrequencyNumbers.from) * frequency_unit,
                       std::sqrt(kFrequencyNumbers.to) * frequency_unit};
    out.by_frequency = (block_coefficient - 0.45) / 3.0 / frequency_unit;
  }
  return out;
}

}  // namespace

double StaticSwellUp::rise(double speed) const {
  const double speed_squared = speed * speed;
  if (!(speed_squared > 0.0) || gravity_distance >= 0.5 * kPi * speed_squared) {
    return 0.0;
  }
  return by_speed_squared * speed_squared * std::cos(gravity_distance / speed_squared);
}

bool SwellUpModel::is_in_range(double speed) const {
  return rule == SwellUp::kOff || at_entrance.speeds.holds(speed);
}

double half_breadth_at(const Station& station, double z) {
  if (station.is_minimal()) {
    return 0.5 * station.breadth;  // one draught only
  }
  double y = 0.0;
  for (std::size_t i = 0; i + 1 < station.offsets.size(); ++i) {
    const Offset& low = station.offsets[i];
    const Offset& high = station.offsets[i + 1];
    if (low.z <= z && z <= high.z) {
      const double part = high.z > low.z ? (z - low.z) / (high.z - low.z) : 1.0;
      y = (1.0 - part) * low.y + part * high.y;
    }
  }
  return y;
}

Result<SwellUpModel> swell_up_model(SwellUp rule, const Hull& hull, const Loading& loading,
                                    const Hydrostatics& hydrostatics) {
  SwellUpModel model;
  model.rule = rule;
  model.lpp = hull.lpp;
  model.gravity = loading.gravity;
  if (rule == SwellUp::kOff) {
    return model;
  }
  if (!(hull.lpp > 0.0) || !(loading.gravity > 0.0) || !(hull.breadth > 0.0)) {
    return Error::kOutOfRange;
  }
  if (!std::isfinite(hydrostatics.cb)) {
    return Error::kNotFinite;
  }
  const Result<Entrance> entrance = entrance_of(hull, loading);
  if (!entrance) {
    return entrance.error();
  }
  model.fore_end = entrance->fore_end;
  model.entrance_length = entrance->length;
  model.at_entrance = at_entrance(hydrostatics.cb, hull.lpp, loading.gravity);
  const double steepest = kStagnation / kBowWave * entrance->length;  // of breadth, at the stagnation height
  const double coefficient =
      hull.breadth < steepest ? kBowWave * hull.breadth / entrance->length : kStagnation;
  model.at_fore_perpendicular.by_speed_squared = coefficient / loading.gravity;
  return model;
}

DynamicSwellUp dynamic_swell_up(const SwellUpModel& model, double x) {
  if (model.rule == SwellUp::kOff) {
    return {};
  }
  if (x < model.fore_end - model.entrance_length) {
    return {.elsewhere = kSwellUpFactor};
  }
  return model.at_entrance;
}

StaticSwellUp static_swell_up(const SwellUpModel& model, double x) {
  if (model.rule == SwellUp::kOff) {
    return {};
  }
  StaticSwellUp out = model.at_fore_perpendicular;
  out.gravity_distance = model.gravity * std::max(0.0, model.lpp - x);
  return out;
}

}  // namespace quickstrip
