#include "core/response/interruptions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <random>
#include <vector>

#include "core/advice/people_channels.hpp"
#include "core/response/moments.hpp"
#include "core/response/motion_sickness.hpp"
#include "core/response/short_term.hpp"
#include "tests/response/synthetic.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

constexpr double kG = kStandardGravity;

/// Roll, sway and heave that ask for all phases: no symmetry but that of the ship.
MotionTransfer crooked(double speed, double mu, double omega) {
  using namespace std::complex_literals;
  MotionTransfer transfer = synthetic::shiplike(speed, mu, omega);
  transfer.motion[1] *= std::exp(0.7i);
  transfer.motion[2] *= std::exp(-1.3i);
  transfer.motion[3] *= 0.3 * std::exp(0.3i * std::cos(mu));
  return transfer;
}

/// The box, with people who stand on the centre line and at the port rail, and are sick at both.
class Interruptions : public testing::Test {
 protected:
  static constexpr std::uint8_t kCentre = 1;
  static constexpr std::uint8_t kRail = 0;
  void SetUp() override {
    synthetic::fill_box(*hull_);
    hull_->points[kCentre].z = 14.0;
    watch();
    synthetic::fill(*transfer_, 9, 1.0, 40, crooked);
  }
  void watch() {
    ASSERT_TRUE(
        list_channels(*hull_, hull_->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch_).ok());
    Criteria criteria;
    for (const std::uint8_t place : {kRail, kCentre}) {
      ASSERT_TRUE(criteria.push_back({.quantity = Quantity::kMotionInterruptions,
                                      .place = place,
                                      .statistic = Statistic::kPerMinute,
                                      .limit = 1.0,
                                      .stance = stance_}));
      ASSERT_TRUE(criteria.push_back({.quantity = Quantity::kMotionSickness,
                                      .place = place,
                                      .statistic = Statistic::kShareOfPeople,
                                      .limit = 0.1}));
    }
    ASSERT_TRUE(list_people_channels(criteria, watch_).ok());
  }
  std::vector<ResponseMoments> at(double heading_deg, double speed) {
    std::vector<ResponseMoments> out(watch_.channels.size());
    EXPECT_TRUE(response_moments(*transfer_, watch_, *sea_, {radians(heading_deg)}, speed, out).ok());
    return out;
  }
  std::size_t first_of(std::uint8_t place, Quantity quantity = Quantity::kMotionInterruptions) {
    return find_channel(watch_, quantity, place);
  }
  Position position(std::uint8_t place) { return watch_.channels[first_of(place)].position; }

  /// Of the ship at mu in (-pi, pi], by hand: she is the same on both sides.
  static MotionTransfer motions(double speed, double mu, double omega) {
    MotionTransfer transfer = crooked(speed, std::fabs(mu), omega);
    transfer.encounter_frequency = omega - omega * omega / kG * speed * std::cos(mu);
    for (const std::size_t lateral : {1u, 3u, 5u}) {
      transfer.motion[lateral] *= mu < 0.0 ? -1.0 : 1.0;
    }
    return transfer;
  }
  /// GLFE written out for one wave, from the motions.
  std::complex<double> tipping(const MotionTransfer& transfer, const Position& point, double side) const {
    const double minus_square = -std::pow(transfer.encounter_frequency, 2);
    const PointMotion a = point_acceleration(transfer, point, kG);
    return stance_.height / 3.0 * minus_square * transfer.motion[3] - a.y +
           side * stance_.half_width_ratio * a.z;
  }

  Stance stance_;
  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  Watch watch_;
};

TEST_F(Interruptions, AreTheSquareOfOneComplexSumInAllFourQuadrants) {
  constexpr std::size_t kWave = 12;
  synthetic::add_waves(*sea_, *transfer_, 0, {{kWave, 0.8}});  // from north
  for (const double mu_deg : {45.0, 135.0, -45.0, -135.0}) {
    const double heading_deg = mu_deg - 180.0;  // mu = heading - from + 180
    const auto moments = at(heading_deg, 3.0);
    const MotionTransfer transfer = motions(3.0, radians(mu_deg), transfer_->omega[kWave]);
    for (const std::uint8_t place : {kRail, kCentre}) {
      const double to_port = 0.8 * std::norm(tipping(transfer, position(place), -1.0));
      const double to_starboard = 0.8 * std::norm(tipping(transfer, position(place), 1.0));
      const std::size_t c = first_of(place);
      EXPECT_FALSE(watch_.channels[c].to_starboard);
      EXPECT_TRUE(watch_.channels[c + 1].to_starboard);
      EXPECT_NEAR(moments[c].m0 / to_port, 1.0, kSingle) << mu_deg;
      EXPECT_NEAR(moments[c + 1].m0 / to_starboard, 1.0, kSingle) << mu_deg;
      EXPECT_NEAR(moments[c].m2 / moments[c].m0, std::pow(transfer.encounter_frequency, 2), kSingle)
          << mu_deg;
      EXPECT_GT(std::fabs(to_port / to_starboard - 1.0), 0.02) << "the sides are not to be alike, " << mu_deg;
    }
  }
}

