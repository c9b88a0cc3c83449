#include "sim/section_table/table_values.hpp"

#include <array>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// Even in log H0 on both sides of 1.
constexpr std::array<double, 25> kH0 = {
    0.05, 0.0714, 0.1003, 0.1353, 0.1791, 0.2346, 0.3012, 0.3791, 0.4677, 0.5655, 0.6703, 0.7788, 0.8869,
    1.0,  1.127,  1.284,  1.492,  1.768,  2.138,  2.638,  3.32,   4.349,  5.755,  7.614,  10.0};
constexpr std::array<double, 12> kFullness = {0,    0.13, 0.26, 0.385, 0.5,   0.6,
                                              0.69, 0.77, 0.84, 0.9,   0.955, 1.0};
constexpr std::array<double, 39> kKappa = {
    0,     0.0019, 0.0075, 0.017, 0.03, 0.048, 0.07,  0.097, 0.13,  0.165, 0.204, 0.245, 0.29,
    0.337, 0.386,  0.438,  0.495, 0.56, 0.63,  0.705, 0.79,  0.885, 1.0,   1.15,  1.34,  1.58,
    1.9,   2.3,    2.8,    3.45,  4.3,  5.4,   7.0,   9.4,   13,    19,    32,    75,    700};

// Ten times finer than what the interpolation is asked for.
constexpr double kNodeTolerance = 2e-5;

}  // namespace

std::span<const double> table_h0_nodes() {
  return kH0;
}
std::span<const double> table_fullness_nodes() {
  return kFullness;
}
std::span<const double> table_kappa_nodes() {
  return kKappa;
}

SectionQuantities smooth_quantities(double a1, double a3, double kappa, const SectionSolution& solution) {
  const double breadth = breadth_in_scale(a1, a3);
  const AmplitudeDecay decay = amplitude_decay(waterline_bluntness(a1, a3), kappa);
  SectionQuantities v{};
  v[kHeaveMass] = solution.a33 + breadth * breadth / kPi * std::log(kappa / (1.0 + kappa));
  v[kHeaveAmplitude] = solution.h3 / decay.heave;
  v[kSwayMass] = solution.a22;
  v[kCouplingMass] = solution.a24;
  v[kRollMass] = solution.a44;
  v[kSwayAmplitude] = solution.h2 / decay.sway;
  v[kRollAmplitude] = solution.h4 / decay.roll;
  return v;
}

SectionQuantities smooth_quantities_at_zero(double a1, double a3) {
  const LewisRadiation radiation = low_frequency_radiation(a1, a3);
  const LewisAddedMass lateral = lateral_added_mass_at_zero(a1, a3);
  SectionQuantities v{};
  v[kHeaveMass] = heave_added_mass_constant(a1, a3) - radiation.heave * radiation.heave / kPi * kEulerGamma;
  v[kHeaveAmplitude] = radiation.heave;
  v[kSwayMass] = lateral.a22;
  v[kCouplingMass] = lateral.a24;
  v[kRollMass] = lateral.a44;
  v[kSwayAmplitude] = radiation.sway;
  v[kRollAmplitude] = radiation.roll;
  return v;
}

namespace {

TableEntry scaled(TableEntry entry, double a1, double a3) {
  const SectionQuantities scale = quantity_scales(a1, a3);
  for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
    entry.quantities[q] /= scale[q];
  }
  return entry;
}

}  // namespace

TableEntry table_entry(double h0, double fullness, double kappa) {
  const double q = breadth_draught_parameter(h0);
  const double a3 = a3_of_fullness(q, fullness);
  const double a1 = q * (1.0 + a3);
  TableEntry entry;
  if (kappa == 0.0) {
    entry.quantities = smooth_quantities_at_zero(a1, a3);
    return scaled(entry, a1, a3);
  }
  const SectionSolution solution = solve_lewis_form_adaptive(a1, a3, kappa, kNodeTolerance);
  entry.quantities = smooth_quantities(a1, a3, kappa, solution);
  entry.num_multipoles = solution.num_multipoles;
  entry.converged = solution.converged;
  return scaled(entry, a1, a3);
}

}  // namespace quickstrip
