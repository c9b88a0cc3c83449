#include "core/response/local_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/advice/people_channels.hpp"
#include "core/response/moments.hpp"
#include "tests/response/synthetic.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

class LocalMotions : public testing::Test {
 protected:
  void SetUp() override {
    synthetic::fill_box(*hull_);
    hull_->propeller = Propeller{2.0, 3.0};
    ASSERT_TRUE(
        list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
    synthetic::fill(*transfer_, 9, 1.0, 40, synthetic::shiplike);
    synthetic::add_system(*sea_, *transfer_, 4.0, 8.0, 5, 4);
  }
  [[nodiscard]] std::vector<ResponseMoments> moments_of(const Watch& watch) const {
    std::vector<ResponseMoments> out(watch.channels.size());
    EXPECT_TRUE(response_moments(*transfer_, watch, *sea_, {0.2}, 4.5, out).ok());
    return out;
  }
  static ResponseMoments pick(const Watch& watch, const std::vector<ResponseMoments>& all,
                              Quantity quantity) {
    return all.at(find_channel(watch, quantity, 0));
  }

  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  Watch watch_;
  Watch local_;
};

TEST_F(LocalMotions, BeginWithTheShipsRollOnWhichTheirDampingRests) {
  ASSERT_TRUE(begin_local_watch(watch_, local_).ok());
  ASSERT_EQ(local_.channels.size(), 1u);
  EXPECT_EQ(local_.channels[0].quantity, Quantity::kRoll);
  EXPECT_EQ(moments_of(local_)[0].m0, pick(watch_, moments_of(watch_), Quantity::kRoll).m0);
  Watch without;
  EXPECT_EQ(begin_local_watch(without, local_).error(), Error::kOutOfRange);
}

TEST_F(LocalMotions, AtTheCentreOfGravityAreTheShips) {
  ASSERT_TRUE(add_local_motions({}, 0, false, kStandardGravity, local_).ok());
  const auto local = moments_of(local_);
  const auto ship = moments_of(watch_);
  EXPECT_EQ(pick(local_, local, Quantity::kDisplacementX).m0, ship[0].m0);
  EXPECT_EQ(pick(local_, local, Quantity::kDisplacementY).m0, ship[1].m0);
  EXPECT_EQ(pick(local_, local, Quantity::kDisplacementZ).m0, ship[2].m0);
  EXPECT_EQ(local.size(), 6u);
}

TEST_F(LocalMotions, AVelocitysVarianceIsTheDisplacementsSecondMomentAndItsPeriodComesFromTheFourth) {
  ASSERT_TRUE(add_local_motions({-28.0, 3.0, 14.0}, 0, true, kStandardGravity, local_).ok());
  const auto all = moments_of(local_);
  const Quantity pairs[3][2] = {{Quantity::kDisplacementX, Quantity::kVelocityX},
                                {Quantity::kDisplacementY, Quantity::kVelocityY},
                                {Quantity::kDisplacementZ, Quantity::kVelocityZ}};
  for (const auto& pair : pairs) {
    const ResponseMoments displacement = pick(local_, all, pair[0]);
    const ResponseMoments velocity = pick(local_, all, pair[1]);
    EXPECT_NEAR(velocity.m0, displacement.m2, kSingle * velocity.m0);
    EXPECT_NEAR(velocity.m2, displacement.m4, kSingle * velocity.m2);
  }
  // Vertical acceleration has no component of gravity: twice differentiated.
  EXPECT_NEAR(pick(local_, all, Quantity::kVerticalAcceleration).m0,
              pick(local_, all, Quantity::kDisplacementZ).m4, 1e-8);  // single precision
}

TEST_F(LocalMotions, AccelerationsOfAPointGivenAreThoseOfTheHullsPoint) {
  ASSERT_TRUE(add_local_motions({-28.0, 3.0, 14.0}, 0, true, kStandardGravity, local_).ok());  // "bridge"
  const auto local = moments_of(local_);
  const auto ship = moments_of(watch_);
  for (const Quantity quantity : {Quantity::kLongitudinalAcceleration, Quantity::kLateralAcceleration,
                                  Quantity::kVerticalAcceleration}) {
    EXPECT_EQ(pick(local_, local, quantity).m0, pick(watch_, ship, quantity).m0);
  }
}

TEST_F(LocalMotions, RelativeMotionAndVelocityAreWhatSlammingRestsOn) {
  const Channel& slamming = watch_.channels[find_channel(watch_, Quantity::kSlamming, 0)];
  ASSERT_TRUE(add_relative_motion(slamming, 0, kStandardGravity, local_).ok());
  const auto local = moments_of(local_);
  const ResponseMoments event = pick(watch_, moments_of(watch_), Quantity::kSlamming);
  EXPECT_EQ(local[0].m0, event.m0);
  EXPECT_EQ(local[0].m2, event.m2);
  EXPECT_NEAR(local[1].m0, event.m2, 1e-12 * event.m2);
  EXPECT_EQ(add_relative_motion(watch_.channels[3], 0, kStandardGravity, local_).error(), Error::kOutOfRange);
}

TEST_F(LocalMotions, OfAShipThatFollowsLongWavesAreTheWavesOwn) {
  // A raft without phase in x: displacement along z is the elevation, so its variance is that of the sea.
  synthetic::fill(*transfer_, 9, 1.0, 40, [](double, double, double) {
    MotionTransfer raft;
    raft.motion[2] = 1.0;
    return raft;
  });
  ASSERT_TRUE(add_local_motions({10.0, 2.0, 5.0}, 0, false, kStandardGravity, local_).ok());
  EXPECT_NEAR(pick(local_, moments_of(local_), Quantity::kDisplacementZ).m0, 1.0, kSingle);  // hs 4 m
}

TEST_F(LocalMotions, AreRefusedWhenTheyAreNoneOrTooMany) {
  EXPECT_EQ(
      add_local_motions({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 0, false, 9.81, local_).error(),
      Error::kNotFinite);
  Status status;
  for (std::size_t i = 0; i <= kMaxChannels / 6 && status.ok(); ++i) {
    status = add_local_motions({}, 0, false, kStandardGravity, local_);
  }
  EXPECT_EQ(status.error(), Error::kTooMany);
}

TEST_F(LocalMotions, OfThePropellerAreItsRelativeMotionAndADryTipAlwaysEmerges) {
  const Channel& propeller = watch_.channels[find_channel(watch_, Quantity::kPropellerEmergence, 0)];
  EXPECT_NEAR(propeller.level, 4.98 - 3.0, 1e-12);  // waterline at x = 2 m of a trim of 1 m in 100 m
  EXPECT_NEAR(propeller.position.x, 2.0 - 48.0, 1e-12);
  EXPECT_EQ(propeller.form.wave, 1.0);
  hull_->propeller->tip_z = 6.0;
  ASSERT_TRUE(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
  EXPECT_EQ(watch_.channels[find_channel(watch_, Quantity::kPropellerEmergence, 0)].level, 0.0);
}

TEST_F(LocalMotions, FillTheWatchToItsCapacity) {
  synthetic::fill_box(*hull_);
  hull_->points.clear();
  hull_->slamming.clear();
  hull_->freeboard.clear();
  for (std::size_t i = 0; i < kMaxPoints; ++i) {
    ASSERT_TRUE(hull_->points.push_back({Name("p"), PointRole::kOther, 50.0, 0.0, 10.0}));
  }
  for (std::size_t i = 0; i < kMaxSlammingStations; ++i) {
    ASSERT_TRUE(hull_->slamming.push_back({Name("s"), 60.0 + 5.0 * static_cast<double>(i), std::nullopt}));
  }
  for (std::size_t i = 0; i < kMaxFreeboardPoints; ++i) {
    ASSERT_TRUE(hull_->freeboard.push_back({Name("f"), 60.0 + 5.0 * static_cast<double>(i), 10.0}));
  }
  hull_->propeller = Propeller{2.0, 3.0};
  ASSERT_TRUE(
      list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
  EXPECT_EQ(watch_.channels.size(), kMaxChannels - kMaxPeopleChannels);
  Criteria criteria;
  for (std::uint8_t i = 0; i < kMaxPeopleChannels; ++i) {
    ASSERT_TRUE(criteria.push_back({.quantity = Quantity::kMotionSickness, .place = i}));
  }
  ASSERT_TRUE(list_people_channels(criteria, watch_).ok());
  EXPECT_EQ(watch_.channels.size(), kMaxChannels);
  const auto all = moments_of(watch_);
  for (std::size_t c = 0; c < all.size(); ++c) {
    EXPECT_GT(all[c].m0, 0.0) << c;
  }
}

}  // namespace
}  // namespace quickstrip
