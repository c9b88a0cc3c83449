#include "core/hull/lewis_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/constants.hpp"
#include "core/strip/section_table.hpp"

namespace quickstrip {
namespace {

constexpr double kRounding = 1e-12;

double contour_area(const LewisSection& section) {
  // Periodic in theta: the midpoint rule is exact to rounding for the five harmonics of y dz.
  constexpr int kPoints = 64;
  double area = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double step = 0.5 * kPi / kPoints;
    const ContourPoint from = contour_point(section, i * step);
    const ContourPoint to = contour_point(section, (i + 1) * step);
    area += (from.y + to.y) * (to.z - from.z);
  }
  return area;
}

TEST(LewisSection, ContourHasTheBreadthDraughtAndAreaThatWereAsked) {
  for (const double h0 : {0.06, 0.4, 1.0, 2.5, 9.0}) {
    for (const double sigma : {0.62, 0.8, 0.95, 1.05}) {
      const LewisSection s = *lewis_section(2.0 * h0 * 7.0, 7.0, sigma * 2.0 * h0 * 49.0);
      EXPECT_NEAR(contour_point(s, 0.5 * kPi).y, h0 * 7.0, 1e-10);
      EXPECT_NEAR(contour_point(s, 0.5 * kPi).z, 0.0, 1e-10);
      EXPECT_NEAR(contour_point(s, 0.0).z, -7.0, 1e-10);
      // Trapezoidal chords of 64 steps: relative 1e-3.
      EXPECT_NEAR(contour_area(s), s.area, 2e-3 * s.area) << h0 << " " << sigma;
    }
  }
}

TEST(LewisSection, HalfImmersedCircleHasNoCoefficients) {
  const LewisSection s = *lewis_section(2.0, 1.0, 0.5 * kPi);
  EXPECT_NEAR(s.a1, 0.0, kRounding);
  EXPECT_NEAR(s.a3, 0.0, kRounding);
  EXPECT_NEAR(s.scale, 1.0, kRounding);
  EXPECT_EQ(s.lewis_class, LewisClass::kConventional);
}

TEST(LewisSection, BoundsAreWhereTheContourChanges) {
  for (const double h0 : {0.3, 1.0, 2.0}) {
    // a3 at the bounds: (1-|a1|)/3, -(1-|a1|)/9 and -1/3.
    const auto at = [h0](double sigma) { return *lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma); };
    const LewisSection low = at(reentrant_limit(h0));
    EXPECT_NEAR(low.a3, (1.0 - std::abs(low.a1)) / 3.0, 1e-12);
    const LewisSection middle = at(conventional_limit(h0));
    EXPECT_NEAR(middle.a3, -(1.0 - std::abs(middle.a1)) / 9.0, 1e-12);
    // The square root vanishes here: rounding of sigma shows as its root.
    EXPECT_NEAR(at(upper_limit(h0) * (1.0 - 1e-15)).a3, -1.0 / 3.0, 1e-6);
  }
}

TEST(LewisSection, ClassesAreOrderedByFullness) {
  const auto class_of = [](double h0, double sigma) {
    return lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma)->lewis_class;
  };
  EXPECT_EQ(class_of(0.5, 0.40), LewisClass::kReentrant);
  EXPECT_EQ(class_of(0.5, 0.80), LewisClass::kConventional);
  EXPECT_EQ(class_of(0.5, 0.95), LewisClass::kBulbous);
  EXPECT_EQ(class_of(0.5, 1.10), LewisClass::kBulbousAndTunnelled);
  EXPECT_EQ(class_of(2.0, 0.95), LewisClass::kTunnelled);
  // The S-175's midship: fuller than the conventional forms, and used as it is.
  EXPECT_EQ(class_of(1.337, 0.968), LewisClass::kTunnelled);
}

