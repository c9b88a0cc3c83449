// Mean added resistance in a seaway: closed forms of made-up responses, both codes against each other, and
// the ship against many more frequencies than the grid has.
#include "core/response/mean_added_resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

#include "core/sea/spectrum.hpp"
#include "core/sea/spreading.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "tests/response/synthetic.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

using ResistanceModel = std::function<double(double mu, double omega)>;

class MeanResistanceOf : public testing::Test {
 protected:
  void SetUp() override { synthetic::fill(*transfer_, 3, 4.0, 40, synthetic::shiplike); }

  /// The second speed twice the first, and so on; of the empirical method minus that.
  void respond_with(const ResistanceModel& model) {
    for (std::size_t v = 0; v < transfer_->num_speeds; ++v) {
      transfer_->has_empirical_resistance[v] = kKeepsEmpiricalResistance;
      for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
        for (std::size_t f = 0; f < transfer_->num_frequencies; ++f) {
          const double r = static_cast<double>(v + 1) * model(solved_angle(m).radians, transfer_->omega[f]);
          transfer_->added_resistance[v][m][f] = static_cast<float>(r);
          transfer_->empirical_resistance[v][m][f] = static_cast<float>(-r);
        }
      }
    }
  }
  const HeadingResistance& sweep(std::size_t v) {
    list_mean_added_resistance(*transfer_, v, *sea_, *work_, *by_heading_);
    return *by_heading_;
  }

  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  std::unique_ptr<SweepWorkspace> work_ = std::make_unique<SweepWorkspace>();
  std::unique_ptr<HeadingResistance> by_heading_ = std::make_unique<HeadingResistance>();
};

// 2 m0 = Hs^2 / 8.
TEST_F(MeanResistanceOf, OneNewtonPerSquareMetreIsAnEighthOfHsSquaredOnEveryHeading) {
  respond_with([](double, double) { return 1.0; });
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 7, 6);
  const HeadingResistance& mean = sweep(0);
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    EXPECT_NEAR(mean.strip[h], 9.0 / 8.0, 1e-12);
    EXPECT_NEAR(mean.empirical[h], -9.0 / 8.0, 1e-12);
  }
}

// A long-crested sea sees the response of one direction and nothing of the others: the sign of mu, and which
// way round the compass runs.
TEST_F(MeanResistanceOf, LongCrestedSeasIsThatOfOneRelativeDirection) {
  respond_with([](double mu, double) { return std::cos(mu) + 0.3 * mu; });
  const std::size_t from = 10;
  synthetic::add_system(*sea_, *transfer_, 2.0, 9.0, from, 0);
  const HeadingResistance& mean = sweep(1);
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    // mu = heading - from + 180 degrees, without sign.
    const double turned =
        kTwoPi * (static_cast<double>(h) - static_cast<double>(from)) / kNumDirections + kPi;
    const double mu = std::fabs(wrap_pi(turned));
    const auto at_node = static_cast<double>(static_cast<float>(2.0 * (std::cos(mu) + 0.3 * mu)));
    EXPECT_NEAR(mean.strip[h], 4.0 / 8.0 * at_node, 1e-6);
  }
}

TEST_F(MeanResistanceOf, OneCellIsThatOfTheSweepAndLinearBetween) {
  respond_with(
      [](double mu, double omega) { return 1e4 * (0.2 - std::cos(mu)) * std::exp(-4 * omega * omega); });
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 7, 6);
  synthetic::add_system(*sea_, *transfer_, 2.0, 12.0, 40, 3);
  for (std::size_t v = 0; v < 3; ++v) {
    const HeadingResistance& mean = sweep(v);
    for (std::size_t h = 0; h < kNumDirections; h += 5) {
      const Heading heading{kTwoPi * static_cast<double>(h) / kNumDirections};
      const Result<MeanResistance> cell =
          mean_added_resistance(*transfer_, *sea_, heading, transfer_->speeds[v]);
      ASSERT_TRUE(cell.ok());
      EXPECT_NEAR(cell->strip, mean.strip[h], 1e-9 * 1e4);
      ASSERT_TRUE(cell->empirical.has_value());
      EXPECT_NEAR(*cell->empirical, mean.empirical[h], 1e-9 * 1e4);
    }
  }
  const double step = kTwoPi / kNumDirections;
  const auto at = [&](double heading, double speed) {
    return mean_added_resistance(*transfer_, *sea_, Heading{heading}, speed)->strip;
  };
  EXPECT_NEAR(at(3.3 * step, 4.0), 0.7 * at(3.0 * step, 4.0) + 0.3 * at(4.0 * step, 4.0), 1e-6);
  EXPECT_NEAR(at(3.0 * step, 5.0), 0.75 * at(3.0 * step, 4.0) + 0.25 * at(3.0 * step, 8.0), 1e-6);
}

