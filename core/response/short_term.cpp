#include "core/response/short_term.hpp"

#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {

double significant_amplitude(double m0) {
  return 2.0 * std::sqrt(m0);
}

double rayleigh_exceedance(double level, double m0) {
  if (level <= 0.0) {
    return 1.0;
  }
  return m0 > 0.0 ? std::exp(-level * level / (2.0 * m0)) : 0.0;
}

double oscillations_per_hour(double m0, double m2) {
  return m0 > 0.0 ? 3600.0 / kTwoPi * std::sqrt(m2 / m0) : 0.0;
}

}  // namespace quickstrip