TEST_F(Interruptions, ChangeSidesInTheMirrorImageOfTheSea) {
  // On the centre line; for a point off it the mirror image stands at the other rail.
  synthetic::add_system(*sea_, *transfer_, 4.0, 8.0, 9, 6);  // from 045
  auto mirrored = std::make_unique<SeaEnergy>();
  synthetic::add_system(*mirrored, *transfer_, 4.0, 8.0, 63, 6);  // from 315
  for (const double heading_deg : {0.0, 30.0, 100.0, 160.0}) {
    const auto here = at(heading_deg, 3.0);
    const Position rail = position(kRail);
    std::swap(sea_, mirrored);
    hull_->points[kRail].y = -hull_->points[kRail].y;
    watch();
    const auto there = at(-heading_deg, 3.0);
    for (const std::uint8_t place : {kRail, kCentre}) {
      const std::size_t c = first_of(place);
      EXPECT_NEAR(here[c].m0 / there[c + 1].m0, 1.0, 1e-12) << heading_deg;  // rounding
      EXPECT_NEAR(here[c + 1].m2 / there[c].m2, 1.0, 1e-12) << heading_deg;
      EXPECT_GT(std::fabs(here[c].m0 / here[c + 1].m0 - 1.0), 0.01) << heading_deg;
    }
    EXPECT_EQ(position(kRail).y, -rail.y);
    std::swap(sea_, mirrored);
    hull_->points[kRail].y = -hull_->points[kRail].y;
    watch();
  }
}

TEST_F(Interruptions, TipTowardsTheSideThatIsDown) {
  // So slow that the deck only leans: roll + is starboard down, and people tip that way.
  MotionTransfer lean;
  lean.motion[3] = 1.0;
  EXPECT_LT(tipping(lean, {}, 1.0).real(), 0.0);  // to starboard: falls below the level
  const Channel& to_starboard = watch_.channels[first_of(kCentre) + 1];
  EXPECT_DOUBLE_EQ(to_starboard.form.displacement[3], -kG);  // tips at a lean of b/h rad: tan, for small ones
  EXPECT_DOUBLE_EQ(to_starboard.level / -to_starboard.form.displacement[3], stance_.half_width_ratio);
  // A deck that falls away makes it easier on both sides: a_z = -omega_e^2 z < 0 for z > 0.
  const Channel& to_port = watch_.channels[first_of(kCentre)];
  EXPECT_GT(to_port.form.acceleration[2], 0.0);
  EXPECT_LT(to_starboard.form.acceleration[2], 0.0);
}

