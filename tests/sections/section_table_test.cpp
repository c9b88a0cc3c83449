#include "core/strip/section_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "core/base/constants.hpp"
#include "core/hull/lewis_limits.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/strip/section_table_data.hpp"
#include "sim/section_table/accuracy.hpp"
#include "sim/section_table/lagrange_table.hpp"
#include "sim/section_table/table_values.hpp"
#include "sim/section_table/table_writer.hpp"

namespace quickstrip {
namespace {

TEST(SectionTable, ChecksumFitsTheDataAndTheSizeItsBounds) {
  EXPECT_TRUE(section_table_is_intact());
  EXPECT_LE(section_table_numbers(), 82'992U);  // of the paper's database
  EXPECT_LE(section_table_bytes(), 400'000U);
  EXPECT_EQ(section_table_version(), kSectionTableVersion);
}

TEST(SectionTable, NodesAreThoseOfTheGenerator) {
  namespace data = section_table_data;
  ASSERT_EQ(data::kLogH0Below.size() + data::kLogH0Above.size(), table_h0_nodes().size() + 1);
  ASSERT_EQ(data::kFullness.size(), table_fullness_nodes().size());
  ASSERT_EQ(data::kFrequency.size(), table_kappa_nodes().size());
  for (std::size_t i = 0; i < data::kFrequency.size(); ++i) {
    EXPECT_DOUBLE_EQ(data::kFrequency[i], frequency_coordinate(table_kappa_nodes()[i]));
  }
  EXPECT_EQ(data::kGreatestKappa, table_kappa_nodes().back());
  EXPECT_DOUBLE_EQ(std::exp(data::kLogH0Below.front()), kMinTabulatedH0);
  EXPECT_EQ(data::kLogH0Below.back(), 0.0);
  EXPECT_EQ(data::kLogH0Above.front(), 0.0);
  EXPECT_DOUBLE_EQ(std::exp(data::kLogH0Above.back()), kMaxTabulatedH0);
}

TEST(SectionTable, SplineHasTheGeneratorsValuesAtRandomNodes) {
  const std::size_t num_below = section_table_data::kLogH0Below.size();
  const LagrangeTable at_nodes;
  std::mt19937 engine(20);
  constexpr int kNodes = 300;
  for (int n = 0; n < kNodes; ++n) {
    const std::size_t row = engine() % (table_h0_nodes().size() + 1);  // H0 = 1 has two
    const std::size_t j = engine() % table_fullness_nodes().size();
    const std::size_t k = engine() % table_kappa_nodes().size();
    const double h0 = table_h0_nodes()[row < num_below ? row : row - 1];
    const SectionQuantities expected =
        table_entry(h0, table_fullness_nodes()[j], table_kappa_nodes()[k]).quantities;
    const SectionQuantities stored = at_nodes.at_node(row, j, k);
    for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
      // 64 coefficients rounded to float, of about the magnitude of the value, and the value itself.
      EXPECT_NEAR(stored[q], expected[q], 3e-7 * (1.0 + std::abs(expected[q])));
    }
  }
}

// The goal of the table; 24 and 44 to the 22-44 mean. 10,000 points by the tool, 400 here.
TEST(SectionTable, AgreesWithTheDirectSolutionOverThePracticalRegion) {
  const AccuracyStudy study = measure_accuracy(SectionRegion::kPractical, 400, 11);
  EXPECT_EQ(study.not_converged, 0U);
  for (std::size_t k = 0; k < kNumCoefficients; ++k) {
    EXPECT_LE(quantile(study.spline[k], 0.5), 5e-5) << coefficient_name(k);
    EXPECT_LE(quantile(study.spline[k], 0.95), 1e-3) << coefficient_name(k);
  }
}

TEST(SectionTable, AgreesWithTheDirectSolutionOverBulbousAndTunnelledForms) {
  const AccuracyStudy study = measure_accuracy(SectionRegion::kFull, 300, 12);
  for (std::size_t k = 0; k < kNumCoefficients; ++k) {
    EXPECT_LE(quantile(study.spline[k], 0.5), 5e-5) << coefficient_name(k);
    EXPECT_LE(quantile(study.spline[k], 0.95), 1e-3) << coefficient_name(k);
    // Why the spline is in core and Lagrange interpolation is not.
    EXPECT_LT(3.0 * quantile(study.spline[k], 0.5), quantile(study.lagrange[k], 0.5)) << coefficient_name(k);
    EXPECT_LT(3.0 * quantile(study.spline[k], 0.95), quantile(study.lagrange[k], 0.95))
        << coefficient_name(k);
  }
}

struct Section {
  double h0;
  double sigma;
};
constexpr Section kSections[] = {{0.08, 0.9},    {0.5, 0.6},  {1.0, 0.7854},
                                 {1.337, 0.968}, {2.5, 0.99}, {8.0, 0.7}};

TEST(SectionTable, TendsToTheClosedFormsAtBothEndsOfFrequency) {
  for (const Section& section : kSections) {
    const LewisSection s = *lewis_section(2.0 * section.h0, 1.0, 2.0 * section.h0 * section.sigma);
    const SectionTableColumn column = *section_table_column(section.h0, section.sigma);
    const double by_area = s.scale * s.scale / s.area;
    const SectionCoefficients low = section_coefficients(column, 0.0);
    const double a22 = lateral_added_mass_at_zero(s.a1, s.a3).a22 * by_area;
    EXPECT_NEAR(low.a22, a22, 5e-4 * a22);  // closed form at the nodes, interpolated between
    EXPECT_EQ(low.b22, 0.0);
    EXPECT_TRUE(std::isfinite(low.a33));
    const SectionCoefficients high = section_coefficients(column, 1e7);
    const double a33 = heave_added_mass_at_infinity(s.a1, s.a3) * by_area;
    EXPECT_NEAR(high.a33, a33, 1e-4 * a33);
    EXPECT_NEAR(high.a22, lateral_added_mass_at_infinity(s.a1, s.a3).a22 * by_area, 1e-4);
    // Long waves: b33 -> omega B^2 rho, normalised B^2 sqrt(xi) / A.
    constexpr double xi = 1e-5;
    const double b33 = s.breadth * s.breadth / s.area * std::sqrt(xi);
    EXPECT_NEAR(section_coefficients(column, xi).b33, b33, 2e-3 * b33);
  }
}

TEST(SectionTable, IsContinuousAboveItsLastFrequency) {
  for (const Section& section : kSections) {
    const SectionTableColumn column = *section_table_column(section.h0, section.sigma);
    const double top = section_table_data::kGreatestKappa * column.form.breadth / 2.0;
    const auto below = as_array(section_coefficients(column, top * (1.0 - 1e-9)));
    const auto above = as_array(section_coefficients(column, top * (1.0 + 1e-9)));
    for (std::size_t k = 0; k < kNumCoefficients; ++k) {
      EXPECT_NEAR(above[k], below[k], 1e-6 * std::abs(below[k]) + 1e-15) << coefficient_name(k);
    }
  }
}

TEST(SectionTable, DampingIsPositiveSemiDefiniteEverywhere) {
  for (const Section& section : kSections) {
    const SectionTableColumn column = *section_table_column(section.h0, section.sigma);
    for (double xi = 1e-4; xi < 1e4; xi *= 1.3) {
      const SectionCoefficients c = section_coefficients(column, xi);
      EXPECT_GE(c.b22, 0.0);
      EXPECT_GE(c.b33, 0.0);
      EXPECT_GE(c.b44, 0.0);
      EXPECT_NEAR(c.b24 * c.b24, c.b22 * c.b44, 1e-12 * c.b22 * c.b44 + 1e-300);
    }
  }
}

// Ogilvie 1964: a(omega) - a(infinity) = (2/pi) PV integral b(u) / (u^2 - omega^2) du. An identity of causal
// systems that neither the solver nor the table knows of. Frequencies in sqrt(2g/B).
double added_mass_by_damping(const std::function<double(double)>& damping, double omega) {
  constexpr double kTop = 60.0;
  constexpr int kSteps = 60'000;
  const double at_omega = damping(omega);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) * kTop / kSteps;
    // The subtracted constant has no principal value over 0 ... infinity; regular at u = omega.
    const double gap = u * u - omega * omega;
    sum += std::abs(gap) > 1e-9 ? (damping(u) - at_omega) / gap : 0.0;
  }
  const double tail = -at_omega / (2.0 * omega) * std::log((kTop + omega) / (kTop - omega));
  return 2.0 / kPi * (sum * kTop / kSteps + tail);
}

TEST(SectionTable, AddedMassAndDampingObeyKramersAndKronig) {
  for (const Section& section : kSections) {
    const SectionTableColumn column = *section_table_column(section.h0, section.sigma);
    const SectionCoefficients end = section_coefficients(column, 1e9);
    const auto at = [&column](double omega) { return section_coefficients(column, omega * omega); };
    for (const double omega : {0.37, 0.81, 1.43}) {
      const SectionCoefficients c = at(omega);
      const double mean = std::sqrt(std::abs(c.a22 * c.a44)) + 1e-3;
      // Interpolation of b (0.1 % of its peak) and of a: half a percent of the largest.
      EXPECT_NEAR(c.a33 - end.a33, added_mass_by_damping([&at](double u) { return at(u).b33; }, omega),
                  5e-3 * (std::abs(c.a33) + c.b33));
      EXPECT_NEAR(c.a22 - end.a22, added_mass_by_damping([&at](double u) { return at(u).b22; }, omega),
                  5e-3 * (std::abs(c.a22) + c.b22));
      EXPECT_NEAR(c.a44 - end.a44, added_mass_by_damping([&at](double u) { return at(u).b44; }, omega),
                  5e-3 * (mean + c.b44));
      EXPECT_NEAR(c.a24 - end.a24, added_mass_by_damping([&at](double u) { return at(u).b24; }, omega),
                  5e-3 * (mean + std::abs(c.b24)));
    }
  }
}

TEST(SectionTable, RefusesWhatLiesOutside) {
  EXPECT_EQ(section_table_column(0.049, 0.8).error(), Error::kOutOfRange);
  EXPECT_EQ(section_table_column(10.1, 0.8).error(), Error::kOutOfRange);
  EXPECT_EQ(section_table_column(1.0, 0.29).error(), Error::kOutOfRange);   // re-entrant below 0.2945
  EXPECT_EQ(section_table_column(1.0, 1.179).error(), Error::kOutOfRange);  // no Lewis form above 1.1781
  EXPECT_EQ(section_table_column(1.0, std::numeric_limits<double>::quiet_NaN()).error(), Error::kNotFinite);
  EXPECT_TRUE(section_table_column(1.0, reentrant_limit(1.0)).ok());
  EXPECT_TRUE(section_table_column(1.0, upper_limit(1.0)).ok());
}

}  // namespace
}  // namespace quickstrip
