// Zones of speed and direction: surf-riding, successive high waves, pure loss, with the published figures and
// boundaries worked by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "core/hazard/pure_loss.hpp"
#include "core/hazard/successive_waves.hpp"
#include "core/hazard/surf_riding.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kG = kStandardGravity;

/// IMO's alpha, 0 = head, 90 = from starboard, as our mu.
EncounterAngle from_alpha(double alpha_deg) {
  return {wrap_pi(radians(180.0 - alpha_deg))};
}

// L 100 m: 1.8 sqrt(100) = 18.00 kn dead astern, 18 / cos(40) = 23.50 kn at alpha = 140 (and 220).
TEST(SurfRiding, BeginsAtThePublishedSpeeds) {
  EXPECT_FALSE(in_surf_riding_zone(100.0, 17.99 * kKnot, from_alpha(180.0)));
  EXPECT_TRUE(in_surf_riding_zone(100.0, 18.01 * kKnot, from_alpha(180.0)));
  for (const double alpha : {140.0, 220.0}) {
    EXPECT_FALSE(in_surf_riding_zone(100.0, 23.49 * kKnot, from_alpha(alpha)));
    EXPECT_TRUE(in_surf_riding_zone(100.0, 23.50 * kKnot, from_alpha(alpha)));
  }
  for (const auto& [length, knots] : {std::pair{50.0, 12.7}, {150.0, 22.0}, {200.0, 25.5}, {300.0, 31.2}}) {
    EXPECT_FALSE(in_surf_riding_zone(length, (knots - 0.1) * kKnot, {0.0}));  // published to a tenth
    EXPECT_TRUE(in_surf_riding_zone(length, (knots + 0.1) * kKnot, {0.0}));
  }
}

TEST(SurfRiding, ItsSectorExcludesTheBoundary) {
  EXPECT_TRUE(in_surf_riding_zone(100.0, 50.0 * kKnot, from_alpha(135.1)));
  EXPECT_FALSE(in_surf_riding_zone(100.0, 50.0 * kKnot, from_alpha(135.0)));
  EXPECT_TRUE(in_surf_riding_zone(100.0, 50.0 * kKnot, from_alpha(224.9)));
  EXPECT_FALSE(in_surf_riding_zone(100.0, 50.0 * kKnot, from_alpha(225.0)));
  EXPECT_FALSE(in_surf_riding_zone(100.0, 50.0 * kKnot, from_alpha(0.0)));
}

TEST(SurfRiding, TheMarginalBandLiesBelowIt) {
  EXPECT_FALSE(in_marginal_band(100.0, 13.9 * kKnot, {0.0}));
  EXPECT_TRUE(in_marginal_band(100.0, 14.1 * kKnot, {0.0}));
  EXPECT_TRUE(in_marginal_band(100.0, 17.9 * kKnot, {0.0}));
  EXPECT_FALSE(in_marginal_band(100.0, 18.1 * kKnot, {0.0}));  // there it is the zone itself
  EXPECT_NEAR(1.8 * kKnot / std::sqrt(kG), 0.2957, 1e-4);      // as a Froude number
  EXPECT_NEAR(1.4 * kKnot / std::sqrt(kG), 0.230, 1e-3);
}

TEST(SurfRiding, TheGateOfTheLaterGuidelinesIsLongAndHighWaves) {
  EXPECT_TRUE(are_long_and_high(100.0, 80.1, 4.01));
  EXPECT_FALSE(are_long_and_high(100.0, 80.0, 4.01));
  EXPECT_FALSE(are_long_and_high(100.0, 80.1, 4.0));
  EXPECT_FALSE(are_long_and_high(100.0, std::nan(""), 5.0));
  // 0.94 sqrt(L) m/s, Fn 0.300, within 45 degrees: no cosine, the boundary included.
  EXPECT_TRUE(is_surf_riding_speed(100.0, 9.4, from_alpha(135.0)));
  EXPECT_FALSE(is_surf_riding_speed(100.0, 9.39, from_alpha(180.0)));
  EXPECT_FALSE(is_surf_riding_speed(100.0, 9.5, from_alpha(134.0)));
  EXPECT_NEAR(0.94 / std::sqrt(kG), 0.300, 5e-4);
}

TEST(PureLoss, BeginsAtAFroudeNumberOf024FromAsternToAbeam) {
  EXPECT_NEAR(0.752 / std::sqrt(kG), 0.240, 5e-4);
  EXPECT_FALSE(is_pure_loss_speed(175.0, 0.752 * std::sqrt(175.0) - 1e-6, {0.0}));
  for (const double mu : {0.0, 60.0, 90.0, -90.0}) {
    EXPECT_TRUE(is_pure_loss_speed(175.0, 0.752 * std::sqrt(175.0) + 1e-6, {radians(mu)}));
  }
  EXPECT_FALSE(is_pure_loss_speed(175.0, 20.0, {radians(91.0)}));
  EXPECT_FALSE(is_stability_lost(0.05));
  EXPECT_TRUE(is_stability_lost(0.049));
  EXPECT_TRUE(is_stability_lost(std::nan("")));
}

