// Parametric roll: the zone of MSC.1/Circ.1228 4.2.3.2 by encounter period, and whether the stiffness varies
// enough for roll to grow out of nothing.
//
// Small roll with a stiffness that varies with the encounter frequency is a damped Mathieu equation,
//   phi'' + 2 zeta w phi' + w^2 (1 + h cos(omega_e t)) phi = 0,  h = dGM / GM, dGM = (GMmax - GMmin) / 2,
// w the natural frequency at the mean GM in the wave. To first order in h and zeta, with r = omega_e / w:
//   region 1, r about 2:  grows where (h/2)^2  > 4 zeta^2 + (r - 2)^2;  at exact tuning h > 4 zeta
//   region 2, r about 1:  grows where (h^2/8)^2 > zeta^2 + (r - 1 + h^2/12)^2;  at exact tuning h > sqrt(8
//   zeta)
// Expected error: against Floquet's theory, tests/hazard: below 6 % of h for h <= 0.5 in region 1, 10 % in
// region 2. Source: Landau and Lifshitz, Mechanics, §27, with damping; [IMO2007], [IMO2020]. No state.
#pragma once

#include "core/base/angles.hpp"
#include "core/hazard/encounter_band.hpp"
#include "core/hazard/synchronous_roll.hpp"

namespace quickstrip {

/// Following, quartering, head and bow seas: all but beam seas.
bool is_parametric_sector(EncounterAngle mu);

/// There, and TE nearly TR or nearly TR/2.
bool in_parametric_zone(const EncounterBand& met, const RollPeriods& roll, EncounterAngle mu);

/// Frequency ratios omega_e / w, low ... high.
struct Tuning {
  double low = 0.0;
  double high = 0.0;
};

/// h >= 0, zeta >= 0 of critical: whether roll grows at any ratio of the tuning. An h or a zeta that is no
/// number counts as growing.
bool does_roll_grow(double h, double zeta, const Tuning& tuning);

}  // namespace quickstrip
