#include "core/hazard/parametric_roll.hpp"

#include <algorithm>
#include <cmath>

#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {
namespace {

double distance(double at, const Tuning& tuning) {
  return std::max({0.0, tuning.low - at, at - tuning.high});
}

}  // namespace

bool is_parametric_sector(EncounterAngle mu) {
  return std::fabs(std::fabs(mu.radians) - 0.5 * kPi) >= zone::kBeamSector - zone::kAngleRounding;
}

bool in_parametric_zone(const EncounterBand& met, const RollPeriods& roll, EncounterAngle mu) {
  return is_parametric_sector(mu) &&
         (in_synchronous_zone(met, roll) || is_tuned(met, roll, zone::kParametricFrom, zone::kParametricTo));
}

bool does_roll_grow(double h, double zeta, const Tuning& tuning) {
  const double first = distance(2.0, tuning);
  const double second = distance(1.0 - h * h / 12.0, tuning);
  const bool decays_in_first = 0.25 * h * h <= 4.0 * zeta * zeta + first * first;
  const bool decays_in_second = h * h * h * h / 64.0 <= zeta * zeta + second * second;
  return !(decays_in_first && decays_in_second);
}

}  // namespace quickstrip
