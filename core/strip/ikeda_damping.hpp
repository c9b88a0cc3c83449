// Viscous and lift damping of roll of a whole ship, by the components of Ikeda, Himeno and Tanaka.
// [Ikeda1978] as restated by [ITTC2011]: friction (Kato's, with its speed factor), eddies (per section, with
// theirs), lift (with the smooth fit of kappa to C_M of [JourneeAdegeest2003]), bilge keels (normal force and
// pressure on the hull, per section along the keel).
//
// Wave damping at speed is counted once: Ikeda's factor on b44 at V = 0 [Journee1992] §3, less what strip
// theory has of its own, -V da44/dx (formulas §4.1), and never less than that. On a hull with closed ends
// strip theory has none: the integral of the slope is the jump at the ends (S-175: b44 the same at 0, 10 and
// 20 kn to rounding, while the factor is 4.7 and 7.8).
// Friction is laminar, as in the source: on a full-scale ship all friction is 1 to 2 % of the whole at V = 0
// and 5 to 10 degrees. Range, flagged (RollDampingRange): that of the ships which [Kawahara2009] evaluated
// the method over, C_B 0.5 ... 0.85, C_M 0.9 ... 0.99, B/d 2.5 ... 4.5, OG/d (down) -1.5 ... 0.2, keels 0.01
// ... 0.06 of B and 0.05 ... 0.4 of L, omega-hat up to 1, amplitudes up to 20 degrees. Sections outside the
// section's range are brought into it (ikeda_section()) and flagged where they make more than half of the
// eddies: of the S-175, whose bulb and stern are, 38 %. Expected error of a whole ship: not known here.
// Kawahara's regression of the same method has 1.7 times the eddies and 1.0 to 1.4 times the keels' damping
// for the S-175; single sections: ikeda_section.hpp. Cost: 0.1 ms when the loading changes. No state.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip {

/// The hull's model, with `keel` or bare; kinematic viscosity [m2/s] > 0. `hull` needs its sections and its
/// natural frequency of roll. kNotFinite.
Result<RollDampingModel> ikeda_roll_damping(const LoadedHull& hull, const std::optional<BilgeKeel>& keel,
                                            double viscosity);

/// Pressure of the keel on the hull, over omega [N m s2], at a roll amplitude >= 0 [rad]: what the model
/// tabulates.
double keel_pressure_damping(const LoadedHull& hull, const BilgeKeel& keel, double amplitude);

/// kappa(C_M) of lift, 0 below C_M = 0.91, fitted up to 0.99.
double lift_kappa(double midship_coefficient);

}  // namespace quickstrip
