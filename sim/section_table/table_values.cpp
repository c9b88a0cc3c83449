#include "sim/section_table/table_values.hpp"

#include <array>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// Moved one by one until the error of the spline at 16,000 random points was least, and rounded.
constexpr std::array<double, 23> kH0 = {0.05, 0.0601, 0.081, 0.115,  0.165, 0.232, 0.3175, 0.419,
                                        0.53, 0.655,  0.797, 0.8985, 1.0,   1.095, 1.26,   1.533,
                                        1.91, 2.48,   3.29,  4.6,    6.42,  8.1,   10.0};
constexpr std::array<double, 11> kFullness = {0,     0.096, 0.24,   0.396,  0.521, 0.6375,
                                              0.741, 0.832, 0.9065, 0.9425, 1.0};
constexpr std::array<double, kNumTabulatedFrequencies> kKappa = {
    0,     0.00138, 0.0038, 0.0154, 0.0376, 0.0686, 0.1074, 0.1534, 0.2016, 0.251, 0.3063,
    0.359, 0.4225,  0.485,  0.561,  0.656,  0.756,  0.869,  1.01,   1.193,  1.435, 1.78,
    2.263, 3.03,    4.15,   5.68,   8.14,   12.6,   19.4,   45.8,   80,     700};

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

TableEntry scaled(TableEntry entry, double q) {
  const SectionQuantities scale = quantity_scales(q);
  for (std::size_t n = 0; n < kNumSectionQuantities; ++n) {
    entry.quantities[n] /= scale[n];
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
    return scaled(entry, q);
  }
  const SectionSolution solution = solve_lewis_form_adaptive(a1, a3, kappa, kNodeTolerance);
  entry.quantities = smooth_quantities(a1, a3, kappa, solution);
  entry.num_multipoles = solution.num_multipoles;
  entry.converged = solution.converged;
  return scaled(entry, q);
}

}  // namespace quickstrip
