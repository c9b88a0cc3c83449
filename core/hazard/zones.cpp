#include "core/hazard/zones.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/hazard/parametric_roll.hpp"
#include "core/hazard/pure_loss.hpp"
#include "core/hazard/surf_riding.hpp"
#include "core/hazard/synchronous_roll.hpp"
#include "core/hazard/zone_parameters.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

unsigned bit_if(bool holds, HazardBit bit) {
  return holds ? static_cast<unsigned>(bit) : 0u;
}

/// One system as it is met on one course at one speed.
struct Meeting {
  EncounterAngle mu;
  double cosine = 0.0;
  WaveBand waves{};  // long enough along the hull; may be empty
  EncounterBand met{};
};

Meeting meet(const ZoneShip& ship, const ZoneSystem& system, Heading heading, double speed) {
  Meeting out{.mu = encounter_angle(heading, system.from)};
  out.cosine = std::cos(out.mu.radians);
  const double shortest = kTwoPi * ship.gravity / (zone::kShortWave * ship.lpp);
  const double highest = std::sqrt(shortest / std::max(std::fabs(out.cosine), 1e-6));
  out.waves = {system.waves.from, std::min(system.waves.to, highest)};
  if (!out.waves.is_empty()) {
    out.met = encounter_band(out.waves, speed * out.cosine, ship.gravity);
  }
  return out;
}

EffectiveStability stability_at(const ZoneSystem& system, double cosine) {
  const double place = std::fabs(cosine) * static_cast<double>(ZoneSystem::kNumAngles - 1);
  const std::size_t n = std::min(static_cast<std::size_t>(place), ZoneSystem::kNumAngles - 2);
  const auto t = static_cast<float>(place - static_cast<double>(n));
  const EffectiveStability& a = system.stability[n];
  const EffectiveStability& b = system.stability[n + 1];
  return {a.variation + t * (b.variation - a.variation), a.least + t * (b.least - a.least),
          a.stiffening + t * (b.stiffening - a.stiffening)};
}

double damping_at(const ZoneShip& ship, double speed) {
  std::size_t v = 0;
  while (v + 2 < ship.num_speeds && ship.speeds[v + 1] < speed) {
    ++v;
  }
  const auto here = static_cast<double>(ship.roll_damping_ratio[v]);
  if (ship.num_speeds < 2) {
    return here;
  }
  const double t = (speed - ship.speeds[v]) / (ship.speeds[v + 1] - ship.speeds[v]);
  return here + std::clamp(t, 0.0, 1.0) * (static_cast<double>(ship.roll_damping_ratio[v + 1]) - here);
}

unsigned surf_bits(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed) {
  const double longest = wave_length(system.waves.from, ship.gravity);
  const bool carries = are_long_and_high(ship.lpp, longest, system.hs);
  const bool in_zone = in_surf_riding_zone(ship.lpp, speed, at.mu);
  unsigned bits = bit_if(in_zone, kHazardSurfRiding);
  if (carries && (in_zone || is_surf_riding_speed(ship.lpp, speed, at.mu))) {
    bits |= kHazardSurfRiding | kHazardSurfRidingWaves;
  }
  return bits | bit_if(bits == 0 && in_marginal_band(ship.lpp, speed, at.mu), kHazardMarginalSurfRiding);
}

unsigned successive_bits(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed) {
  if (!in_successive_wave_zone(at.waves, system.hs, ship.lpp, speed, at.mu, ship.gravity)) {
    return 0;
  }
  return kHazardSuccessiveWaves | bit_if(system.shows_successive_waves, kHazardSuccessiveWavesConfirmed);
}

unsigned pure_loss_bits(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed) {
  if (!is_pure_loss_speed(ship.lpp, speed, at.mu)) {
    return 0;
  }
  const double longest = wave_length(system.waves.from, ship.gravity);
  const bool in_zone = are_long_and_high(ship.lpp, longest, system.hs);
  const bool is_lost = ship.gm_in_waves.is_known &&
                       is_stability_lost(static_cast<double>(stability_at(system, at.cosine).least));
  return bit_if(is_lost || in_zone, kHazardPureLoss) | bit_if(is_lost, kHazardPureLossGm);
}

