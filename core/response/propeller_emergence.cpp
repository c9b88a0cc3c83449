#include "core/response/propeller_emergence.hpp"

#include "core/response/short_term.hpp"

namespace quickstrip {

double emergence_probability(double depth, double m0) {
  return rayleigh_exceedance(depth, m0);
}

double emergences_per_hour(double depth, double m0, double m2) {
  return oscillations_per_hour(m0, m2) * emergence_probability(depth, m0);
}

}  // namespace quickstrip
