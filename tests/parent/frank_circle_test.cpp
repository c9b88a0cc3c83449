// Frank's method on circles, half immersed and wholly, and on ellipses: analytic figures and closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "sim/parent/frank.hpp"
#include "tests/parent/beam_loads.hpp"
#include "tests/parent/frank_sections.hpp"

namespace quickstrip {
namespace {

struct CirclePoint {
  double xi;
  double added_mass;  // by rho pi a^2/2
  double damping;     // by rho pi a^2/2 sqrt(g/a)
};

void expect_circle(const FrankSection& section, double radius, const CirclePoint& point, double tolerance) {
  const double mass = 0.5 * kPi * radius * radius;
  const SectionFlow flow = section.flow(point.xi / radius);
  EXPECT_TRUE(flow.is_converged);
  EXPECT_NEAR(flow.a33 / mass, point.added_mass, tolerance * point.added_mass) << point.xi;
  const double damping = flow.h3 * flow.h3 / mass * std::sqrt(point.xi);
  EXPECT_NEAR(damping, point.damping, tolerance * point.damping) << point.xi;
}

TEST(FrankCircle, InHeaveAgreesWithUrsellToATenThousandth) {
  // Ursell 1949 [Ursell1949], analytic, at omega sqrt(a/g) = 0.1, 0.2, 0.3317, 0.5. Above that the figures'
  // damping departs from the boundary elements of the next test (0.05 % at xi 1) and from our multipoles.
  const FrankSection section(test::semicircle(3.0, 800));
  for (const CirclePoint& point : {CirclePoint{0.01, 3.261830252455801, 0.23799133907015363},
                                   CirclePoint{0.04, 2.0995294159147853, 0.41761357351110917},
                                   CirclePoint{0.11, 1.3451657501410692, 0.5605599189307281},
                                   CirclePoint{0.25, 0.8780067537500554, 0.6223970141244173}}) {
    expect_circle(section, 3.0, point, 1e-4);
  }
}

TEST(FrankCircle, InHeaveWithMorePanelsAgreesWithBoundaryElements) {
  // tests/golden/lewis_reference.csv; 1e-4 but at xi 4, where the damping is 5 % of the added mass.
  const FrankSection section(test::semicircle(3.0, 800), {.num_panels = 112});
  for (const CirclePoint& point :
       {CirclePoint{0.02, 2.67320232, 0.320312097}, CirclePoint{0.1, 1.40950378, 0.548679028},
        CirclePoint{0.5, 0.644629929, 0.573811456}, CirclePoint{1.0, 0.604975839, 0.396343697},
        CirclePoint{2.0, 0.726581791, 0.170778664}}) {
    expect_circle(section, 3.0, point, 1e-4);
  }
  expect_circle(section, 3.0, {4.0, 0.863915110, 0.0413374815}, 3e-4);
}

TEST(FrankCircle, DoesNotRollTheWater) {
  const FrankSection section(test::semicircle(2.0, 800));
  for (const double k : {0.05, 0.5, 2.0}) {
    const SectionFlow flow = section.flow(k);
    // The panels are chords: a polygon of 56 sides does, by 1e-4 of the least figure that could matter.
    EXPECT_NEAR(flow.a24 / (2.0 * flow.a22), 0.0, 1e-4);
    EXPECT_NEAR(flow.a44 / (4.0 * flow.a22), 0.0, 1e-4);
    EXPECT_NEAR(flow.h4 / (2.0 * flow.h2), 0.0, 1e-4);
  }
}

TEST(FrankCircle, SubmergedIsTheSameInHeaveAndSwayAtEveryFrequency) {
  for (const double depth : {1.1, 1.5, 4.0}) {
    const FrankSection section(test::submerged_ellipse(1.0, 1.0, depth, 800));
    for (const double k : {0.01, 0.2, 0.8, 2.0, 6.0}) {
      const SectionFlow flow = section.flow(k);
      EXPECT_TRUE(flow.is_converged);
      EXPECT_NEAR(flow.a22, flow.a33, 1e-4 * kPi);
      EXPECT_NEAR(flow.h2, flow.h3, 1e-4 * kPi);
      // turns about its own centre without moving the water: 24 and 44 are those of the centre's sway
      EXPECT_NEAR(flow.a24, depth * flow.a22, 1e-4 * kPi * depth);
      EXPECT_NEAR(flow.a44, depth * depth * flow.a22, 1e-4 * kPi * depth * depth);
    }
  }
}

TEST(FrankCircle, SubmergedSendsWavesToOneSideWhenItsCentreMovesInACircle) {
  // Ursell 1950, Ogilvie 1963 ([Ogilvie1963]): sway and heave radiate waves of one amplitude a quarter period
  // apart to one side and three quarters to the other. By Haskind the loads of a beam wave show the same.
  const FrankSection section(test::submerged_ellipse(1.0, 1.0, 1.5, 800));
  for (const double k : {0.01, 0.2, 0.8, 2.0}) {
    const test::BeamLoads load = test::beam_loads(section.flow(k));
    EXPECT_NEAR(std::abs(load.heave / load.sway - std::complex<double>(0.0, 1.0)), 0.0, 1e-4) << k;
  }
}

// A circle of radius 1, its centre h from a plane: images of its dipole in the plane and in the circle
// ([Lamb1932] §98 for two cylinders); sign +1 for a rigid plane, -1 for one of phi = 0.
double added_mass_by_images(double h, double sign) {
  double total = 1.0;
  double strength = 1.0;
  double offset = 0.0;
  double turns = 1.0;
  for (int n = 0; n < 100; ++n) {
    const double distance = 2.0 * h - offset;
    strength /= distance * distance;
    offset = 1.0 / distance;
    turns *= sign;
    total += 2.0 * turns * strength;
  }
  return kPi * total;
}

TEST(FrankCircle, SubmergedTendsToTheClosedFormsOfSlowAndOfFastMotion) {
  for (const double depth : {1.25, 1.5, 3.0, 30.0}) {
    const FrankSection section(test::submerged_ellipse(1.0, 1.0, depth, 800), {.num_panels = 112});
    const double slow = added_mass_by_images(depth, 1.0);
    const double fast = added_mass_by_images(depth, -1.0);
    // Departs by K h from the former, by 1/(K h) from the latter.
    EXPECT_NEAR(section.flow(1e-5 / depth).a33, slow, 1e-4 * slow) << depth;
    EXPECT_NEAR(section.flow(1e4 / depth).a22, fast, 3e-4 * fast) << depth;
  }
}

TEST(FrankCircle, DeeplySubmergedHasTheMassOfTheWaterItDisplaces) {
  // a -> rho pi a^2 for a circle, rho pi c^2 and rho pi a^2 for an ellipse in sway and heave; 1/(2 h^2) off.
  const SectionFlow circle = FrankSection(test::submerged_ellipse(1.0, 1.0, 100.0, 800)).flow(1.0);
  EXPECT_NEAR(circle.a33, kPi, 2e-4 * kPi);
  const SectionFlow ellipse = FrankSection(test::submerged_ellipse(2.0, 0.8, 200.0, 800)).flow(1.0);
  EXPECT_NEAR(ellipse.a33, 4.0 * kPi, 4e-4 * kPi);
  EXPECT_NEAR(ellipse.a22, 0.64 * kPi, 4e-4 * kPi);
}

}  // namespace
}  // namespace quickstrip
