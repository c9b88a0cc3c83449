#include "core/response/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/response/short_term.hpp"
#include "tests/response/synthetic.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

class Moments : public testing::Test {
 protected:
  void SetUp() override {
    synthetic::fill_box(*hull_);
    ASSERT_TRUE(
        list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
    synthetic::fill(*transfer_, 9, 1.0, 40, synthetic::shiplike);
  }
  std::vector<ResponseMoments> at(const SeaEnergy& sea, double heading_deg, double speed) {
    std::vector<ResponseMoments> out(watch_.channels.size());
    EXPECT_TRUE(response_moments(*transfer_, watch_, sea, {radians(heading_deg)}, speed, out).ok());
    return out;
  }
  std::size_t channel(Quantity quantity) { return find_channel(watch_, quantity, 0); }

  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  Watch watch_;
};

TEST_F(Moments, OfAUnitResponseGiveAQuarterOfTheSignificantWaveHeight) {
  synthetic::fill(*transfer_, 9, 1.0, 40, [](double, double, double) {
    MotionTransfer transfer;
    transfer.motion[2] = 1.0;
    return transfer;
  });
  synthetic::add_system(*sea_, *transfer_, 4.0, 9.0, 10, 6);
  const auto moments = at(*sea_, 123.0, 3.3);
  EXPECT_NEAR(std::sqrt(moments[channel(Quantity::kHeave)].m0), 1.0, kSingle);
}

TEST_F(Moments, OfOneWaveAreItsEnergyTimesPowersOfTheEncounterFrequency) {
  synthetic::add_waves(*sea_, *transfer_, 18, {{12, 0.5}});  // from east
  const auto moments = at(*sea_, 90.0, 4.0);                 // heading east: head waves
  const double omega = transfer_->omega[12];
  const double omega_e = omega + 4.0 * omega * omega / kStandardGravity;
  const ResponseMoments& heave = moments[channel(Quantity::kHeave)];
  const double h2 = std::norm(synthetic::shiplike(4.0, kPi, omega).motion[2]);
  EXPECT_NEAR(heave.m0, 0.5 * h2, kSingle * h2);
  EXPECT_NEAR(heave.m1, 0.5 * h2 * omega_e, kSingle * h2);
  EXPECT_NEAR(heave.m2, 0.5 * h2 * omega_e * omega_e, kSingle * h2);
  EXPECT_NEAR(heave.m4, 0.5 * h2 * std::pow(omega_e, 4), kSingle * h2);
  EXPECT_NEAR(zero_crossing_period(heave.m0, heave.m2), kTwoPi / omega_e, kSingle);
  EXPECT_NEAR(crest_period(heave.m2, heave.m4), kTwoPi / omega_e, kSingle);
}

TEST_F(Moments, AreTheSameByIncidentWavesThatAreListedOnceForAll) {
  synthetic::add_system(*sea_, *transfer_, 4.0, 9.0, 10, 30);
  const auto waves = std::make_unique<IncidentWaves>();
  list_incident_waves(*transfer_, watch_, *waves);
  for (const double heading_deg : {0.0, 40.0, 130.0, 250.0}) {
    const auto found = at(*sea_, heading_deg, 3.3);
    std::vector<ResponseMoments> listed(watch_.channels.size());
    ASSERT_TRUE(response_moments(*transfer_, watch_, *sea_, {radians(heading_deg)}, 3.3, listed,
                                 {.waves = waves.get()})
                    .ok());
    for (std::size_t c = 0; c < listed.size(); ++c) {
      EXPECT_NEAR(listed[c].m0, found[c].m0, kSingle * found[c].m0) << c << ", " << heading_deg;
      EXPECT_NEAR(listed[c].m4, found[c].m4, kSingle * found[c].m4) << c << ", " << heading_deg;
    }
  }
}

TEST_F(Moments, AreThoseOfTheRightSideForWavesFromStarboardAndFromPort) {
  // The bridge lies to port: roll and heave add there for waves from one side and cancel for the other.
  const std::size_t f = 10;  // 0.61 rad/s: near the roll resonance
  // 135 degrees: on the starboard bow of a ship heading 090
  synthetic::add_waves(*sea_, *transfer_, 27, {{f, 1.0}});
  const double mu = 0.75 * kPi;
  MotionTransfer transfer = synthetic::shiplike(0.0, mu, transfer_->omega[f]);
  transfer.encounter_frequency = transfer_->omega[f];
  const std::size_t bridge = channel(Quantity::kVerticalAcceleration);
  const Position point = watch_.channels[bridge].position;
  EXPECT_NEAR(at(*sea_, 90.0, 0.0)[bridge].m0,
              std::norm(point_acceleration(transfer, point, kStandardGravity).z), 1e-7);  // single precision
  const Position other_side{point.x, -point.y, point.z};  // heading 180: the same wave is on the port bow
  EXPECT_NEAR(at(*sea_, 180.0, 0.0)[bridge].m0,
              std::norm(point_acceleration(transfer, other_side, kStandardGravity).z),
              1e-7);  // single precision
  EXPECT_GT(std::abs(at(*sea_, 90.0, 0.0)[bridge].m0 / at(*sea_, 180.0, 0.0)[bridge].m0 - 1.0),
            0.05);  // the sides differ
}

TEST_F(Moments, OfWaveSystemsAddAndAreKeptApart) {
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 0, 5);
  synthetic::add_system(*sea_, *transfer_, 2.0, 12.0, 25, 2);
  const auto moments = at(*sea_, 37.0, 2.5);
  auto one = std::make_unique<SeaEnergy>();
  synthetic::add_system(*one, *transfer_, 3.0, 8.0, 0, 5);
  const auto first = at(*one, 37.0, 2.5);
  for (std::size_t c = 0; c < moments.size(); ++c) {
    EXPECT_NEAR(moments[c].m0_by_system[0], first[c].m0, 1e-12 * first[c].m0);
    EXPECT_NEAR(moments[c].m0_by_system[0] + moments[c].m0_by_system[1], moments[c].m0,
                1e-12 * moments[c].m0);
    EXPECT_GT(moments[c].m0_by_system[1], 0.0);
  }
}

