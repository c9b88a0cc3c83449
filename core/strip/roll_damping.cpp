#include "core/strip/roll_damping.hpp"

#include <cmath>

#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

double roll_natural_frequency(const LoadedHull& hull) {
  const double dry = std::sqrt(hull.restoring.c44 / hull.body.ixx);
  // a44 > 0 about O, and about G it stays small beside I_xx: the root lies below the dry frequency unless
  // a44_G is negative, which the upper bracket covers.
  double low = 0.02 * dry;
  double high = 20.0 * dry;
  SectionHydrodynamics section;
  for (int i = 0; i < 40; ++i) {
    const double middle = std::sqrt(low * high);
    section_hydrodynamics(hull, middle, section);
    const double inertia = hull.body.ixx + integral(hull, section[kA44], 0);
    (inertia * middle * middle < hull.restoring.c44 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

double ratio_roll_damping(const LoadedHull& hull, double ratio) {
  return 2.0 * ratio * hull.restoring.c44 / hull.roll_natural_frequency;
}

}  // namespace quickstrip
