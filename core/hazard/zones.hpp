// The IMO zones of a ship in a sea of several wave systems, on any course at any speed: each zone per wave
// system, from Tm02 to Tp of the system, over the band of roll period that is known; inside if any of them
// is. One zone, one file beside this one.
//
//   list_zone_ship()     when the loading changes: GM in waves, roll period, damping of small roll
//   prepare_zones()      once a sea: what does not depend on course and speed
//   zone_bits()          a cell: bits of all systems
//   list_zone_findings() the same with the system, the encounter periods and the end of the roll period band
//
// Physics: exact g V / omega. A system counts when it is higher than 0.01 L, and its longest wave along the
// hull is longer than 0.25 L (zone_parameters.hpp: ours). Directions are the mean ones of the systems, as the
// circulars draw them; spreading is the business of the motions.
// Warnings: surf-riding with long and high waves; successive waves when measured motion shows them;
// parametric roll where dGM/GM in the system's effective wave makes roll grow against the damping of
// vanishing roll, potential damping included, at any encounter frequency and roll period of the bands; pure
// loss where less than 0.05 m of GM is left on the crest of the effective wave. A warning brings its zone
// with it. Not evaluated and said (kHazardZonesUnknown): waves from abaft the beam sector, and GM in waves or
// the roll period is not known.
// Cost (processor time, x86-64): 30 us a system to prepare, 70 ns a cell and system. Memory: 0.5 and 1 kB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"
#include "core/hazard/encounter_band.hpp"
#include "core/hazard/hazard_bits.hpp"
#include "core/hazard/roll_period_band.hpp"
#include "core/hazard/successive_waves.hpp"
#include "core/hull/gm_in_waves.hpp"
#include "core/hull/hull.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

/// Of one hull and loading; a copy with another GM, roll period or damping is a ship of an ensemble.
struct ZoneShip {
  double lpp = 0.0;
  double gravity = 0.0;
  double gm = 0.0;  // still water, fluid
  RollPeriodBand roll;
  GmInWaves gm_in_waves;
  std::size_t num_speeds = 0;
  std::array<double, kMaxSpeeds> speeds{};             // increasing [m/s]
  std::array<float, kMaxSpeeds> roll_damping_ratio{};  // of vanishing roll, of critical; by speed
};

/// `speeds`: of the grid, 1 ... kMaxSpeeds, increasing [m/s]. What cannot be known stays marked so.
void list_zone_ship(const Hull& hull, const Loading& loading, const LoadedHull& loaded,
                    std::span<const double> speeds, ZoneShip& out);

/// Stability in a system's effective wave, met at one angle.
struct EffectiveStability {
  float variation = 0.0F;   // dGM / mean GM
  float least = 0.0F;       // GM [m]
  float stiffening = 1.0F;  // sqrt(mean GM / GM in still water): of the roll frequency
};

struct ZoneSystem {
  static constexpr std::size_t kNumAngles = 10;  // |cos mu| = 0 ... 1

  bool is_high_enough = false;
  bool shows_successive_waves = false;  // measured motion, set by confirm_zones()
  WaveFrom from;
  double hs = 0.0;  // m
  WaveBand waves;   // Tp ... Tm02
  std::array<EffectiveStability, kNumAngles> stability{};
};

struct Zones {
  std::size_t num_systems = 0;
  std::array<ZoneSystem, kMaxWaveSystems> system{};
};

/// `omega`: the frequencies that `sea` lies on.
void prepare_zones(const ZoneShip& ship, const SeaEnergy& sea, std::span<const double> omega, Zones& out);

/// After prepare_zones(): measured motion at the ship's present course and speed.
void confirm_zones(const ZoneShip& ship, Heading heading, double speed, const MeasuredSigns& measured,
                   Zones& zones);

/// Zone bits, kHazardMarginalSurfRiding and kHazardZonesUnknown of all systems.
std::uint16_t zone_bits(const ZoneShip& ship, const Zones& zones, Heading heading, double speed);

/// In a system's effective wave, met from mu; straight lines between the angles.
EffectiveStability effective_stability_at(const ZoneSystem& system, EncounterAngle mu);

/// Which end of the roll period band puts the ship into a zone of roll.
enum class RollPeriodEnd : std::uint8_t { kNone, kShortest, kLongest, kEither };

struct ZoneFinding {
  std::uint8_t system = 0;
  std::uint16_t bits = 0;  // of this system alone
  EncounterAngle mu;
  EncounterBand met;                         // of the waves looked at
  RollPeriodEnd end = RollPeriodEnd::kNone;  // of the roll zones
};

/// Of the systems with any bit.
void list_zone_findings(const ZoneShip& ship, const Zones& zones, Heading heading, double speed,
                        StaticVector<ZoneFinding, kMaxWaveSystems>& out);

}  // namespace quickstrip