TEST_F(Moments, BetweenHeadingsAndSpeedsAreTheBilinearMeanOfTheFourCorners) {
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 7, 3);
  const auto middle = at(*sea_, 41.0, 3.25);
  const auto corner = [&](double heading, double speed) { return at(*sea_, heading, speed); };
  const auto c00 = corner(40.0, 3.0);
  const auto c10 = corner(45.0, 3.0);
  const auto c01 = corner(40.0, 4.0);
  const auto c11 = corner(45.0, 4.0);
  for (std::size_t c = 0; c < middle.size(); ++c) {
    const double expected =
        0.75 * (0.8 * c00[c].m2 + 0.2 * c10[c].m2) + 0.25 * (0.8 * c01[c].m2 + 0.2 * c11[c].m2);
    EXPECT_NEAR(middle[c].m2, expected, kSingle * expected);
  }
}

TEST_F(Moments, AreTheSameOnBothSidesOfASymmetricShip) {
  // Waves from 30 degrees to starboard of the bow, and from 30 to port; bridge moved to the other side.
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 6, 0);
  auto other = std::make_unique<SeaEnergy>();
  synthetic::add_system(*other, *transfer_, 3.0, 8.0, 66, 0);
  const auto starboard = at(*sea_, 0.0, 5.0);
  hull_->points[0].y = -hull_->points[0].y;
  ASSERT_TRUE(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
  const auto port = at(*other, 0.0, 5.0);
  for (std::size_t c = 0; c < starboard.size(); ++c) {
    EXPECT_EQ(starboard[c].m0, port[c].m0) << c;  // bit for bit: only signs differ
    EXPECT_EQ(starboard[c].m2, port[c].m2) << c;
  }
}

