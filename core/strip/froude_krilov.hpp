// Undisturbed wave pressure integrated over one section's contour (formulas §6, exact for the contour given).
// Real amplitudes per metre of length and of wave amplitude; the complex loads, for e^{i omega_e t} and a
// crest at the section, are X1 = i surge, X2 = i sway, X3 = heave, X4 = -i roll (about O).
#pragma once

#include <array>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/pair.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

struct FroudeKrilov {
  double surge = 0.0;  // N/m2
  double sway = 0.0;
  double heave = 0.0;
  double roll = 0.0;          // N m/m2
  double heave_factor = 0.0;  // heave / (2 rho g y_w), held in [0, 1]: the equivalent wave elevation
  double horizontal_factor =
      0.0;  // area-averaged e^{kz}: the equivalent horizontal orbital motion is this times surface
};

/// k: wave number [1/m]. Range: any; for a wholly submerged section heave_factor is the area-averaged e^{kz}.
FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double density, double gravity, double k,
                           EncounterAngle mu);

/// e^{kz} times the weight of each point, two by two: alike for waves from every direction. Returns how many
/// pairs.
using ContourDecay = std::array<Pair, kMaxOffsets + 1>;
std::size_t contour_decay(ContourView contour, double k, std::span<Pair> out);

/// The same with contour_decay() given.
FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double rho_g, double k, double sin_mu,
                           double cos_mu, std::span<const Pair> decay);

}  // namespace quickstrip
