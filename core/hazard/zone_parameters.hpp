// Every number of the zones in one place: those of IMO's texts, and ours where IMO gives none ("nearly").
// Changing one of ours changes what the bridge is told; each says why it is what it is.
#pragma once

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"

namespace quickstrip::zone {

inline constexpr double kKnot = 1852.0 / 3600.0;  // m/s

// --- MSC.1/Circ.1228 [IMO2007]
inline constexpr double kSurfRidingSector =
    radians(45.0);                                       // either side of the stern, boundary excluded: 4.2.1
inline constexpr double kSurfRidingSpeed = 1.8 * kKnot;  // m/s per sqrt(m): 1.8 sqrt(L) kn, 4.2.1
inline constexpr double kMarginalSpeed = 1.4 * kKnot;    // the superseded Circ.707's band of large surging
inline constexpr double kSuccessiveSector = radians(45.0);  // either side of the stern, boundary included
inline constexpr double kSuccessiveFrom = 1.8;              // TE / TW, 4.2.2
inline constexpr double kSuccessiveTo = 3.0;

// --- MSC.1/Circ.1228 4.2.2 and MSC.1/Circ.1627 [IMO2020] 4.5.6
inline constexpr double kLongWave = 0.8;   // of L: wave length above which waves carry a ship
inline constexpr double kHighWave = 0.04;  // of L: significant height above which they do

// --- MSC.1/Circ.1627 [IMO2020]
inline constexpr double kSurfRidingSpeedOf1627 = 0.94;  // m/s per sqrt(m), within the same sector
inline constexpr double kPureLossSpeed = 0.752;         // m/s per sqrt(m), following to beam seas
inline constexpr double kLeastGm = 0.05;                // m, on the crest: vulnerability level 1

// --- Ours
// "Nearly equal", of encounter period over roll period: IMO gives no number; +-10 to +-20 % are in use.
inline constexpr double kSynchronousFrom = 0.85;
inline constexpr double kSynchronousTo = 1.15;
inline constexpr double kParametricFrom = 0.45;
inline constexpr double kParametricTo = 0.55;
// Beam seas, where stiffness does not vary along the hull; abaft of them a sea is "following or quartering".
inline constexpr double kBeamSector = radians(30.0);  // either side of abeam
// A wave system is looked at when it can do something to this ship: not lower than this part of her length
// (1.75 m for 175 m; [IMO2020] assesses parametric roll in waves of 0.0167 L), and, along the hull, no
// shorter than this part of it: of more than four waves on a hull the loads cancel.
inline constexpr double kLowWave = 0.01;
inline constexpr double kShortWave = 0.25;
// A roll period that was not measured [IMO2008]: the estimate is good to about this part of it.
inline constexpr double kRollPeriodError = 0.1;
// Measured motion shows successive high waves: at the encounter period of the system, within this part of it,
// and at least so large (RMS).
inline constexpr double kFeltPeriod = 0.15;
inline constexpr double kFeltRoll = radians(3.0);
inline constexpr double kFeltPitch = radians(1.5);
// A boundary angle is met in spite of rounding.
inline constexpr double kAngleRounding = 1e-9;

}  // namespace quickstrip::zone
