// The close fit of a contour, and the flow about it: forms whose mapping is known, the S-175's stations, what
// is refused and why, and Frank's method on the contour itself.
#include "sim/parent/close_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/constants.hpp"
#include "msgs/files/hull_file.hpp"
#include "sim/parent/frank.hpp"
#include "sim/parent/true_section.hpp"
#include "tests/sections/golden_sections.hpp"

namespace quickstrip {
namespace {

SectionContour contour_of(const MappingCoefficients& a, double scale, int num_sides) {
  std::vector<Offset> points;
  for (int j = 0; j <= num_sides; ++j) {
    const std::complex<double> w = scale * mapped_point(a, 0.5 * kPi * j / num_sides).w;
    points.push_back({w.imag(), w.real()});
  }
  points.front().y = 0.0;
  points.back().z = 0.0;
  return section_contour(points);
}

std::unique_ptr<ImmersedSections> s175_sections() {
  auto hull = std::make_unique<Hull>();
  auto sections = std::make_unique<ImmersedSections>();
  EXPECT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull));
  EXPECT_TRUE(immerse(*hull, hull->loading, *sections));
  return sections;
}

TEST(CloseFit, FindsTheCoefficientsOfAMappedContour) {
  const std::array<double, 10> given = {0.10,  -0.08, 0.03,   0.012,  -0.008,
                                        0.005, 0.003, -0.002, 0.0015, 0.001};
  for (const std::size_t count : {2U, 3U, 5U, 10U}) {
    MappingCoefficients a;
    for (std::size_t n = 0; n < count; ++n) {
      ASSERT_TRUE(a.push_back(given[n]));
    }
    const CloseFit fit = close_fit(contour_of(a, 7.0, 400), static_cast<int>(count));
    ASSERT_EQ(fit.a.size(), count);
    EXPECT_TRUE(fit.is_conventional) << fit.reason;
    // Sides of 400 lie inside the curve by (pi/800)^2/8 of its radius of curvature, 2e-6.
    EXPECT_NEAR(fit.scale, 7.0, 7e-5);
    for (std::size_t n = 0; n < count; ++n) {
      EXPECT_NEAR(fit.a[n], given[n], 2e-5) << n;
    }
    EXPECT_LT(fit.largest_error, 7e-4);
  }
}

TEST(CloseFit, CircleNeedsNoCoefficients) {
  const CloseFit fit = close_fit(contour_of(MappingCoefficients{}, 3.0, 200));
  EXPECT_EQ(fit.a.size(), 10U);
  for (const double a : fit.a.span()) {
    EXPECT_NEAR(a, 0.0, 2e-5);  // the polygon of 200 sides
  }
  EXPECT_NEAR(fit.area_error, 0.0, 1e-4);
}

TEST(CloseFit, KeepsBreadthAndDraught) {
  const auto sections = s175_sections();
  for (const ImmersedSection& section : *sections) {
    const SectionContour contour = section_contour(section);
    const CloseFit fit = close_fit(contour, 4);
    if (!fit.a.empty()) {
      EXPECT_NEAR(fit.scale * mapped_half_breadth(fit.a), contour.half_breadth(), 1e-9);
      EXPECT_NEAR(fit.scale * mapped_draught(fit.a), contour.draught(), 1e-9);
    }
  }
}

TEST(CloseFit, MeetsTheStationsOfTheS175) {
  int conventional = 0;
  const auto sections = s175_sections();
  for (const ImmersedSection& section : *sections) {
    const SectionContour contour = section_contour(section);
    const CloseFit fit = close_fit(contour);
    EXPECT_EQ(fit.a.size(), 10U) << section.x;
    if (section.x > 174.0) {  // the stem: 0.2 m broad, 9.4 m deep
      EXPECT_EQ(fit.reason, "thinner than a twentieth of its draught");
      continue;
    }
    // Found: 0.1 ... 0.3 % of the section's size, area 0.1 %; bulbs 0.5 ... 0.9 %, 0.5 %.
    const bool has_bulb = section.x > 150.0;
    EXPECT_EQ(fit.reason, has_bulb ? "contour not met" : "") << section.x;
    EXPECT_LT(fit.rms_error, (has_bulb ? 0.010 : 0.004) * error_scale(contour)) << section.x;
    EXPECT_LT(fit.largest_error, (has_bulb ? 0.030 : 0.015) * error_scale(contour)) << section.x;
    EXPECT_LT(std::abs(fit.area_error), has_bulb ? 6e-3 : 1e-3) << section.x;
    conventional += fit.is_conventional ? 1 : 0;
  }
  EXPECT_EQ(conventional, 20);
}

