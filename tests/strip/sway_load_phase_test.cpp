#include "core/strip/sway_load_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "core/base/constants.hpp"
#include "core/hull/lewis_limits.hpp"
#include "core/strip/section_table.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {
namespace {

LewisSection section_of(double h0, double sigma, double draught = 1.0) {
  return *lewis_section(2.0 * h0 * draught, draught, 2.0 * h0 * sigma * draught * draught);
}

// [Ursell1947]: the load on a vertical plate is in phase with i / (K1 + i pi I1), that is
// pi/2 - atan(pi I1 / K1). A Lewis form of H0 = 0.05 and sigma = 1 has still a breadth: 0.02.
TEST(SwayLoadPhase, OfANarrowSectionIsThatOfAVerticalPlate) {
  const LewisSection narrow = section_of(0.05, 1.0);
  for (const double k : {0.05, 0.2, 0.5, 1.0, 1.5, 2.2, 3.0, 6.0}) {
    const double plate = 0.5 * kPi - std::atan2(kPi * std::cyl_bessel_i(1.0, k), std::cyl_bessel_k(1.0, k));
    const double kb = 0.05 * k;  // the narrow section's weather side lies that far ahead
    EXPECT_NEAR(sway_load_phase(narrow, k), plate + kb, 0.05 + 0.02) << k;
    EXPECT_NEAR(sway_load_phase(section_of(1e-4 + 0.05, 1.0), k), sway_load_phase(narrow, k), 1e-3);
  }
}

TEST(SwayLoadPhase, InLongWavesTheLoadLeadsTheCrestByAQuarterPeriodLessItsDamping) {
  for (const double h0 : {0.3, 1.0, 2.5}) {
    const LewisSection s = section_of(h0, 0.8);
    const double k = 1e-3;
    // Equivalent motion: tan = omega b22 / omega^2 (rho A + a22), of order k^2; next order k^3.
    const double d2 = low_frequency_radiation(s.a1, s.a3).sway * s.scale * s.scale;
    EXPECT_NEAR(sway_load_phase(s, k), 0.5 * kPi - k * k * d2, 10.0 * k * k * (h0 + h0 * h0));
    EXPECT_NEAR(sway_load_phase(s, k), 0.5 * kPi, 1e-4);
  }
}

// Short waves are reflected by the weather side, half a breadth ahead: the load is in phase with the crest
// there.
TEST(SwayLoadPhase, InShortWavesFollowsTheCrestAtTheWeatherSide) {
  const LewisSection wall = section_of(1.3, 0.98);
  for (const double k : {4.0, 7.0, 20.0}) {
    EXPECT_NEAR(sway_load_phase(wall, k) - 0.5 * k * wall.breadth, 0.0, 0.03) << k;
  }
}

TEST(SwayLoadPhase, ScalesWithTheSection) {
  const LewisSection model = section_of(1.2, 0.9, 0.1);
  const LewisSection ship = section_of(1.2, 0.9, 10.0);
  for (const double kt : {0.1, 0.7, 3.0}) {
    EXPECT_NEAR(sway_load_phase(model, kt / 0.1), sway_load_phase(ship, kt / 10.0), 1e-12);
  }
}

// The multipole solution's dipole strength has the phase of the wave that a swaying section radiates, and by
// the Haskind relation that of the load.
TEST(SwayLoadPhase, AgreesWithTheMultipoleSolutionOver600RandomSections) {
  std::mt19937 engine(47);
  const auto uniform = [&engine] { return (static_cast<double>(engine()) + 0.5) / 4294967296.0; };
  std::vector<double> narrow;  // errors below H0 = 1.5, rad
  std::vector<double> wide;    // 1.5 ... 8
  for (int n = 0; n < 600; ++n) {
    const double h0 = 0.06 * std::pow(8.0 / 0.06, uniform());
    const double low = reentrant_limit(h0);
    const double high = std::min(1.05 * conventional_limit(h0), upper_limit(h0));
    const LewisSection s = section_of(h0, low + (high - low) * uniform());
    const double k = 0.01 * std::pow(500.0, uniform());
    const SectionSolution solution = solve_lewis_form(s.a1, s.a3, k * s.scale, 40);
    const double expected = 0.5 * kPi - solution.sway_phase_lag;
    const double error = std::fabs(std::remainder(sway_load_phase(s, k) - expected, kTwoPi));
    (h0 < 1.5 ? narrow : wide).push_back(error);
  }
  std::sort(narrow.begin(), narrow.end());
  std::sort(wide.begin(), wide.end());
  const auto at = [](const std::vector<double>& errors, double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  std::printf(
      "phase of the sway load, error [rad]: H0 < 1.5 median %.4f, 90 %% %.3f, worst %.3f; H0 1.5 ... 8 %.4f, "
      "%.3f, %.3f\n",
      at(narrow, 0.5), at(narrow, 0.9), at(narrow, 1.0), at(wide, 0.5), at(wide, 0.9), at(wide, 1.0));
  EXPECT_LT(at(narrow, 0.9), 0.03);
  EXPECT_LT(at(narrow, 1.0), 0.08);
  EXPECT_LT(at(wide, 0.9), 0.08);
  EXPECT_LT(at(wide, 1.0), 0.16);
}

}  // namespace
}  // namespace quickstrip
