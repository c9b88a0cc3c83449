// What is met: IMO's drawn formula with the published figures, angles of the circular against ours, and bands
// of encounter frequency against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hazard/encounter_band.hpp"
#include "core/hazard/imo_encounter_period.hpp"
#include "core/hazard/roll_period_band.hpp"
#include "core/hazard/synchronous_roll.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

// TW 10 s, V 15 kn: 300/45 = 6.667 s from ahead, 300/15 = 20 s from astern.
TEST(ImoEncounterPeriod, GivesThePublishedPeriodsAtFifteenKnots) {
  EXPECT_NEAR(imo_encounter_period(10.0, 15.0 * kKnot, {0.0}), 20.0 / 3.0, 1e-12);
  EXPECT_NEAR(imo_encounter_period(10.0, 15.0 * kKnot, {kPi}), 20.0, 1e-12);
  EXPECT_NEAR(imo_encounter_period(10.0, 15.0 * kKnot, {0.5 * kPi}), 10.0, 1e-12);
}

// 3 stands for g / (2 pi kn): 1.2 % of the coefficient.
TEST(ImoEncounterPeriod, IsTheExactOneWithARoundedCoefficient) {
  const double exact = kStandardGravity / (kTwoPi * kKnot);
  EXPECT_NEAR(exact, 3.034, 1e-3);
  for (const double alpha : {0.0, 1.0, 2.0, 3.0}) {
    const double omega = kTwoPi / 9.0;
    const double along = -7.0 * std::cos(alpha);  // V cos(mu)
    const double te = kTwoPi / std::abs(omega - omega * omega * along / kStandardGravity);
    const double drawn =
        imo_encounter_period(9.0, 7.0 * 3.0 / exact, {alpha});  // with the speed that repairs it
    EXPECT_NEAR(drawn, te, 1e-9 * te);
  }
}

TEST(ImoAngle, IsNoughtAheadAndNinetyToStarboard) {
  EXPECT_NEAR(imo_angle({kPi}).radians, 0.0, 1e-15);
  EXPECT_NEAR(degrees(imo_angle({0.5 * kPi}).radians), 90.0, 1e-12);    // ours + from starboard
  EXPECT_NEAR(degrees(imo_angle({0.0}).radians), 180.0, 1e-12);         // following
  EXPECT_NEAR(degrees(imo_angle({-0.5 * kPi}).radians), 270.0, 1e-12);  // from port
}

TEST(EncounterBand, HoldsEveryFrequencyThatIsMetAndNoOther) {
  for (const double along : {-12.0, 0.0, 3.0, 6.0, 9.0, 12.0, 18.0, 30.0}) {
    const WaveBand waves{0.45, 0.62};
    double low = 1e9;
    double high = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i) {
      const double omega = waves.from + (waves.to - waves.from) * i / kSteps;
      const double met = std::abs(omega - omega * omega * along / 9.81);
      low = std::min(low, met);
      high = std::max(high, met);
    }
    const EncounterBand band = encounter_band(waves, along, 9.81);
    EXPECT_NEAR(band.low, low, 2e-5) << along;  // the step times the steepest slope
    EXPECT_NEAR(band.high, high, 2e-5) << along;
  }
}

TEST(SynchronousRoll, CountsForEitherEndOfTheRollPeriodBandAndAnyWave) {
  const EncounterBand ten{kTwoPi / 10.0, kTwoPi / 10.0};
  EXPECT_TRUE(in_synchronous_zone(ten, {10.0 / 1.149, 10.0 / 1.149}));
  EXPECT_FALSE(in_synchronous_zone(ten, {10.0 / 1.151, 10.0 / 1.151}));
  EXPECT_TRUE(in_synchronous_zone(ten, {10.0 / 0.851, 10.0 / 0.851}));
  EXPECT_FALSE(in_synchronous_zone(ten, {10.0 / 0.849, 10.0 / 0.849}));
  EXPECT_TRUE(in_synchronous_zone(ten, {5.0, 10.0 / 1.149}));   // the longest decides
  EXPECT_TRUE(in_synchronous_zone(ten, {10.0 / 0.851, 40.0}));  // the shortest decides
  EXPECT_TRUE(in_synchronous_zone({kTwoPi / 30.0, kTwoPi / 9.0}, {10.0, 10.0}));
}

}  // namespace
}  // namespace quickstrip