TEST(CloseFit, MoreCoefficientsFitBetter) {
  const SectionContour contour = section_contour((*s175_sections())[6]);
  double before = INFINITY;
  for (const int n : {2, 4, 6, 10}) {
    const double error = close_fit(contour, n).rms_error;
    EXPECT_LT(error, before) << n;
    before = error;
  }
}

TEST(CloseFit, RoundsTheBilgeOfABox) {
  const SectionContour box = section_contour(std::vector<Offset>{{0, -6}, {9, -6}, {9, 0}});
  const CloseFit fit = close_fit(box);
  EXPECT_TRUE(fit.is_conventional) << fit.reason;
  EXPECT_TRUE(is_conformal(fit.a));
  EXPECT_LT(fit.rms_error, 0.005 * error_scale(box));
  EXPECT_GT(fit.largest_error, 0.005 * error_scale(box));  // no knuckle of a finite series
}

TEST(CloseFit, SaysWhyAContourIsNotConventional) {
  const auto reason = [](const std::vector<Offset>& points) {
    const CloseFit fit = close_fit(section_contour(points));
    EXPECT_FALSE(fit.is_conventional);
    return fit.reason;
  };
  EXPECT_EQ(reason({{0, -6}, {2, -4}, {0, -2}}), "wholly submerged");
  EXPECT_EQ(reason({{0, -6}, {0.1, -3}, {0.2, 0}}), "thinner than a twentieth of its draught");
  EXPECT_EQ(reason({{0, -0.2}, {5, -0.15}, {9, 0}}), "draught less than a fortieth of its breadth");
  // A bulb on a neck; a skeg below a flat counter.
  EXPECT_NE(reason({{0, -9}, {2, -8.5}, {3, -7}, {2, -5.5}, {0.3, -5}, {0.6, 0}}), "");
  EXPECT_NE(reason({{0, -9}, {0.5, -9}, {0.6, -2}, {9, -1.6}, {10, 0}}), "");
}

// Relative; 24 and 44 to the 22-44 mean; where a value nearly vanishes, to 1 % of the mean of mass and
// damping.
TEST(CloseFit, FlowOfALewisContourAgreesWithBoundaryElements) {
  for (const int num_coefficients : {2, 10}) {
    for (const test::GoldenSection& row : test::golden_sections()) {
      const bool is_one_of_some = row.xi == 0.1 || row.xi == 0.5 || row.xi == 2.0;
      if (!is_one_of_some) {
        continue;
      }
      const LewisSection lewis = *lewis_section(2.0 * row.h0, 1.0, 2.0 * row.h0 * row.sigma);
      const SectionContour contour = contour_of(lewis_mapping(lewis.a1, lewis.a3), lewis.scale, 400);
      const CloseFit fit = close_fit(contour, num_coefficients);
      ASSERT_TRUE(fit.is_conventional) << row.h0 << " " << row.sigma << ": " << fit.reason;
      const SectionFlow flow = close_fit_flow(fit, row.xi / row.h0);
      const double root = std::sqrt(row.xi);
      const double moment = lewis.area * lewis.breadth;
      const double inertia = moment * lewis.breadth;
      const auto& v = row.values;  // a22 b22 a33 b33 a44 b44 a24 b24
      // 1e-5 of the reference, 2e-5 of the polygon in the contour.
      const auto expect = [&](double value, double golden, double scale) {
        EXPECT_NEAR(value, golden, 3e-4 * scale)
            << "N " << num_coefficients << " H0 " << row.h0 << " sigma " << row.sigma << " xi " << row.xi;
      };
      const double sway = std::abs(v[0]) + v[1] / root;
      const double roll = std::abs(v[4]) + v[5] / root;
      expect(flow.a33 / lewis.area, v[2], v[2]);
      expect(flow.h3 * flow.h3 / lewis.area, v[3] / root, v[3] / root + 0.01 * v[2]);
      expect(flow.a22 / lewis.area, v[0], sway);
      expect(flow.h2 * flow.h2 / lewis.area, v[1] / root, sway);
      const double circle = 1e-3;  // whose roll is nothing but rounding of the reference
      expect(flow.a44 / inertia, v[4], roll + circle);
      expect(flow.h4 * flow.h4 / inertia, v[5] / root, roll + circle);
      expect(flow.a24 / moment, v[6], std::sqrt(sway * (roll + circle)));
      expect(flow.h2 * flow.h4 / moment, v[7] / root, std::sqrt(sway * (roll + circle)));
    }
  }
}

