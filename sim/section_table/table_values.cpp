#include "sim/section_table/table_values.hpp"

#include <array>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// Even in log H0 on both sides of 1.
constexpr std::array<double, 15> kH0 = {0.05, 0.0727, 0.1058, 0.1538, 0.2236, 0.3252, 0.4729, 0.6877,
                                        1.0,  1.468,  2.154,  3.162,  4.642,  6.813,  10.0};
constexpr std::array<double, 17> kFullness = {0.0,   0.0625, 0.125, 0.1875, 0.25,  0.3125,
                                              0.375, 0.4375, 0.5,   0.5625, 0.625, 0.6875,
                                              0.75,  0.8125, 0.875, 0.9375, 1.0};
constexpr std::array<double, 46> kKappa = {
    0.0,   0.0035, 0.010, 0.019, 0.032, 0.048, 0.067, 0.090, 0.118, 0.150, 0.183, 0.216,
    0.249, 0.283,  0.319, 0.356, 0.394, 0.433, 0.482, 0.538, 0.598, 0.660, 0.722, 0.790,
    0.865, 0.946,  1.035, 1.14,  1.27,  1.45,  1.67,  1.95,  2.30,  2.72,  3.23,  3.85,
    4.60,  5.50,   6.60,  8.2,   10.8,  15.0,  22.5,  40.0,  100.0, 700.0};

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
  const SectionScales scales = section_scales(a1, a3);
  const double growth = 1.0 + kappa;
  SectionQuantities v{};
  v[kHeaveMass] = (solution.a33 + scales.breadth * scales.breadth / kPi * std::log(kappa / growth)) /
                  scales.heave_mass_at_infinity;
  v[kHeaveAmplitude] = solution.h3 * growth * growth / scales.breadth;
  v[kSwayMass] = solution.a22 / scales.sway_mass_at_zero;
  v[kCouplingMass] = solution.a24 / scales.coupling;
  v[kRollMass] = solution.a44;
  v[kSwayAmplitude] = solution.h2 * growth * growth / (kappa * scales.sway_radiation);
  v[kRollAmplitude] = solution.h4 * growth * growth * growth / kappa;
  return v;
}

SectionQuantities smooth_quantities_at_zero(double a1, double a3) {
  const SectionScales scales = section_scales(a1, a3);
  const LewisAddedMass lateral = lateral_added_mass_at_zero(a1, a3);
  SectionQuantities v{};
  v[kHeaveMass] = (heave_added_mass_constant(a1, a3) - scales.breadth * scales.breadth / kPi * kEulerGamma) /
                  scales.heave_mass_at_infinity;
  v[kHeaveAmplitude] = 1.0;
  v[kSwayMass] = 1.0;
  v[kCouplingMass] = lateral.a24 / scales.coupling;
  v[kRollMass] = lateral.a44;
  v[kSwayAmplitude] = 1.0;
  v[kRollAmplitude] = low_frequency_radiation(a1, a3).roll;
  return v;
}

TableEntry table_entry(double h0, double fullness, double kappa) {
  const double q = breadth_draught_parameter(h0);
  const double a3 = a3_of_fullness(q, fullness);
  const double a1 = q * (1.0 + a3);
  TableEntry entry;
  if (kappa == 0.0) {
    entry.quantities = smooth_quantities_at_zero(a1, a3);
    return entry;
  }
  const SectionSolution solution = solve_lewis_form_adaptive(a1, a3, kappa, kNodeTolerance);
  entry.quantities = smooth_quantities(a1, a3, kappa, solution);
  entry.num_multipoles = solution.num_multipoles;
  entry.converged = solution.converged;
  return entry;
}

}  // namespace quickstrip