TEST_F(Interruptions, AreAsManyAsAPersonInTheTimeDomainHas) {
  // A rigid body of height 2 h and mass 1 on two feet, its centre at the point: it tips about the port foot
  // when the moment of all forces about that foot turns over, about the starboard foot likewise.
  constexpr double kSpeed = 3.0;
  constexpr double kMu = 1.9;
  constexpr std::size_t kFirst = 4;
  constexpr std::size_t kWaves = 24;
  struct Component {
    MotionTransfer transfer;
    double amplitude, phase;
  };
  std::mt19937_64 seeded(20240817);
  std::uniform_real_distribution<double> any_phase(0.0, kTwoPi);
  std::vector<Component> components;
  const Position person = position(kCentre);
  std::array<double, 2> m0{};
  std::array<double, 2> m2{};
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double omega = 0.2 + 1.6 * static_cast<double>(kFirst + i) / 39.0;
    const double energy = 3.0 * std::pow(0.7 / omega, 5) * std::exp(-1.25 * std::pow(0.7 / omega, 4));
    components.push_back({motions(kSpeed, kMu, omega), std::sqrt(2.0 * energy), any_phase(seeded)});
    for (const std::size_t side : {0u, 1u}) {
      const MotionTransfer& transfer = components.back().transfer;
      const double part = energy * std::norm(tipping(transfer, person, side == 0 ? -1.0 : 1.0));
      m0[side] += part;
      m2[side] += part * std::pow(transfer.encounter_frequency, 2);
    }
  }
  constexpr double kStep = 0.1;  // s
  constexpr int kSteps = 1'500'000;
  const double b = stance_.half_width_ratio * stance_.height;
  const double inertia = stance_.height * stance_.height / 3.0;
  std::array<int, 2> count{};
  std::array<bool, 2> was_over{true, true};
  struct Turning {
    std::complex<double> lateral, vertical, turn, by_step;
  };
  std::vector<Turning> turning;
  for (const Component& c : components) {
    const double omega_e = c.transfer.encounter_frequency;
    const std::complex<double> wave = std::polar(c.amplitude, c.phase);
    const PointMotion a = point_acceleration(c.transfer, person, kG);
    turning.push_back({wave * a.y, wave * a.z, -omega_e * omega_e * wave * c.transfer.motion[3],
                       std::polar(1.0, omega_e * kStep)});
  }
  for (int i = 0; i < kSteps; ++i) {
    double a_y = 0.0;
    double a_z = 0.0;
    double phi_dd = 0.0;
    for (Turning& t : turning) {
      a_y += t.lateral.real();
      a_z += t.vertical.real();
      phi_dd += t.turn.real();
      t.lateral *= t.by_step;
      t.vertical *= t.by_step;
      t.turn *= t.by_step;
    }
    // d'Alembert: force -a_y to port and -(g + a_z) up at the centre, h above and b inside either foot;
    // moment -inertia phi_dd about x, which turns port up.
    const double over_port = -a_y * stance_.height - (kG + a_z) * b + inertia * phi_dd;
    const double over_starboard = a_y * stance_.height - (kG + a_z) * b - inertia * phi_dd;
    for (const auto& [side, over] : {std::pair{0u, over_port > 0.0}, std::pair{1u, over_starboard > 0.0}}) {
      count[side] += over && !was_over[side] ? 1 : 0;
      was_over[side] = over;
    }
  }
  const double minutes = kSteps * kStep / 60.0;
  const double level = stance_.half_width_ratio * kG;
  for (const std::size_t side : {0u, 1u}) {
    const double expected = interruptions_per_minute(level, m0[side], m2[side]);
    ASSERT_GT(count[side], 1000) << expected;  // so that chance is below 3 %
    // Two dozen waves are nearly Gaussian: their tail at two sigma is a few per cent short.
    EXPECT_NEAR(count[side] / minutes / expected, 1.0, 0.08) << "side " << side;
  }
  EXPECT_GT(std::fabs(static_cast<double>(count[0]) / count[1] - 1.0), 0.1) << "sides that cannot be told";
}

TEST_F(Interruptions, OfADeadLevelDeckAreNone) {
  EXPECT_EQ(interruptions_per_minute(2.45, 0.0, 0.0), 0.0);
  EXPECT_NEAR(interruptions_per_minute(0.0, 1.0, 4.0), 60.0 * 2.0 / kTwoPi, 1e-12);  // every oscillation
}

TEST_F(Interruptions, ScaleAsFroudeSays) {
  // Lengths times 25, times times 5, accelerations as they are: the level stays, the rate falls to a fifth.
  const double model = interruptions_per_minute(2.45, 1.2, 3.0);
  EXPECT_NEAR(interruptions_per_minute(2.45, 1.2, 3.0 / 25.0), model / 5.0, 1e-12);
}

TEST_F(Interruptions, AndSicknessRestOnTheAccelerationChannelOfThePoint) {
  synthetic::add_system(*sea_, *transfer_, 4.0, 8.0, 9, 6);
  const auto moments = at(30.0, 3.0);
  for (const std::uint8_t place : {kRail, kCentre}) {
    const ResponseMoments& velocity = moments[first_of(place, Quantity::kMotionSickness)];
    const ResponseMoments& acceleration = moments[first_of(place, Quantity::kVerticalAcceleration)];
    const VerticalShaking shaking = vertical_shaking(velocity.m0, velocity.m2);
    EXPECT_NEAR(shaking.rms_acceleration / std::sqrt(acceleration.m0), 1.0, 1e-7);  // single precision
    EXPECT_NEAR(shaking.frequency, std::sqrt(velocity.m2 / velocity.m0), 1e-12);
    EXPECT_LT(shaking.frequency * shaking.frequency, acceleration.m2 / acceleration.m0);  // Schwarz
  }
}

}  // namespace
}  // namespace quickstrip
