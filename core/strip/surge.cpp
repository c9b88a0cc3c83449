#include "core/strip/surge.hpp"

#include <cmath>

namespace quickstrip {

double spheroid_surge_added_mass_factor(double length, double breadth) {
  const double slenderness = breadth / length;
  const double e2 = 1.0 - slenderness * slenderness;
  // Near the sphere the formula loses digits as (1 - 1)/e^3; alpha = 2/3 - 4 e^2/15 there (series in e).
  if (!(e2 > 1e-4)) {
    const double alpha = 2.0 / 3.0 - 4.0 / 15.0 * e2;
    return alpha / (2.0 - alpha);
  }
  const double e = std::sqrt(e2);
  const double alpha = (1.0 - e2) / (e2 * e) * (std::log((1.0 + e) / (1.0 - e)) - 2.0 * e);
  return alpha / (2.0 - alpha);
}

double still_water_resistance(double lpp, double volume, double density, double speed) {
  return 0.5 * surge_damping_per_speed(lpp, volume, density) * speed * speed;
}

double surge_damping_per_speed(double lpp, double volume, double density) {
  const double coefficient = 1e-3 * (3.6 + 15.2 / (std::log10(lpp) + 0.6));
  return 2.0 * coefficient * density * std::pow(volume, 2.0 / 3.0);
}

}  // namespace quickstrip
