// Laws that the direct solution must obey whatever the section.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/constants.hpp"
#include "core/hull/lewis_limits.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {
namespace {

struct Form {
  double a1;
  double a3;
};
// Slender, V-shaped, circle, full midship, wide, strongly bulbous, tunnelled.
constexpr std::array<Form, 7> kForms = {
    {{-0.60, 0.02}, {-0.1, 0.25}, {0.0, 0.0}, {0.13, -0.10}, {0.55, 0.03}, {-0.35, -0.30}, {0.30, -0.25}}};

TEST(DirectSolution, TendsToTheClosedFormsAtZeroFrequency) {
  constexpr double kappa = 1e-5;  // departs by about kappa ln kappa, 1e-4
  for (const Form& form : kForms) {
    const SectionSolution s = solve_lewis_form(form.a1, form.a3, kappa, 96);
    const LewisAddedMass lateral = lateral_added_mass_at_zero(form.a1, form.a3);
    const LewisRadiation radiation = low_frequency_radiation(form.a1, form.a3);
    EXPECT_NEAR(s.a22, lateral.a22, 2e-4 * lateral.a22);
    EXPECT_NEAR(s.a24, lateral.a24, 2e-4 * (std::abs(lateral.a24) + 0.1));
    EXPECT_NEAR(s.a44, lateral.a44, 2e-4 * (lateral.a44 + 0.1));
    const double a33 = heave_added_mass_constant(form.a1, form.a3) -
                       radiation.heave * radiation.heave / kPi * (std::log(kappa) + kEulerGamma);
    EXPECT_NEAR(s.a33, a33, 2e-4 * a33);
    EXPECT_NEAR(s.h3, radiation.heave, 2e-4 * radiation.heave);
    EXPECT_NEAR(s.h2 / kappa, radiation.sway, 2e-4 * radiation.sway);
    EXPECT_NEAR(s.h4 / kappa, radiation.roll, 2e-4 * (std::abs(radiation.roll) + 0.1));
  }
}

TEST(DirectSolution, TendsToTheClosedFormsAtInfiniteFrequency) {
  constexpr double kappa = 500.0;  // departs by about 1/kappa, with logarithms: under 1 %
  for (const Form& form : kForms) {
    const SectionSolution s = solve_lewis_form(form.a1, form.a3, kappa, 192);
    const LewisAddedMass lateral = lateral_added_mass_at_infinity(form.a1, form.a3);
    const double a33 = heave_added_mass_at_infinity(form.a1, form.a3);
    EXPECT_NEAR(s.a22, lateral.a22, 0.01 * lateral.a22);
    EXPECT_NEAR(s.a24, lateral.a24, 0.01 * (std::abs(lateral.a24) + 0.1));
    EXPECT_NEAR(s.a44, lateral.a44, 0.01 * (lateral.a44 + 0.1));
    EXPECT_NEAR(s.a33, a33, 0.01 * a33);
  }
}

TEST(DirectSolution, WallSidedSwayRadiatesAsAWaveMakerAtHighFrequency) {
  // Wave amplitude 2 per unit of motion: h2 = 2 / kappa (slowly, with logarithms).
  const SectionSolution circle = solve_lewis_form(0.0, 0.0, 300.0, 192);
  EXPECT_NEAR(circle.h2 * 300.0, 2.0, 0.05);
  // Heave: 4 (1+a1+9a3) / ((1-a1-3a3)^3 kappa^2); 3 % above it at kappa = 40.
  EXPECT_NEAR(circle.h3 * 300.0 * 300.0, 4.0, 0.05);
}

TEST(DirectSolution, FarFieldEnergyEqualsTheDampingByPressure) {
  for (const Form& form : kForms) {
    for (const double kappa : {0.02, 0.3, 1.0, 3.0}) {
      const SectionSolution s = solve_lewis_form(form.a1, form.a3, kappa, 128);
      // The far field converges at the root of the pressure's rate.
      EXPECT_NEAR(s.far_field3 * s.far_field3, s.damping33, 2e-4 * s.damping33 + 1e-6);
      EXPECT_NEAR(s.far_field2 * s.far_field2, s.damping22, 2e-4 * s.damping22 + 1e-6);
      EXPECT_NEAR(s.far_field4 * s.far_field4, s.damping44, 2e-4 * s.damping44 + 1e-6);
    }
  }
}

TEST(DirectSolution, CoupledDampingIsTheProductOfTheAmplitudes) {
  for (const Form& form : kForms) {
    for (const double kappa : {0.05, 0.5, 2.0}) {
      const SectionSolution s = solve_lewis_form(form.a1, form.a3, kappa, 128);
      EXPECT_NEAR(s.damping24 * s.damping24, s.damping22 * s.damping44,
                  1e-4 * s.damping22 * s.damping44 + 1e-9);
      EXPECT_NEAR(s.h2 * s.h4, s.damping24, 1e-4 * std::abs(s.damping24) + 1e-6);
    }
  }
}

TEST(DirectSolution, CircleDoesNotFeelRoll) {
  const SectionSolution s = solve_lewis_form(0.0, 0.0, 0.7, 32);
  EXPECT_NEAR(s.a44, 0.0, 1e-12);
  EXPECT_NEAR(s.a24, 0.0, 1e-12);
  EXPECT_NEAR(s.damping44, 0.0, 1e-12);
}

struct UrsellPoint {
  double frequency;  // omega sqrt(a/g)
  double added_mass;
  double damping;
};
// Ursell 1949, half-immersed circle in heave, digitised: added mass by rho pi a^2/2, damping by the same
// times sqrt(g/a).
constexpr std::array<UrsellPoint, 7> kUrsell = {
    {{0.33166247903554, 1.3451657501410692, 0.5605599189307281},
     {0.5, 0.8780067537500554, 0.6223970141244173},
     {0.7141428428542852, 0.6407035282336531, 0.5705932728070329},
     {0.8717797887081347, 0.596456336660788, 0.48064919028934816},
     {1.0049875621120892, 0.6058732194173051, 0.39326738550867457},
     {1.2288205727444508, 0.66622460274881, 0.25735051961080835},
     {1.4177446878757827, 0.7276109569752914, 0.1698904910730435}}};

TEST(DirectSolution, CircleInHeaveAgreesWithUrsell) {
  const LewisSection circle = *lewis_section(2.0, 1.0, 0.5 * kPi);
  for (const UrsellPoint& point : kUrsell) {
    const double xi = point.frequency * point.frequency;
    const SectionCoefficients c = solve_section(circle, xi);
    // The figures are given as analytic; 0.5 % covers their digitisation.
    EXPECT_NEAR(c.a33, point.added_mass, 0.005 * point.added_mass) << point.frequency;
    EXPECT_NEAR(c.b33, point.damping, 0.005 * point.damping) << point.frequency;
  }
}

TEST(DirectSolution, NormalisedValuesDoNotDependOnSize) {
  const LewisSection small = *lewis_section(1.0, 0.4, 0.3);
  const LewisSection large = *lewis_section(25.0, 10.0, 0.3 * 625.0);
  const SectionCoefficients a = solve_section(small, 0.6, 32);
  const SectionCoefficients b = solve_section(large, 0.6, 32);
  EXPECT_NEAR(a.a24, b.a24, 1e-12);
  EXPECT_NEAR(a.b44, b.b44, 1e-12);
  EXPECT_NEAR(a.a33, b.a33, 1e-12);
}

TEST(DirectSolution, AdaptiveFormSaysHowManyMultipolesItTook) {
  EXPECT_LE(solve_lewis_form_adaptive(0.0, 0.0, 0.5).num_multipoles, 48);
  // Slender and bulbous: far more; two unconverged answers at 24 are 0.7 away from the truth.
  const LewisSection s = *lewis_section(0.2, 1.0, 1.83 * 0.2);
  const SectionSolution slender = solve_lewis_form_adaptive(s.a1, s.a3, kappa_of_xi(s, 0.1));
  EXPECT_GE(slender.num_multipoles, 96);
  EXPECT_NEAR(normalised(s, 0.1, slender).a22, -0.0814, 1e-3);  // boundary elements give -0.0814
}

}  // namespace
}  // namespace quickstrip
