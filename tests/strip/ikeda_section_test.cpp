// Ikeda's formulas for one section against what they come from: the double body's flow, the pressure along
// the girth, the energy of a period; and against cylinders measured in 1978.
#include "core/strip/ikeda_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/base/constants.hpp"
#include "core/hull/lewis_section.hpp"

namespace quickstrip {
namespace {

// C_R with the polynomials A0, B0 as printed, written independently of core (formulas §5); unclipped.
double printed_eddy_coefficient(double h0, double sigma, double og, double bilge_radius) {
  const LewisSection form = *lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma);  // d = 1
  const double a1 = form.a1;
  const double a3 = form.a3;
  const double m = form.breadth / (2.0 * (1.0 + a1 + a3));
  const auto r_at = [&](double p) {
    const double y = (1.0 + a1) * std::sin(p) - a3 * std::sin(3.0 * p);
    const double z = (1.0 - a1) * std::cos(p) + a3 * std::cos(3.0 * p);
    return m * std::sqrt(y * y + z * z);
  };
  const double q = a1 * (1.0 + a3) / (4.0 * a3);
  double psi = 0.0;
  if (std::fabs(q) <= 1.0 && r_at(0.5 * std::acos(q)) > r_at(0.0)) {
    psi = 0.5 * std::acos(q);
  }
  const double h = 1.0 + a1 * a1 + 9.0 * a3 * a3 + 2.0 * a1 * (1.0 - 3.0 * a3) * std::cos(2.0 * psi) -
                   6.0 * a3 * std::cos(4.0 * psi);
  const double a0 = -2.0 * a3 * std::cos(5.0 * psi) + a1 * (1.0 - a3) * std::cos(3.0 * psi) +
                    ((6.0 - 3.0 * a1) * a3 * a3 + (a1 * a1 - 3.0 * a1) * a3 + a1 * a1) * std::cos(psi);
  const double b0 = -2.0 * a3 * std::sin(5.0 * psi) + a1 * (1.0 - a3) * std::sin(3.0 * psi) +
                    ((6.0 + 3.0 * a1) * a3 * a3 + (3.0 * a1 + a1 * a1) * a3 + a1 * a1) * std::sin(psi);
  const double f1 = 0.5 * (1.0 + std::tanh(20.0 * (sigma - 0.7)));
  const double f2 = 0.5 * (1.0 - std::cos(kPi * sigma)) -
                    1.5 * (1.0 - std::exp(-5.0 * (1.0 - sigma))) * std::pow(std::sin(kPi * sigma), 2);
  const double f3 = 1.0 + 4.0 * std::exp(-1.65e5 * std::pow(1.0 - sigma, 2));
  const double h0p = h0 / (1.0 - og);
  const double sigp = (sigma - og) / (1.0 - og);
  const double gamma = std::sqrt(kPi) * f3 / (2.0 * (1.0 - og) * std::sqrt(h0p * sigp)) *
                       (r_at(psi) + 2.0 * m / h * std::sqrt(a0 * a0 + b0 * b0));
  const double cp = 0.5 * (0.87 * std::exp(-gamma) - 4.0 * std::exp(-0.187 * gamma) + 3.0);
  return std::pow(r_at(psi), 2) *
         ((1.0 - f1 * bilge_radius) * (1.0 - og - f1 * bilge_radius) +
          f2 * std::pow(h0 - f1 * bilge_radius, 2)) *
         cp;
}

IkedaSection cylinder(double h0, double sigma, double og = 0.0, double greatest_sigma = 1.0) {
  return ikeda_section(2.0 * h0, 1.0, 2.0 * h0 * sigma, og, greatest_sigma);
}

TEST(IkedaSection, VelocityOfTheDoubleBodyIsThePrintedPolynomials) {
  int compared = 0;
  for (const double h0 : {0.3, 0.6, 0.9, 1.1, 1.34, 2.0}) {
    for (const double sigma : {0.55, 0.7, 0.8, 0.9, 0.95, 0.98, 0.995, 1.0}) {
      for (const double og : {-0.8, -0.2, 0.0, 0.15}) {
        const IkedaSection section = cylinder(h0, sigma, og);
        if (section.brought_into_range) {
          continue;  // re-entrant
        }
        const double printed = printed_eddy_coefficient(h0, sigma, og, section.bilge_radius);
        // An identity: rounding, in sums of terms of order 1.
        EXPECT_NEAR(eddy_coefficient(section), std::max(0.0, printed), 1e-12)
            << h0 << ' ' << sigma << ' ' << og;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 150);
}

// Measured by Ikeda, Himeno and Tanaka on two-dimensional cylinders with draught d, OG = 0, at one amplitude
// (rad) and omega-hat; C_R from the measured damping less that of waves and friction. Source: figures of
// [Ikeda1978], digitised. H and I ... L: ship-like sections, A ... D: rectangles with ever rounder bilges.
struct Cylinder {
  char name;
  double h0;
  double sigma;
  double omega_hat;
  double measured;
};
constexpr std::array<Cylinder, 16> kCylinders = {{{'A', 1.25, 1.000, 0.751, 6.791},
                                                  {'A', 1.25, 1.000, 0.507, 7.298},
                                                  {'B', 1.25, 0.997, 0.751, 2.862},
                                                  {'B', 1.25, 0.997, 0.536, 2.582},
                                                  {'C', 1.25, 0.995, 0.751, 0.943},
                                                  {'C', 1.25, 0.995, 0.625, 0.944},
                                                  {'D', 1.25, 0.988, 0.939, 0.791},
                                                  {'D', 1.25, 0.988, 0.751, 0.814},
                                                  {'G', 0.4818, 0.799, 0.814, 0.0861},
                                                  {'H', 1.0311, 0.893, 0.560, 0.0597},
                                                  {'H', 1.0311, 0.893, 0.889, 0.0661},
                                                  {'I', 1.2344, 0.977, 0.580, 0.358},
                                                  {'I', 1.2344, 0.977, 0.861, 0.266},
                                                  {'J', 0.8932, 0.593, 1.030, 0.136},
                                                  {'K', 0.772, 0.541, 0.780, 0.293},
                                                  {'L', 0.5243, 0.430, 0.551, 0.928}}};

TEST(IkedaSection, EddiesOfThirteenOfSixteenCylindersOf1978AreMetWithinAQuarterAndTheMissesArePrinted) {
  std::printf(
      "cylinder   H0     sigma  omega-hat  measured C_R   ours   ours/measured   as a ship's section\n");
  int within_a_quarter = 0;
  int within_half = 0;
  double log_error = 0.0;
  for (const Cylinder& c : kCylinders) {
    const double ours = eddy_coefficient(cylinder(c.h0, c.sigma));
    const double clipped = eddy_coefficient(cylinder(c.h0, c.sigma, 0.0, kGreatestIkedaSigma));
    const double ratio = ours / c.measured;
    std::printf("    %c     %6.4f  %5.3f    %5.3f      %8.4f    %8.4f     %5.2f%s        %8.4f\n", c.name,
                c.h0, c.sigma, c.omega_hat, c.measured, ours, ratio,
                std::fabs(ratio - 1.0) > 0.25 ? "  MISS" : "      ", clipped);
    within_a_quarter += ratio > 0.75 && ratio < 1.25 ? 1 : 0;
    within_half += ratio > 0.5 && ratio < 1.5 ? 1 : 0;
    log_error += std::log(ratio) / static_cast<double>(kCylinders.size());
  }
  std::printf("within a quarter: %d of 16, within a half: %d of 16, mean ratio %.2f\n", within_a_quarter,
              within_half, std::exp(log_error));
  // The misses: H, slack and near zero (C_R 0.06, what is left of measured damping when that of waves, twice
  // as large, is taken off), of which we have a quarter; and I at the higher frequency, where the formula,
  // which knows no frequency, is half as much again.
  EXPECT_EQ(within_a_quarter, 13);
  EXPECT_EQ(within_half, 13);
  EXPECT_NEAR(std::exp(log_error), 0.86, 0.02);  // as measured here; all but H: 1.04
}

// The moment about G of a unit pressure along the girth from the keel, by a fine quadrature over the section
// with a straight bottom, a quarter circle and a straight side. `share`(s): pressure at girth s from the
// keel, towards the waterline on one side of the ship, towards the centre plane on the other.
template <typename Share>
double girth_moment(const IkedaSection& section, Share&& share_to_waterline, Share&& share_to_centre) {
  const double radius = section.bilge_radius;
  const double side = section.draught - radius;          // vertical
  const double bottom = 0.5 * section.breadth - radius;  // horizontal
  // Centre of the arc: from G, `bottom` outwards and `below` down.
  const double below = section.draught - radius - section.og_down;
  constexpr int kSteps = 200'000;
  double sum = 0.0;
  // The side's horizontal force turns the ship by its depth, the bottom's vertical force the other way by its
  // distance; the keels of both sides push alike, so each counts once. Normal at angle alpha from horizontal.
  const double arc = 0.25 * kPi * radius;
  const auto add = [&](double length, auto&& share, bool to_waterline) {
    for (int i = 0; i < kSteps; ++i) {
      const double s = (i + 0.5) * length / kSteps;
      const double ds = length / kSteps;
      if (s < arc) {
        const double alpha = to_waterline ? 0.25 * kPi - s / radius : 0.25 * kPi + s / radius;
        const double turn = below * std::cos(alpha) - bottom * std::sin(alpha);
        sum += share(s) * (to_waterline ? turn : -turn) * ds;
      } else {
        sum += share(s) * ((to_waterline ? below : bottom) - (s - arc)) * ds;
      }
    }
  };
  add(arc + side, share_to_waterline, true);
  add(arc + bottom, share_to_centre, false);
  return sum / (section.draught * section.draught);
}

TEST(IkedaSection, MomentOfAFallingPressureIsItsIntegralAlongTheGirth) {
  for (const double h0 : {0.9, 1.34, 1.8}) {
    for (const double sigma : {0.85, 0.93, 0.97}) {
      for (const double og : {-0.4, 0.0, 0.15}) {
        const IkedaSection s = cylinder(h0, sigma, og);
        const double to_waterline = s.draught - 0.215 * s.bilge_radius;
        const double to_centre = 0.5 * s.breadth - 0.215 * s.bilge_radius;
        const auto share = [](double girth) {
          return [girth](double at) { return std::max(0.0, 1.0 - at / girth); };
        };
        const double integral = girth_moment(s, share(to_waterline), share(to_centre));
        // The printed constants have two to four digits: .0652 for .0651, .3816 for .382.
        EXPECT_NEAR(falling_pressure_moment(s), integral, 2e-3) << h0 << ' ' << sigma << ' ' << og;
      }
    }
  }
}

TEST(IkedaSection, MomentOfAUniformPressureIsItsIntegralAlongTheGirth) {
  for (const double h0 : {0.9, 1.34, 1.8}) {
    for (const double sigma : {0.85, 0.93, 0.97}) {
      for (const double length : {0.05, 0.15, 0.3, 0.45}) {
        const IkedaSection s = cylinder(h0, sigma, -0.1);
        const auto share = [length](double at) { return at < length ? 1.0 : 0.0; };
        const double integral = girth_moment(s, share, share);
        const double straight = length - 0.25 * kPi * s.bilge_radius;
        if (straight < std::min(1.0 - s.bilge_radius, h0 - s.bilge_radius)) {
          // Exact but for the quadrature's step at the end of the pressure, 1e-5.
          EXPECT_NEAR(uniform_pressure_moment(s, length), integral, 2e-5)
              << h0 << ' ' << sigma << ' ' << length;
        }
      }
    }
  }
}

TEST(IkedaSection, BilgeRadiusTakesFromTheRectangleWhatTheAreaLacks) {
  const double radius = ikeda_bilge_radius(25.4, 9.5, 0.966);
  // Two quarter circles in their squares: 2 R^2 (1 - pi/4).
  EXPECT_NEAR(2.0 * radius * radius * (1.0 - 0.25 * kPi), (1.0 - 0.966) * 25.4 * 9.5, 1e-9);
  EXPECT_DOUBLE_EQ(ikeda_bilge_radius(4.0, 9.5, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(ikeda_bilge_radius(40.0, 3.0, 0.3), 3.0);
}

TEST(IkedaSection, LinearEquivalentTakesTheEnergyOfTheQuadraticMomentOverAPeriod) {
  const IkedaSection section = cylinder(1.3, 0.95);
  constexpr double kAmplitude = 0.2;
  constexpr double kOmega = 0.7;
  const double of_rate_squared = 0.5 * 1025.0 * eddy_coefficient(section);  // d = 1
  double energy = 0.0;
  constexpr int kSteps = 20'000;
  for (int i = 0; i < kSteps; ++i) {
    const double rate = kOmega * kAmplitude * std::cos(kTwoPi * (i + 0.5) / kSteps);
    energy += of_rate_squared * std::fabs(rate) * rate * rate * kTwoPi / kOmega / kSteps;
  }
  const double linear = eddy_damping(section, 1025.0) * kOmega * kAmplitude;
  EXPECT_NEAR(linear * kPi * kOmega * kAmplitude * kAmplitude, energy, 1e-6 * energy);  // quadrature
}

TEST(IkedaSection, ShipsSectionsAreBroughtIntoTheRangeOfTheFormulas) {
  const IkedaSection full = ikeda_section(25.0, 10.0, 249.9, 0.0);
  EXPECT_DOUBLE_EQ(full.sigma, kGreatestIkedaSigma);
  EXPECT_TRUE(full.brought_into_range);
  const IkedaSection bulb = ikeda_section(0.21, 9.37, 13.9, 0.0);  // S-175, forward perpendicular
  EXPECT_DOUBLE_EQ(bulb.sigma, kGreatestIkedaSigma);
  EXPECT_DOUBLE_EQ(bulb.breadth, 0.21);
  const IkedaSection submerged = ikeda_section(0.0, 8.0, 10.0, 0.0);
  EXPECT_TRUE(std::isfinite(eddy_coefficient(submerged)));
  const IkedaSection skeg = ikeda_section(8.92, 9.5, 23.4, 0.0);  // re-entrant
  EXPECT_GT(skeg.sigma, 23.4 / (8.92 * 9.5));
  EXPECT_TRUE(skeg.brought_into_range);
  const IkedaSection midship = ikeda_section(25.4, 9.5, 233.15, 0.02);
  EXPECT_FALSE(midship.brought_into_range);
}

TEST(IkedaSection, ShallowSlackSectionsShedNoEddiesWhereTheFormulaGoesBelowZero) {
  EXPECT_LT(printed_eddy_coefficient(2.36, 0.572, -0.02, 1.0), 0.0);
  EXPECT_EQ(eddy_coefficient(cylinder(2.36, 0.572, -0.02)), 0.0);
}

}  // namespace
}  // namespace quickstrip
