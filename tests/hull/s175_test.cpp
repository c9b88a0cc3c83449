// The S-175 container ship at T 9.5 m, KG 9.55 m against published figures and an independent program.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/hull/hydrostatics.hpp"
#include "core/hull/imo_roll_period.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

class S175 : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(immerse(*hull_, hull_->loading, *sections_).ok());
    const auto result = hydrostatics(*hull_, hull_->loading, *sections_);
    ASSERT_TRUE(result.ok());
    figures_ = *result;
  }
  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>(test::s175());
  std::unique_ptr<ImmersedSections> sections_ = std::make_unique<ImmersedSections>();
  Hydrostatics figures_;
};

TEST_F(S175, HasTheHydrostaticsOfItsOffsets) {
  // Trapezoidal integrals of the same offsets, done apart from this program; 0.1 % is the rounding of offsets
  // to the centimetre and of the figures.
  EXPECT_NEAR(figures_.displacement, 24616e3, 0.001 * 24616e3);
  EXPECT_NEAR(figures_.lcb, 84.953, 0.001 * 84.953);
  EXPECT_NEAR(figures_.kb, 5.207, 0.001 * 5.207);
  EXPECT_NEAR(figures_.gm, 0.994, 0.001 * 0.994);
  EXPECT_NEAR(figures_.cb, 0.569, 0.001);
  EXPECT_NEAR(figures_.cm, 0.966, 0.001);
}

TEST_F(S175, HasTheMassAndStiffnessThatVeresComputed) {
  // ShipX VERES 4.02.3 (MSS toolbox, MIT licence), about the waterline under G, rho 1025, g 9.81; its own
  // interpolation between stations: mass 24,609,620 kg, C33 31,683,876, C35 138,176,350, C55 49,354,928,000,
  // C44 240,517,170.
  const double rho_g = 1025.0 * 9.81;
  const double weight = figures_.displacement * 9.81;
  EXPECT_NEAR(figures_.displacement, 24609620.0, 0.001 * 24609620.0);
  EXPECT_NEAR(rho_g * figures_.waterplane_area, 31683876.0, 0.001 * 31683876.0);
  EXPECT_NEAR(rho_g * figures_.waterplane_area * (figures_.lcb - figures_.lcf), 138176350.0,
              0.005 * 138176350.0);
  EXPECT_NEAR(weight * figures_.gml, 49354928000.0, 0.001 * 49354928000.0);
  EXPECT_NEAR(weight * figures_.gm, 240517170.0, 0.005 * 240517170.0);  // GM: a small difference
}

TEST_F(S175, EverySectionIsOrderedAndInTheWater) {
  ASSERT_EQ(sections_->size(), 24U);
  for (const ImmersedSection& section : *sections_) {
    ASSERT_GE(section.contour.size(), 2U);
    EXPECT_EQ(section.contour.back().z, 0.0);
    EXPECT_NEAR(2.0 * section.contour.back().y, section.breadth, 1e-12);
    EXPECT_NEAR(-section.contour.front().z, section.draught, 1e-12);
    EXPECT_GT(section.centroid_z, -section.draught);
    EXPECT_LT(section.centroid_z, 0.0);
  }
  // The bulb at the forward perpendicular: narrow at the waterline, sigma of 7 with a breadth of 0.21 m.
  EXPECT_NEAR(sections_->back().breadth, 0.21, 0.001);
}

TEST_F(S175, RollPeriodOfTheIsCodeIsThatOfAnIndependentProgram) {
  const auto period = imo_roll_period(175.0, 25.4, 9.5, figures_.gm);
  ASSERT_TRUE(period.ok());
  EXPECT_NEAR(*period, 18.134, 0.05 * 18.134);  // VERES, with potential added mass; the formula is a fit
}

TEST(ImoRollPeriod, RefusesWhatIsNotAShip) {
  EXPECT_EQ(imo_roll_period(175.0, 25.4, 9.5, 0.0).error(), Error::kOutOfRange);
  EXPECT_EQ(imo_roll_period(175.0, std::nan(""), 9.5, 1.0).error(), Error::kNotFinite);
  EXPECT_EQ(imo_roll_period(1100.0, 25.4, 9.5, 1.0).error(), Error::kOutOfRange);  // C < 0
}

}  // namespace
}  // namespace quickstrip
