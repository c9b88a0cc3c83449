#include "core/response/slamming.hpp"

#include <algorithm>
#include <cmath>

#include "core/response/short_term.hpp"

namespace quickstrip {
namespace {

/// level^2 / 2 variance; what is above zero is never reached without motion.
double rayleigh_exponent(double level, double variance) {
  if (level <= 0.0) {
    return 0.0;
  }
  return variance > 0.0 ? std::min(level * level / (2.0 * variance), kNeverExponent) : kNeverExponent;
}

}  // namespace

double ochi_threshold_velocity(double lpp, double gravity) {
  return 0.0928 * std::sqrt(gravity * lpp);  // [Ochi1964]
}

double slamming_exponent(double draught, double threshold_velocity, double m0, double m2) {
  return std::min(rayleigh_exponent(draught, m0) + rayleigh_exponent(threshold_velocity, m2), kNeverExponent);
}

double slamming_probability(double draught, double threshold_velocity, double m0, double m2) {
  return std::exp(-slamming_exponent(draught, threshold_velocity, m0, m2));
}

double slams_per_hour(double draught, double threshold_velocity, double m0, double m2) {
  return oscillations_per_hour(m0, m2) * slamming_probability(draught, threshold_velocity, m0, m2);
}

}  // namespace quickstrip
