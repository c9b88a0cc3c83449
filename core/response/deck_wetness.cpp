#include "core/response/deck_wetness.hpp"

#include "core/response/short_term.hpp"

namespace quickstrip {

double wetness_probability(double freeboard, double m0) {
  return rayleigh_exceedance(freeboard, m0);
}

double wetnesses_per_hour(double freeboard, double m0, double m2) {
  return oscillations_per_hour(m0, m2) * wetness_probability(freeboard, m0);
}

}  // namespace quickstrip
