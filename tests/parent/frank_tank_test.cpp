// Frank's method against measurements on cylinders. What it leaves out (viscosity, the tank's finite depth
// and walls, finite motions) is in the tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "sim/parent/frank.hpp"
#include "tests/parent/beam_loads.hpp"
#include "tests/parent/frank_sections.hpp"

namespace quickstrip {
namespace {

struct Measured {
  const char* quantity;
  double omega;  // omega sqrt(B/2g)
  double value;
};

// a/(rho A), b/(rho A) sqrt(B/2g), F2/(rho g k A zeta), F3/(rho g B zeta), F4/(rho g k B^3/12 zeta); B = 2.
double computed(const FrankSection& section, double area, const Measured& point) {
  const double k = point.omega * point.omega;
  const SectionFlow flow = section.flow(k);
  const test::BeamLoads load = test::beam_loads(flow);
  const std::map<std::string, double> all = {
      {"a22", flow.a22 / area},
      {"b22", flow.h2 * flow.h2 * point.omega / area},
      {"a33", flow.a33 / area},
      {"b33", flow.h3 * flow.h3 * point.omega / area},
      {"F2", std::abs(load.sway) / (k * area)},
      {"F3", std::abs(load.heave) / 2.0},
      {"F4", std::abs(load.roll) / (k * 8.0 / 12.0)},
  };
  return all.at(point.quantity);
}

// Of the largest value of each curve. The tank's scatter is 3 ... 10 %, its depth about 2 m; the median says
// how good the theory is, the largest how good the worst point of the tank.
void expect_near_the_tank(const SectionContour& contour, const std::vector<Measured>& points) {
  const FrankSection section(contour);
  std::map<std::string, double> largest;
  for (const Measured& p : points) {
    largest[p.quantity] = std::max(largest[p.quantity], p.value);
  }
  std::vector<double> errors;
  for (const Measured& p : points) {
    const double ours = computed(section, area(contour), p);
    errors.push_back(std::fabs(ours - p.value) / largest[p.quantity]);
    EXPECT_LT(errors.back(), 0.17) << p.quantity << " at " << p.omega << ": " << ours << " for " << p.value;
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.06);
}

// [Vugts1968], read from the figures of [Journee2001b]; three points a curve.
TEST(FrankTank, SemicircleIsNearVugtsMeasurements) {
  expect_near_the_tank(test::semicircle(1.0, 400), {{"a22", 0.389, 1.173},
                                                    {"a22", 0.811, 0.756},
                                                    {"a22", 1.247, 0.280},
                                                    {"b22", 0.382, 0.045},
                                                    {"b22", 0.811, 0.787},
                                                    {"b22", 1.247, 0.736},
                                                    {"a33", 0.424, 1.053},
                                                    {"a33", 0.797, 0.609},
                                                    {"a33", 1.170, 0.669},
                                                    {"b33", 0.424, 0.544},
                                                    {"b33", 0.797, 0.502},
                                                    {"b33", 1.177, 0.293},
                                                    {"F2", 0.393, 2.036},
                                                    {"F2", 0.559, 1.798},
                                                    {"F2", 0.973, 0.560},
                                                    {"F3", 0.393, 0.732},
                                                    {"F3", 0.559, 0.637},
                                                    {"F3", 0.966, 0.309}});
}

TEST(FrankTank, RectangleIsNearVugtsMeasurements) {
  expect_near_the_tank(
      test::rectangle(1.0, 1.0),
      {{"a22", 0.355, 1.505}, {"a22", 0.787, 0.544}, {"a22", 1.219, 0.124}, {"b22", 0.355, 0.042},
       {"b22", 0.787, 1.077}, {"b22", 1.219, 0.804}, {"a33", 0.494, 0.813}, {"a33", 0.787, 0.801},
       {"a33", 1.184, 1.065}, {"b33", 0.431, 0.390}, {"b33", 0.717, 0.294}, {"b33", 1.010, 0.142},
       {"F2", 0.462, 2.298},  {"F2", 0.642, 1.869},  {"F2", 1.124, 0.369},  {"F3", 0.450, 0.653},
       {"F3", 0.643, 0.509},  {"F3", 1.120, 0.129},  {"F4", 0.462, 1.962},  {"F4", 0.793, 1.026},
       {"F4", 1.124, 0.415}});
}

// Rectangle with rounded bilges, B 0.400, draught 0.200, bilge radius 0.0512 m, fixed in beam waves
// ([Sundsdal2025], amplitudes reduced from the raw records, repeatable to 0.3 %).
SectionContour ntnu_section() {
  constexpr double radius = 0.0512;
  SectionContour contour{{{0.0, -0.2}}};
  for (int i = 0; i <= 30; ++i) {
    const double t = 0.5 * kPi * i / 30;
    contour.points.push_back({0.2 - radius + radius * std::sin(t), -0.2 + radius - radius * std::cos(t)});
  }
  contour.points.push_back({0.2, 0.0});
  return contour;
}

TEST(FrankTank, LoadsOnTheNtnuSectionInBeamWavesAreMet) {
  struct Loads {
    double xi;
    double sway;   // F2/(rho g zeta k B d)
    double heave;  // F3/(rho g zeta B)
  };
  const FrankSection section(ntnu_section());
  for (const Loads& tank : {Loads{0.5, 1.594, 0.498}, Loads{0.65, 1.168, 0.396}, Loads{0.75, 0.970, 0.351},
                            Loads{1.0, 0.637, 0.259}, Loads{1.25, 0.458, 0.199}}) {
    const double k = tank.xi / 0.2;
    const test::BeamLoads load = test::beam_loads(section.flow(k));
    // Sway within 2 %. Heave is 3 ... 9 % low throughout: gaps of 7 mm at the model's ends and their flow are
    // not in the theory.
    EXPECT_NEAR(std::abs(load.sway) / (k * 0.4 * 0.2), tank.sway, 0.025 * tank.sway) << tank.xi;
    EXPECT_NEAR(std::abs(load.heave) / 0.4, tank.heave, 0.09 * tank.heave) << tank.xi;
  }
}

}  // namespace
}  // namespace quickstrip
