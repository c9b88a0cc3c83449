#include "core/hazard/successive_waves.hpp"

#include <algorithm>
#include <cmath>

#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {
namespace {

bool is_felt(const std::optional<double>& rms, const std::optional<double>& period, double least,
             const EncounterBand& met) {
  if (!rms || !period || !(*rms >= least) || !(*period > 0.0)) {
    return false;
  }
  const double omega = kTwoPi / *period;
  return met.meets(omega * (1.0 - zone::kFeltPeriod), omega * (1.0 + zone::kFeltPeriod));
}

}  // namespace

bool in_successive_wave_zone(const WaveBand& waves, double hs, double length, double speed, EncounterAngle mu,
                             double gravity) {
  if (!(std::fabs(mu.radians) <= zone::kSuccessiveSector + zone::kAngleRounding) ||
      !(hs > zone::kHighWave * length)) {
    return false;
  }
  const double shortest_long = std::sqrt(kTwoPi * gravity / (zone::kLongWave * length));
  if (!(waves.from < shortest_long)) {
    return false;
  }
  // omega V cos(mu) / g of TE/TW: 1 - 1/1.8 and 1 - 1/3.
  const double along = speed * std::cos(mu.radians) / gravity;
  const double least = waves.from * along;
  const double most = std::min(waves.to, shortest_long) * along;
  return least <= 1.0 - 1.0 / zone::kSuccessiveTo && most >= 1.0 - 1.0 / zone::kSuccessiveFrom;
}

bool shows_successive_waves(const MeasuredSigns& measured, const EncounterBand& met) {
  return is_felt(measured.roll_rms, measured.roll_period, zone::kFeltRoll, met) ||
         is_felt(measured.pitch_rms, measured.pitch_period, zone::kFeltPitch, met);
}

}  // namespace quickstrip
