#include "core/hull/section_coordinates.hpp"

#include "core/base/constants.hpp"

namespace quickstrip {

SectionScales section_scales(double a1, double a3) {
  const double sway = lateral_added_mass_at_zero(a1, a3).a22;
  const double area = 0.5 * kPi * (1.0 - a1 * a1 - 3.0 * a3 * a3);
  return {.breadth = 2.0 * (1.0 + a1 + a3),
          .area = area,
          .heave_mass_at_infinity = heave_added_mass_at_infinity(a1, a3),
          .sway_mass_at_zero = sway,
          .coupling = std::sqrt(sway),
          .sway_radiation = area + sway};
}

}  // namespace quickstrip