TEST(LewisSection, RefusesWhatHasNoForm) {
  EXPECT_EQ(lewis_section(2.0, 1.0, 3.0).error(), Error::kOutOfRange);  // sigma 1.5 at H0 1
  EXPECT_EQ(lewis_section(0.0, 1.0, 1.0).error(), Error::kOutOfRange);
  EXPECT_EQ(lewis_section(1.0, -1.0, 1.0).error(), Error::kOutOfRange);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(lewis_section(1.0, nan, 1.0).error(), Error::kNotFinite);
  EXPECT_EQ(hydrodynamic_lewis_section(1.0, 1.0, nan).error(), Error::kNotFinite);
  EXPECT_EQ(hydrodynamic_lewis_section(1.0, 1.0, 0.0).error(), Error::kOutOfRange);
}

TEST(HydrodynamicSection, KeepsAUsableSectionAsItIs) {
  const LewisSection s = *hydrodynamic_lewis_section(25.4, 9.5, 0.968 * 25.4 * 9.5);
  EXPECT_FALSE(s.replaced);
  EXPECT_DOUBLE_EQ(s.breadth, 25.4);
}

TEST(HydrodynamicSection, RaisesAReentrantSkegToItsLimit) {
  // S-175, x = 8.75 m: sigma 0.274 under a limit of 0.451.
  const double h0 = 0.47;
  const LewisSection s = *hydrodynamic_lewis_section(2.0 * h0 * 9.0, 9.0, 0.274 * 2.0 * h0 * 81.0);
  EXPECT_TRUE(s.replaced);
  EXPECT_FALSE(s.extrapolated);
  EXPECT_DOUBLE_EQ(s.draught, 9.0);
  EXPECT_DOUBLE_EQ(s.breadth, 2.0 * h0 * 9.0);
  EXPECT_NEAR(s.sigma, reentrant_limit(h0), 1e-4);
  EXPECT_NEAR(s.area, s.sigma * s.breadth * s.draught, 1e-10);
}

TEST(HydrodynamicSection, ABulbKeepsDraughtAndArea) {
  // S-175, x = 175 m: sigma 8.6 at H0 0.009.
  const double breadth = 2.0 * 0.009 * 9.5;
  const double area = 8.6 * breadth * 9.5;
  const LewisSection s = *hydrodynamic_lewis_section(breadth, 9.5, area);
  EXPECT_TRUE(s.replaced);
  EXPECT_FALSE(s.extrapolated);
  EXPECT_DOUBLE_EQ(s.draught, 9.5);
  EXPECT_NEAR(s.area, area, 1e-9);
  EXPECT_NEAR(s.sigma, 0.9, 1e-12);
  EXPECT_TRUE(hydrodynamic_lewis_section(0.0, 9.5, area)->replaced);  // wholly submerged at the waterline
}

TEST(HydrodynamicSection, ExtrapolatesAThinPlateByItsDraughtAndAPontoonByItsBreadth) {
  const LewisSection plate = *hydrodynamic_lewis_section(0.02, 6.0, 0.1);
  EXPECT_TRUE(plate.replaced && plate.extrapolated);
  EXPECT_DOUBLE_EQ(plate.draught, 6.0);
  const LewisSection pontoon = *hydrodynamic_lewis_section(20.0, 0.1, 1.9);
  EXPECT_TRUE(pontoon.replaced && pontoon.extrapolated);
  EXPECT_DOUBLE_EQ(pontoon.breadth, 20.0);
}

TEST(HydrodynamicSection, AlwaysLiesInsideTheTable) {
  for (double h0 = 0.001; h0 < 100.0; h0 *= 1.13) {
    for (double sigma = 0.01; sigma < 30.0; sigma *= 1.17) {
      const Result<LewisSection> s = hydrodynamic_lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma);
      ASSERT_TRUE(s.ok());
      EXPECT_TRUE(section_table_column(s->h0, s->sigma).ok()) << h0 << " " << sigma;
    }
  }
}

TEST(HydrodynamicSection, ScalesWithLength) {
  const LewisSection s = *hydrodynamic_lewis_section(3.0, 2.0, 5.0);
  const LewisSection large = *hydrodynamic_lewis_section(30.0, 20.0, 500.0);
  EXPECT_NEAR(large.scale, 10.0 * s.scale, 1e-12 * large.scale);
  EXPECT_NEAR(large.a1, s.a1, kRounding);
}

}  // namespace
}  // namespace quickstrip
