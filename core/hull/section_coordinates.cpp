#include "core/hull/section_coordinates.hpp"

#include "core/base/constants.hpp"

namespace quickstrip {

double area_in_scale(double a1, double a3) {
  return 0.5 * kPi * (1.0 - a1 * a1 - 3.0 * a3 * a3);
}

SectionQuantities quantity_scales(double q) {
  constexpr double kMiddlingFullness = 0.3;
  const double a3 = a3_of_fullness(q, kMiddlingFullness);
  const double a1 = q * (1.0 + a3);
  const double sway = lateral_added_mass_at_zero(a1, a3).a22;
  SectionQuantities scale{};
  scale[kHeaveMass] = heave_added_mass_at_infinity(a1, a3);
  scale[kHeaveAmplitude] = breadth_in_scale(a1, a3);
  scale[kSwayMass] = sway;
  scale[kCouplingMass] = std::sqrt(sway);
  scale[kRollMass] = 1.0;
  scale[kSwayAmplitude] = area_in_scale(a1, a3) + sway;  // low-frequency limit
  scale[kRollAmplitude] = 1.0;
  return scale;
}

}  // namespace quickstrip