TEST_F(MeanResistanceOf, TheEmpiricalMethodIsMissingWhereASpeedIsOutOfItsRange) {
  respond_with([](double, double) { return 1.0; });
  synthetic::add_system(*sea_, *transfer_, 3.0, 8.0, 7, 6);
  transfer_->has_empirical_resistance[2] = false;
  EXPECT_FALSE(sweep(2).has_empirical);
  EXPECT_TRUE(sweep(1).has_empirical);
  const auto has = [&](double speed) {
    return mean_added_resistance(*transfer_, *sea_, Heading{0.0}, speed)->empirical.has_value();
  };
  EXPECT_TRUE(has(4.0));
  EXPECT_FALSE(has(4.1));
  EXPECT_FALSE(has(8.0));
  EXPECT_EQ(mean_added_resistance(*transfer_, *sea_, Heading{0.0}, 8.1).error(), Error::kSpeedOutOfGrid);
  EXPECT_EQ(mean_added_resistance(*transfer_, *sea_, Heading{std::nan("")}, 8.0).error(), Error::kNotFinite);
}

/// The S-175 at 20 kn on the grid's own frequencies.
class MeanResistanceOfTheS175 : public testing::Test {
 protected:
  static constexpr double kSpeed = 20.0 * 1852.0 / 3600.0;

  void SetUp() override {
    const Hull ship = test::s175();
    ASSERT_TRUE(load(ship, ship.loading, {}, *hull_).ok());
    const auto work = std::make_unique<TransferWorkspace>();
    ASSERT_TRUE(solve_transfer_functions(*hull_, std::span(&kSpeed, 1), *work, *transfer_).ok());
  }
  [[nodiscard]] double on_grid(const WaveSystem& system, double heading_deg) {
    SeaState sea;
    EXPECT_TRUE(sea.systems.push_back(system));
    const std::span omega(transfer_->omega.data(), transfer_->num_frequencies);
    EXPECT_TRUE(place_on_grid(sea, omega, *sea_).ok());
    return mean_added_resistance(*transfer_, *sea_, Heading{radians(heading_deg)}, kSpeed)->strip;
  }
  /// 2 integral of R S over `n` frequencies, waves of one direction; what of the sea lies outside the grid
  /// counts with the rest, as place_on_grid() has it.
  [[nodiscard]] double integral(const WaveSystem& system, EncounterAngle mu, std::size_t n) const {
    const Spectrum spectrum = *spectrum_of(system);
    const double low = transfer_->omega[0];
    const double high = transfer_->omega[transfer_->num_frequencies - 1];
    double sum = 0.0;
    double energy = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double omega = low + (high - low) * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
      const MotionTransfer motion = motion_transfer(*hull_, omega, mu, kSpeed);
      const double s = density(spectrum, omega);
      sum += added_resistance(*hull_, omega, mu, kSpeed, motion) * s;
      energy += s;
    }
    return 2.0 * spectrum.m0 * sum / energy;
  }

  std::unique_ptr<LoadedHull> hull_ = std::make_unique<LoadedHull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
};

// Between 48 frequencies the resistance is a straight line: the peak is 20 % wide and has some ten of them.
TEST_F(MeanResistanceOfTheS175, IsThatOf2000Frequencies) {
  for (const double t1 : {7.0, 9.0, 12.0}) {
    for (const double mu_deg : {180.0, 130.0, 40.0}) {
      const WaveSystem system{.hs = 3.0,
                              .period = t1,
                              .period_kind = PeriodKind::kMean,
                              .from = WaveFrom{wrap_two_pi(kPi - radians(mu_deg))}};
      const double ours = on_grid(system, 0.0);
      const double fine = integral(system, EncounterAngle{radians(mu_deg)}, 2000);
      std::printf(
          "S-175 20 kn, T1 %2.0f s, mu %3.0f: mean added resistance %8.1f kN, 2,000 frequencies %8.1f\n", t1,
          mu_deg, 1e-3 * ours, 1e-3 * fine);
      EXPECT_NEAR(ours, fine, 0.01 * std::fabs(fine) + 500.0) << t1 << " " << mu_deg;
    }
  }
}

TEST_F(MeanResistanceOfTheS175, InAShortCrestedSeaIsTheSumOverItsDirections) {
  const WaveSystem system{.hs = 4.0,
                          .period = 9.0,
                          .period_kind = PeriodKind::kMean,
                          .from = WaveFrom{0.0},
                          .spreading = radians(30.0)};
  const DirectionWeights weights = *direction_weights(system.from, system.spreading);
  const double heading_deg = 35.0;
  double sum = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    if (weights[d] > 1e-6) {
      const double from = kTwoPi * static_cast<double>(d) / kNumDirections;
      sum += weights[d] * integral(system, EncounterAngle{wrap_pi(radians(heading_deg) - from + kPi)}, 300);
    }
  }
  EXPECT_NEAR(on_grid(system, heading_deg), sum, 0.01 * std::fabs(sum));
}

TEST_F(MeanResistanceOfTheS175, MirroredSeaIsMirroredAnswer) {
  WaveSystem system{.hs = 4.0, .period = 9.0, .from = WaveFrom{radians(50.0)}, .spreading = radians(20.0)};
  const double starboard = on_grid(system, 0.0);
  system.from = WaveFrom{radians(310.0)};
  EXPECT_NEAR(on_grid(system, 0.0), starboard, 1e-9 * std::fabs(starboard));
}

}  // namespace
}  // namespace quickstrip
