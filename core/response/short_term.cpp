#include "core/response/short_term.hpp"

#include <algorithm>
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

double crest_period(double m2, double m4) {
  return m4 > 0.0 ? kTwoPi * std::sqrt(m2 / m4) : 0.0;
}

double bandwidth(double m0, double m2, double m4) {
  if (!(m0 > 0.0) || !(m4 > 0.0)) {
    return 0.0;
  }
  return std::sqrt(std::max(0.0, 1.0 - m2 / m0 * (m2 / m4)));  // Schwarz: never negative but for rounding
}

double maxima_exceedance(double level, double m0, double epsilon) {
  if (!(m0 > 0.0)) {
    return level > 0.0 ? 0.0 : 1.0;
  }
  // [CartwrightLonguetHiggins1956] eq. 5.5 integrated; Phi(-x) = erfc(x / sqrt 2) / 2
  const double alpha = std::sqrt(std::max(0.0, 1.0 - epsilon * epsilon));
  const double eta = std::max(level, 0.0) / std::sqrt(m0);
  if (!(epsilon > 0.0)) {
    return std::exp(-0.5 * eta * eta);
  }
  const double beyond = 0.5 * std::erfc(eta / epsilon / std::sqrt(2.0));
  const double below = 0.5 * std::erfc(-eta * alpha / epsilon / std::sqrt(2.0));
  const double of_all = beyond + alpha * std::exp(-0.5 * eta * eta) * below;
  return of_all / (0.5 * (1.0 + alpha));  // positive ones are (1 + alpha)/2 of all
}

double most_probable_maximum(double m0, double m2, double duration) {
  if (!(m0 > 0.0) || !(m2 > 0.0)) {
    return 0.0;
  }
  const double number = duration / zero_crossing_period(m0, m2);
  return number > 1.0 ? std::sqrt(2.0 * m0 * std::log(number)) : 0.0;
}

}  // namespace quickstrip
