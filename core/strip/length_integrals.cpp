// Integrals over the length of the loaded hull (loaded_hull.hpp).
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/pair_functions.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

void length_integrals(const LoadedHull& hull, const SectionHydrodynamics& section, LengthIntegrals& out) {
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    for (int power = 0; power < 3; ++power) {
      const auto n = static_cast<std::size_t>(power);
      out.plain[q][n] = integral(hull, section[q], power);
      out.slope[q][n] = integral_of_slope(hull, section[q], power);
    }
  }
}

std::array<NodeStencil, 2> node_stencils(const LoadedHull& hull, Pair omega_e) {
  constexpr std::size_t kLast = kNumEncounterNodes - 1;
  const double lowest = hull.log_omega.front();
  const double highest = hull.log_omega.back();
  const Pair log_omega = logarithm(magnitude(omega_e));
  const Pair place = (log_omega - lowest) * (static_cast<double>(kLast) / (highest - lowest));
  std::array<NodeStencil, 2> out;
  for (int l = 0; l < 2; ++l) {
    NodeStencil& at = out[static_cast<std::size_t>(l)];
    at.is_inside = log_omega[l] >= lowest && log_omega[l] <= highest;
    if (!at.is_inside) {
      continue;
    }
    // Nodes are even: the middle one is the nearest, kept off both ends, and u the place from it in steps.
    // Not negative, so that the cast rounds to the nearest.
    const auto nearest = static_cast<std::size_t>(place[l] + 0.5);  // NOLINT(bugprone-incorrect-roundings)
    const auto middle = std::clamp<std::size_t>(nearest, 1, kLast - 1);
    const double u = place[l] - static_cast<double>(middle);
    at.first = middle - 1;
    at.weight = {0.5 * u * (u - 1.0), (1.0 - u) * (1.0 + u), 0.5 * u * (u + 1.0)};
  }
  return out;
}

NodeStencil node_stencil(const LoadedHull& hull, double omega_e) {
  return node_stencils(hull, both(omega_e))[0];
}

void length_integrals(const LoadedHull& hull, double omega_e, LengthIntegrals& out) {
  const NodeStencil s = node_stencil(hull, omega_e);
  if (!s.is_inside) {
    SectionHydrodynamics section;
    section_hydrodynamics(hull, omega_e, section);
    length_integrals(hull, section, out);
    return;
  }
  const LengthIntegrals& i0 = hull.node_integrals[s.first];
  const LengthIntegrals& i1 = hull.node_integrals[s.first + 1];
  const LengthIntegrals& i2 = hull.node_integrals[s.first + 2];
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    for (std::size_t n = 0; n < 3; ++n) {
      out.plain[q][n] =
          s.weight[0] * i0.plain[q][n] + s.weight[1] * i1.plain[q][n] + s.weight[2] * i2.plain[q][n];
      out.slope[q][n] =
          s.weight[0] * i0.slope[q][n] + s.weight[1] * i1.slope[q][n] + s.weight[2] * i2.slope[q][n];
    }
  }
}

double integral(const LoadedHull& hull, const SectionValues& values, int power) {
  double sum = 0.0;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double x = hull.x[i];
    sum += hull.weight[i] * values[i] * (power == 0 ? 1.0 : power == 1 ? x : x * x);
  }
  return sum;
}

double integral_of_slope(const LoadedHull& hull, const SectionValues& values, int power) {
  const auto shape = [power](double x) { return power == 0 ? 1.0 : power == 1 ? x : x * x; };
  const auto mean_shape = [&](double x0, double x1) { return 0.5 * (shape(x0) + shape(x1)); };
  const std::size_t last = hull.num_sections - 1;
  double sum = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    sum += (values[i + 1] - values[i]) * mean_shape(hull.x[i], hull.x[i + 1]);
  }
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    sum += values[0] * mean_shape(hull.x[0] - hull.taper_aft, hull.x[0]);
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    sum -= values[last] * mean_shape(hull.x[last], hull.x[last] + hull.taper_fore);
  }
  return sum;
}

}  // namespace quickstrip