TEST_F(Moments, BelowTheEncounterFloorAreCountedApart) {
  // 8 m/s, following: omega_e = omega (1 - 8 omega / g) is within 0.1 of zero from about 1.11 to 1.32 rad/s.
  std::size_t low = 0;
  const auto omega_e = [this](std::size_t f) {
    return transfer_->omega[f] - transfer_->wave_number[f] * 8.0;
  };
  while (!(std::abs(omega_e(low)) < 0.1)) {
    ++low;
  }
  synthetic::add_waves(*sea_, *transfer_, 0, {{low, 0.3}, {2, 0.6}});
  const auto moments = at(*sea_, 180.0, 8.0);
  const ResponseMoments& wetness = moments[channel(Quantity::kDeckWetness)];
  EXPECT_GT(wetness.m0_low_encounter, 0.0);
  EXPECT_LT(wetness.m0_low_encounter, wetness.m0);
  EXPECT_EQ(at(*sea_, 0.0, 8.0)[channel(Quantity::kDeckWetness)].m0_low_encounter, 0.0);
}

TEST_F(Moments, RefuseASpeedOutsideTheSolvedOnesAndNaN) {
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 7, 3);
  std::vector<ResponseMoments> out(watch_.channels.size());
  EXPECT_EQ(response_moments(*transfer_, watch_, *sea_, {0.0}, 8.1, out).error(), Error::kSpeedOutOfGrid);
  EXPECT_EQ(response_moments(*transfer_, watch_, *sea_, {0.0}, -0.1, out).error(), Error::kSpeedOutOfGrid);
  EXPECT_EQ(response_moments(*transfer_, watch_, *sea_, {0.0}, std::nan(""), out).error(),
            Error::kSpeedOutOfGrid);
  EXPECT_EQ(response_moments(*transfer_, watch_, *sea_, {std::nan("")}, 3.0, out).error(), Error::kNotFinite);
  EXPECT_TRUE(response_moments(*transfer_, watch_, *sea_, {0.0}, 8.0, out).ok());
}

TEST_F(Moments, AnswerNaNMotionsWithAReason) {
  transfer_->row[3][20].re[2][5] = std::nanf("");
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 0, 35);
  std::vector<ResponseMoments> out(watch_.channels.size());
  EXPECT_EQ(response_moments(*transfer_, watch_, *sea_, {0.0}, 3.0, out).error(), Error::kNotFinite);
}

TEST_F(Moments, PutTheChannelsWhereTheHullHasThem) {
  const Channel& slamming = watch_.channels[channel(Quantity::kSlamming)];
  EXPECT_NEAR(slamming.level, 5.0 - 0.9, 1e-12);  // trimmed by the stern: draught at 90 m
  EXPECT_NEAR(slamming.position.x, 90.0 - 48.0, 1e-12);
  EXPECT_NEAR(slamming.threshold_velocity, 0.0928 * std::sqrt(kStandardGravity * 100.0), 1e-12);
  const Channel& wetness = watch_.channels[channel(Quantity::kDeckWetness)];
  EXPECT_NEAR(wetness.level, 10.0 - 4.0, 1e-12);
  const Channel& bridge = watch_.channels[channel(Quantity::kLateralAcceleration)];
  EXPECT_NEAR(bridge.position.x, -28.0, 1e-12);
  EXPECT_NEAR(bridge.position.y, 3.0, 1e-12);
  EXPECT_NEAR(bridge.position.z, 14.0, 1e-12);
  EXPECT_EQ(watch_.channels.size(), 6u + 2u * 3u + 1u + 1u);
}

TEST_F(Moments, GiveAKeelThatIsOutOfTheWaterAtRestNoDraught) {
  for (const std::size_t fore : {3u, 4u}) {
    auto& station = hull_->stations[fore];
    station.offsets.clear();
    for (const Offset& offset : {Offset{0.0, 6.0}, Offset{8.0, 6.0}, Offset{8.0, 10.0}}) {
      ASSERT_TRUE(station.offsets.push_back(offset));
    }
  }
  ASSERT_TRUE(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
  EXPECT_EQ(watch_.channels[channel(Quantity::kSlamming)].level, 0.0);
}

TEST_F(Moments, RefuseAStationOffTheHullAndADeckUnderWater) {
  hull_->slamming[0].x = 101.0;
  EXPECT_EQ(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).error(),
      Error::kOutOfRange);
  synthetic::fill_box(*hull_);
  hull_->freeboard[0].height = 3.9;
  EXPECT_EQ(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).error(),
      Error::kOutOfRange);
}

}  // namespace
}  // namespace quickstrip