TEST(CloseFit, AgreesWithFranksMethodOnTheS175WithinHalfAPercent) {
  const auto sections = s175_sections();
  for (const ImmersedSection& section : *sections) {
    if (section.x < 5.0 || section.x > 150.0) {
      continue;  // counter, flared at the waterline as no mapping is: a22 to 0.8 %; bulb: to 2 %
    }
    const SectionContour contour = section_contour(section);
    const MappedSection mapped = mapped_section(close_fit(contour));
    const FrankSection frank(contour);
    for (const double omega : {0.3, 0.6, 1.0, 1.4}) {
      const double wave_number = omega * omega / kStandardGravity;
      const SectionFlow a = mapped.flow(wave_number);
      const SectionFlow b = frank.flow(wave_number);
      const auto expect = [&](double x, double y, double tolerance, const char* name) {
        EXPECT_NEAR(x, y, tolerance) << name << " of x " << section.x << " m at " << omega;
      };
      const double sway = std::abs(a.a22) + a.h2 * a.h2;
      expect(a.a33, b.a33, 5e-3 * a.a33, "a33");
      expect(a.h3, b.h3, 5e-3 * std::sqrt(a.a33 + a.h3 * a.h3), "h3");
      expect(a.a22, b.a22, 5e-3 * sway, "a22");
      expect(a.h2, b.h2, 5e-3 * std::sqrt(sway), "h2");
      // Roll of a nearly round section is a small difference, moved by the contour's error (0.3 % at x = 8.75
      // m) twice over.
      const double breadth2 = contour.half_breadth() * contour.half_breadth();
      const double roll = std::abs(a.a44) + a.h4 * a.h4 + 0.02 * sway * breadth2;
      expect(a.a44, b.a44, 1e-2 * roll, "a44");
      expect(a.h4, b.h4, 1e-2 * std::sqrt(roll), "h4");
      expect(a.a24, b.a24, 5e-3 * std::sqrt(sway * roll), "a24");
      // Loads of an oblique wave, at speed of another wave number than the motion's.
      const DiffractionFactors x = diffraction_factors(a, 1.3 * wave_number, 0.7);
      const DiffractionFactors y = diffraction_factors(b, 1.3 * wave_number, 0.7);
      expect(std::abs(x.heave - y.heave), 0.0, 5e-3, "diffraction in heave");
      expect(std::abs(x.sway - y.sway), 0.0, 5e-3, "diffraction in sway");
      expect(std::abs(x.roll_lever - y.roll_lever) / contour.draught(), 0.0, 5e-3, "diffraction in roll");
    }
  }
}

TEST(TrueSection, TakesFranksMethodWhereNoMappingFits) {
  const SectionContour box = section_contour(std::vector<Offset>{{0, -6}, {9, -6}, {9, 0}});
  EXPECT_EQ(TrueSection(box, SectionMethod::kCloseFit).method(), SectionMethod::kCloseFit);
  const SectionContour submerged = section_contour(std::vector<Offset>{{0, -6}, {2, -4}, {0, -2}});
  EXPECT_EQ(TrueSection(submerged, SectionMethod::kCloseFit).method(), SectionMethod::kFrank);
}

}  // namespace
}  // namespace quickstrip
