#include "core/sea/dispersion.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

TEST(Dispersion, DeepWaterGivesOmegaSquaredOverG) {
  EXPECT_DOUBLE_EQ(wave_number(0.7), 0.49 / kStandardGravity);
  EXPECT_NEAR(wave_frequency(wave_number(0.7)), 0.7, 1e-15);
  EXPECT_NEAR(wave_number(0.7) * wave_length(0.7), kTwoPi, 1e-14);
}

// A wave of 10 s is 156.1 m long and runs at 15.6 m/s: the seaman's 1.56 T^2 and 1.56 T.
TEST(Dispersion, TenSecondsAreOneHundredAndFiftySixMetres) {
  EXPECT_NEAR(wave_length(kTwoPi / 10.0), 156.1, 0.05);
}

// [MSC.1/Circ.1228]: T = 10 s, V = 15 kn is met every 6.667 s in head and 20.0 s in following seas by
// T_E = 3 T^2 / (3 T + V cos alpha), where 3 is 1.5593 m/s2 in knots rounded: hence 1.5 %.
TEST(EncounterFrequency, MeetsTheWorkedFiguresOfTheImoCircular) {
  const double omega = kTwoPi / 10.0;
  const double k = wave_number(omega);
  const double head = encounter_frequency(omega, k, 15.0 * kKnot, {kPi});
  const double following = encounter_frequency(omega, k, 15.0 * kKnot, {0.0});
  EXPECT_NEAR(kTwoPi / head, 6.667, 0.015 * 6.667);
  EXPECT_NEAR(kTwoPi / following, 20.0, 0.015 * 20.0);
  EXPECT_NEAR(0.5 * (head + following), omega, 1e-15);
}

TEST(EncounterFrequency, IsNegativeWhenTheShipOvertakesTheWaves) {
  const double omega = 1.2;
  const double phase_speed = kStandardGravity / omega;
  const double k = wave_number(omega);
  EXPECT_NEAR(encounter_frequency(omega, k, phase_speed, {0.0}), 0.0, 1e-15);
  EXPECT_NEAR(encounter_frequency(omega, k, 2.0 * phase_speed, {0.0}), -omega, 1e-14);
  EXPECT_NEAR(encounter_frequency(omega, k, 2.0 * phase_speed, {0.5 * kPi}), omega, 1e-14);
}

TEST(EncounterFrequency, IsTheSameFromBothSides) {
  EXPECT_EQ(encounter_frequency(0.8, wave_number(0.8), 9.0, {0.6}),
            encounter_frequency(0.8, wave_number(0.8), 9.0, {-0.6}));
}

// Lengths times lambda, times times sqrt(lambda).
TEST(EncounterFrequency, ScalesByFroude) {
  const double scale = 36.0;
  const double full = encounter_frequency(0.8, wave_number(0.8), 9.0, {2.0});
  const double model = encounter_frequency(4.8, wave_number(4.8), 1.5, {2.0});
  EXPECT_NEAR(model / std::sqrt(scale), full, 1e-14);
}

}  // namespace
}  // namespace quickstrip