class SuccessiveWaves : public testing::Test {
 protected:
  static constexpr double kL = 150.0;
  /// One wave period, waves of 7 m.
  static bool is_in(double period, double knots, double alpha_deg, double hs = 7.0) {
    const double omega = kTwoPi / period;
    return in_successive_wave_zone({omega, omega}, hs, kL, knots * kKnot, from_alpha(alpha_deg), kG);
  }
  /// V cos / T in kn/s where TE/TW is `ratio`: exactly g / (2 pi kn) (1 - 1/ratio).
  static double knots_at(double ratio, double period) {
    return kG / (kTwoPi * kKnot) * (1.0 - 1.0 / ratio) * period;
  }
};

TEST_F(SuccessiveWaves, RunsFromEighteenTenthsToThreeWavePeriods) {
  EXPECT_NEAR(knots_at(1.8, 1.0), 1.35, 0.005);  // IMO's 1.33 and 2.0, with 3 for 3.03
  EXPECT_NEAR(knots_at(3.0, 1.0), 2.02, 0.005);
  const double period = 10.0;
  EXPECT_FALSE(is_in(period, knots_at(1.79, period), 180.0));
  EXPECT_TRUE(is_in(period, knots_at(1.81, period), 180.0));
  EXPECT_TRUE(is_in(period, knots_at(2.99, period), 180.0));
  EXPECT_FALSE(is_in(period, knots_at(3.01, period), 180.0));
  EXPECT_TRUE(is_in(10.0, 15.0, 180.0));  // the published example: TE/TW = 2
}

TEST_F(SuccessiveWaves, NeedsTheSectorLengthAndHeight) {
  const double knots = knots_at(2.2, 10.0);
  for (const double alpha : {135.0, 180.0, 225.0}) {
    EXPECT_TRUE(is_in(10.0, knots / std::abs(std::cos(radians(180.0 - alpha))), alpha));
  }
  EXPECT_FALSE(is_in(10.0, knots / std::cos(radians(46.0)), 134.0));
  EXPECT_FALSE(is_in(10.0, knots_at(2.2, 10.0), 0.0));
  EXPECT_FALSE(is_in(10.0, knots, 180.0, 6.0));  // 0.04 L
  EXPECT_TRUE(is_in(10.0, knots, 180.0, 6.01));
  const double least = std::sqrt(kTwoPi * 0.8 * kL / kG);  // T of a wave of 0.8 L: 8.77 s
  EXPECT_FALSE(is_in(0.999 * least, knots_at(2.2, least), 180.0));
  EXPECT_TRUE(is_in(1.001 * least, knots_at(2.2, least), 180.0));
}

TEST_F(SuccessiveWaves, OnlyWavesThatAreLongEnoughCountForThePeriod) {
  // A band from 12 s (226 m) to 5 s: at 12 s and 10 kn TE/TW is 1.4; short waves would bring it to 1.8.
  const WaveBand waves{kTwoPi / 12.0, kTwoPi / 5.0};
  const double slow = 0.99 * knots_at(1.8, std::sqrt(kTwoPi * 0.8 * kL / kG));
  EXPECT_FALSE(in_successive_wave_zone(waves, 7.0, kL, slow * kKnot, {0.0}, kG));
  EXPECT_TRUE(in_successive_wave_zone(waves, 7.0, kL, 1.02 * slow * kKnot, {0.0}, kG));
}

TEST_F(SuccessiveWaves, AreFeltByLargeMotionsAtTheEncounterPeriod) {
  const EncounterBand met{kTwoPi / 22.0, kTwoPi / 20.0};
  MeasuredSigns measured;
  EXPECT_FALSE(shows_successive_waves(measured, met));
  measured.roll_rms = radians(5.0);
  EXPECT_FALSE(shows_successive_waves(measured, met));  // a motion without period shows nothing
  measured.roll_period = 21.0;
  EXPECT_TRUE(shows_successive_waves(measured, met));
  measured.roll_period = 12.0;  // she rolls at another period
  EXPECT_FALSE(shows_successive_waves(measured, met));
  measured.pitch_period = 24.0;  // within 15 % of 22 s
  measured.pitch_rms = radians(1.4);
  EXPECT_FALSE(shows_successive_waves(measured, met));
  measured.pitch_rms = radians(1.6);
  EXPECT_TRUE(shows_successive_waves(measured, met));
  measured.pitch_rms = std::nan("");
  EXPECT_FALSE(shows_successive_waves(measured, met));
}

}  // namespace
}  // namespace quickstrip