bool grows(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed,
           const RollPeriods& roll) {
  const EffectiveStability stability = stability_at(system, at.cosine);
  const double per_frequency = 1.0 / (kTwoPi * static_cast<double>(stability.stiffening));
  return does_roll_grow(
      static_cast<double>(stability.variation), damping_at(ship, speed),
      {at.met.low * roll.shortest * per_frequency, at.met.high * roll.longest * per_frequency});
}

unsigned roll_bits(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed,
                   const RollPeriods& roll) {
  unsigned bits = bit_if(in_synchronous_zone(at.met, roll), kHazardSynchronousRoll);
  if (in_parametric_zone(at.met, roll, at.mu)) {
    bits |= kHazardParametricRoll;
  }
  if (ship.gm_in_waves.is_known && is_parametric_sector(at.mu) && grows(ship, system, at, speed, roll)) {
    bits |= kHazardParametricRoll | kHazardParametricRollGrows;
  }
  return bits;
}

bool is_from_abaft(EncounterAngle mu) {
  return std::fabs(mu.radians) < 0.5 * kPi - zone::kBeamSector - zone::kAngleRounding;
}

unsigned bits_of(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed) {
  if (!system.is_high_enough || at.waves.is_empty()) {
    return 0;
  }
  unsigned bits = surf_bits(ship, system, at, speed) | successive_bits(ship, system, at, speed) |
                  pure_loss_bits(ship, system, at, speed);
  if (ship.roll.is_known()) {
    bits |= roll_bits(ship, system, at, speed, {ship.roll.shortest, ship.roll.longest});
  }
  if (is_from_abaft(at.mu) && !(ship.roll.is_known() && ship.gm_in_waves.is_known)) {
    bits |= kHazardZonesUnknown;
  }
  return bits;
}

RollPeriodEnd end_of(const ZoneShip& ship, const ZoneSystem& system, const Meeting& at, double speed,
                     unsigned bits) {
  constexpr unsigned kRollBits = kHazardSynchronousRoll | kHazardParametricRoll | kHazardParametricRollGrows;
  if ((bits & kRollBits) == 0) {
    return RollPeriodEnd::kNone;
  }
  const auto alone = [&](double period) {
    return (roll_bits(ship, system, at, speed, {period, period}) & kRollBits) == (bits & kRollBits);
  };
  const bool shortest = alone(ship.roll.shortest);
  const bool longest = alone(ship.roll.longest);
  if (shortest == longest) {
    return RollPeriodEnd::kEither;
  }
  return shortest ? RollPeriodEnd::kShortest : RollPeriodEnd::kLongest;
}

}  // namespace

EffectiveStability effective_stability_at(const ZoneSystem& system, EncounterAngle mu) {
  return stability_at(system, std::cos(mu.radians));
}

void confirm_zones(const ZoneShip& ship, Heading heading, double speed, const MeasuredSigns& measured,
                   Zones& zones) {
  for (std::size_t s = 0; s < zones.num_systems; ++s) {
    ZoneSystem& system = zones.system[s];
    const Meeting at = meet(ship, system, heading, speed);
    const bool in_zone = (bits_of(ship, system, at, speed) & kHazardSuccessiveWaves) != 0;
    system.shows_successive_waves = in_zone && shows_successive_waves(measured, at.met);
  }
}

std::uint16_t zone_bits(const ZoneShip& ship, const Zones& zones, Heading heading, double speed) {
  unsigned bits = 0;
  for (std::size_t s = 0; s < zones.num_systems; ++s) {
    const ZoneSystem& system = zones.system[s];
    if (system.is_high_enough) {
      bits |= bits_of(ship, system, meet(ship, system, heading, speed), speed);
    }
  }
  return static_cast<std::uint16_t>(bits);
}

void list_zone_findings(const ZoneShip& ship, const Zones& zones, Heading heading, double speed,
                        StaticVector<ZoneFinding, kMaxWaveSystems>& out) {
  out.clear();
  for (std::size_t s = 0; s < zones.num_systems; ++s) {
    const ZoneSystem& system = zones.system[s];
    const Meeting at = meet(ship, system, heading, speed);
    const unsigned bits = bits_of(ship, system, at, speed);
    if (bits != 0) {
      QS_CHECK(out.push_back({.system = static_cast<std::uint8_t>(s),
                              .bits = static_cast<std::uint16_t>(bits),
                              .mu = at.mu,
                              .met = at.met,
                              .end = end_of(ship, system, at, speed, bits)}));
    }
  }
}

}  // namespace quickstrip
