// What single precision costs where it is held (core/base/held.hpp, profile m7): the S-175's coefficients,
// contours and sectional waves rounded so, her motions against those of doubles.
#include "core/base/held.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/base/angles.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

template <typename Values>
void round_all(Values& values) {
  for (double& value : values) {
    value = Single(value);
  }
}

std::unique_ptr<LoadedHull> loaded() {
  const auto hull = std::make_unique<Hull>(test::s175());
  auto out = std::make_unique<LoadedHull>();
  EXPECT_TRUE(load(*hull, hull->loading, StripMethod{}, *out).ok());
  return out;
}

std::unique_ptr<LoadedHull> rounded(const LoadedHull& exact) {
  auto out = std::make_unique<LoadedHull>(exact);
  for (HeldHydrodynamics& node : out->node) {
    std::for_each(node.begin(), node.end(), [](auto& values) { round_all(values); });
  }
  for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
    length_integrals(*out, out->node[n], out->node_integrals[n]);
  }
  for (std::size_t i = 0; i < out->num_sections; ++i) {
    for (auto* values : {&out->wave_contour[i].z, &out->wave_contour[i].y, &out->wave_contour[i].weight}) {
      round_all(*values);
    }
  }
  return out;
}

MotionTransfer moved(const LoadedHull& hull, double omega, EncounterAngle mu, bool is_rounded) {
  SectionDiffraction diffraction;
  const bool has_diffraction = section_diffraction(hull, omega, mu, diffraction);
  SectionWaves sections;
  section_waves(hull, omega, mu, sections);
  if (is_rounded) {
    for (auto* values : {&sections.surge, &sections.sway, &sections.heave, &sections.roll,
                         &sections.heave_factor, &sections.horizontal_factor}) {
      round_all(*values);
    }
    for (auto* values : {&diffraction.sway, &diffraction.heave, &diffraction.roll}) {
      for (Complex& value : *values) {
        value = SingleComplex(value);
      }
    }
  }
  WaveField field;
  wave_field(hull, omega, mu, sections, has_diffraction ? &diffraction : nullptr, field);
  return motion_transfer(hull, field, 8.0);
}

TEST(Held, SinglePrecisionKeepsSevenDigits) {
  EXPECT_EQ(static_cast<double>(Single(0.5)), 0.5);
  EXPECT_NE(static_cast<double>(Single(0.1)), 0.1);
  for (const double value : {1e-30, 0.1, 12345.678, 3.3e30}) {
    EXPECT_NEAR(static_cast<double>(Single(value)) / value, 1.0, 6e-8);
  }
}

TEST(Held, SinglePrecisionCostsAMotionNoMoreThanAMillionthOfItsPeak) {
  const auto exact = loaded();
  const auto kept = rounded(*exact);
  std::array<double, 6> peak{};
  std::array<double, 6> error{};
  for (int direction = 0; direction <= 12; ++direction) {
    const EncounterAngle mu{radians(15.0 * direction)};
    for (double omega = 0.25; omega < 2.2; omega += 0.05) {
      const MotionTransfer a = moved(*exact, omega, mu, false);
      const MotionTransfer b = moved(*kept, omega, mu, true);
      for (std::size_t i = 0; i < 6; ++i) {
        peak[i] = std::max(peak[i], std::abs(a.motion[i]));
        error[i] = std::max(error[i], std::abs(a.motion[i] - b.motion[i]));
      }
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    std::printf("  motion %zu: single precision errs by %.1e of the peak\n", i + 1, error[i] / peak[i]);
    EXPECT_LT(error[i], 1e-6 * peak[i]);
    EXPECT_GT(error[i], 0.0);  // it has been rounded
  }
}

}  // namespace
}  // namespace quickstrip
