// Roll in a seaway: the damping that its own roll calls for, against the equation solved by other means, and
// against motions solved again at every trial of the damping.
#include "core/response/roll_linearisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <vector>

#include "core/response/heading_moments.hpp"
#include "core/response/moments.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

Hull s175_with_keels() {
  Hull hull = test::s175();
  hull.roll_damping.method = RollDampingMethod::kIkeda;
  hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
  return hull;
}

RollDampingLevels levels_of_two_and_six() {
  RollDampingLevels out{.count = kRollDampingLevels, .own = 1.0};
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    out.added[l] = 2.0 + 4.0 * static_cast<double>(l);
  }
  return out;
}

TEST(RollLinearisation, WeightsAreOneAtTheirLevelAndSumToOneEverywhere) {
  const RollDampingLevels levels = levels_of_two_and_six();
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    const ByLevel weight = level_weights(levels, levels.added[l]);
    for (std::size_t k = 0; k < kRollDampingLevels; ++k) {
      EXPECT_NEAR(weight[k], k == l ? 1.0 : 0.0, 1e-14);
    }
  }
  for (const double damping : {0.5, 2.5, 7.0, 30.0}) {
    const ByLevel weight = level_weights(levels, damping);
    EXPECT_NEAR(std::accumulate(weight.begin(), weight.end(), 0.0), 1.0, 1e-13);
  }
}

// White noise: sigma^2 = c / (own + b), and damping of eddies alone, b = k sigma: a cubic in sigma.
TEST(RollLinearisation, SolvesResonantRollInWhiteNoise) {
  const RollDampingLevels levels = levels_of_two_and_six();
  constexpr double kOmega = 0.5;
  RollDampingModel model = constant_roll_damping(0.0, kOmega);
  model.friction = 1e-12;  // Ikeda's; next to nothing
  model.eddy = 100.0;
  const double per_rms = added_roll_damping_gaussian(model, 0.0, 0.1, kOmega) / 0.1;
  for (const double c : {0.01, 0.05, 0.3}) {
    RollVariances at;
    for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
      at.roll[l] = c / (levels.own + levels.added[l]);
      at.velocity[l] = kOmega * kOmega * at.roll[l];
    }
    double low = 0.0;
    double high = 100.0;
    for (int i = 0; i < 60; ++i) {  // sigma^2 (own + k sigma) = c
      const double sigma = 0.5 * (low + high);
      (sigma * sigma * (levels.own + per_rms * sigma) < c ? low : high) = sigma;
    }
    const LinearisedRoll roll = linearise_roll({model, levels}, at);
    EXPECT_NEAR(roll.damping / (per_rms * low), 1.0, 1e-6) << c;
    EXPECT_LT(roll.residual, 1e-6);
  }
}

TEST(RollLinearisation, WithoutRollIsTheDampingOfVanishingRoll) {
  const RollDampingModel model = constant_roll_damping(2.0, 0.4);
  const RollDampingLevels levels = levels_of_two_and_six();
  const LinearisedRoll roll = linearise_roll({model, levels}, {});
  EXPECT_NEAR(roll.damping, 2.0, 1e-6);
  EXPECT_LT(roll.residual, 1e-6);
}

struct Seaway {
  double hs;
  double tp;
  double mu_deg;
  double speed;
  double spreading_deg;
};

class LinearisedS175 : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(load(hull_, hull_.loading, {}, *ship_).ok());
    ASSERT_TRUE(list_channels(hull_, hull_.loading, ship_->hydrostatics, SwellUp::kOff, watch_).ok());
    roll_ = find_channel(watch_, Quantity::kRoll, 0);
  }

  void solve(double speed) {
    ASSERT_TRUE(solve_transfer_functions(*ship_, std::span(&speed, 1), *work_, *transfer_).ok());
  }

  // For a ship heading north.
  void place(const Seaway& at) {
    SeaState sea;
    ASSERT_TRUE(sea.systems.push_back({at.hs, at.tp, PeriodKind::kPeak, WaveFrom{radians(180.0 - at.mu_deg)},
                                       radians(at.spreading_deg), SpectrumShape::kBretschneider, 1.0}));
    const auto omega = std::span(transfer_->omega).first(transfer_->num_frequencies);
    ASSERT_TRUE(place_on_grid(sea, omega, *sea_).ok());
  }

  // Two crossing seas as a buoy gives them: more bands than the sweep has room for at once.
  void place_measured() {
    const auto spectrum = std::make_unique<DirectionalSpectrum>();
    for (std::size_t d = 0; d < kMaxSpectrumDirections; ++d) {
      ASSERT_TRUE(spectrum->directions.push_back(kTwoPi * static_cast<double>(d) / kMaxSpectrumDirections));
    }
    for (std::size_t f = 0; f < kMaxSpectrumFrequencies; ++f) {
      const double omega = 0.25 + 0.03 * static_cast<double>(f);
      ASSERT_TRUE(spectrum->frequencies.push_back(omega));
      for (std::size_t d = 0; d < kMaxSpectrumDirections; ++d) {
        const auto hump = [&](double peak, double from, double height) {
          const double x = (omega - peak) / 0.12;
          return height * std::exp(-x * x) * std::pow(std::cos(0.5 * (spectrum->directions[d] - from)), 16);
        };
        spectrum->density[f][d] = hump(0.45, 2.0, 4.0) + hump(0.8, 5.5, 1.5);
      }
    }
    const auto omega = std::span(transfer_->omega).first(transfer_->num_frequencies);
    ASSERT_TRUE(place_on_grid(*spectrum, omega, *sea_).ok());
  }

  // Every seventh heading of the sweep beside the same course by itself.
  void expect_sweep_is_the_courses(double speed) {
    const auto work = std::make_unique<SweepWorkspace>();
    const auto waves = std::make_unique<IncidentWaves>();
    const auto moments = std::make_unique<HeadingMoments>();
    Needs needs{};
    needs.fill(Need::kVarianceAndLowEncounter);
    list_incident_waves(*transfer_, watch_, *waves);
    list_heading_moments(*transfer_, 0, watch_, *waves, needs, *sea_, {}, *work, *moments);
    std::vector<ResponseMoments> one(watch_.channels.size());
    for (std::size_t h = 0; h < kNumDirections; h += 7) {
      const Heading heading{kTwoPi * static_cast<double>(h) / static_cast<double>(kNumDirections)};
      const Result<RollDampingInUse> damping =
          response_moments(*transfer_, watch_, *sea_, heading, speed, one);
      ASSERT_TRUE(damping.ok());
      EXPECT_NEAR(moments->roll_damping.added[h] / damping->added, 1.0, 1e-6);
      for (std::size_t c = 0; c < one.size(); ++c) {
        // Transforms round at 1e-13 of the largest variance on any heading; dampings differ by the 1e-7 to
        // which both are solved.
        const ByHeading& all = moments->channel[c].m0;
        const double largest = *std::max_element(all.begin(), all.end());
        EXPECT_NEAR(all[h], one[c].m0, 1e-6 * one[c].m0 + 1e-12 * largest) << c << " heading " << h;
      }
    }
  }

  RollDampingInUse respond(const Seaway& at, std::vector<ResponseMoments>& out) {
    out.resize(watch_.channels.size());
    const Result<RollDampingInUse> damping =
        response_moments(*transfer_, watch_, *sea_, {0.0}, at.speed, out);
    EXPECT_TRUE(damping.ok());
    return *damping;
  }

  // Bisection on the damping, every motion solved again at each trial.
  double damping_by_brute_force(const Seaway& at, const RollDampingModel& model,
                                std::vector<ResponseMoments>& out) {
    double low = 0.2 * small_roll_damping(model, at.speed);
    double high = 20.0 * small_roll_damping(model, at.speed);
    for (int i = 0; i < 14; ++i) {
      const double middle = std::sqrt(low * high);
      ship_->roll_damping = constant_roll_damping(middle, ship_->roll_natural_frequency);
      solve(at.speed);
      respond(at, out);
      const double rms = std::sqrt(out[roll_].m0);
      const double omega = std::sqrt(out[roll_].m2 / out[roll_].m0);
      (added_roll_damping_gaussian(model, at.speed, rms, omega) > middle ? low : high) = middle;
    }
    ship_->roll_damping = model;
    return std::sqrt(low * high);
  }

  Hull hull_ = s175_with_keels();
  std::unique_ptr<LoadedHull> ship_ = std::make_unique<LoadedHull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<TransferWorkspace> work_ = std::make_unique<TransferWorkspace>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  Watch watch_;
  std::size_t roll_ = 0;
};

// Stabilisers count as off unless they are said to work; then they add what the hull file says, as the square
// of the speed below theirs.
TEST_F(LinearisedS175, StabilisersAddTheirDampingWhileTheyWork) {
  constexpr double kStabiliserSpeed = 8.0;
  hull_.roll_damping.method = RollDampingMethod::kRatio;
  hull_.roll_damping.ratio = 0.03;
  hull_.roll_damping.stabiliser = Stabiliser{.ratio = 0.08, .speed = kStabiliserSpeed};
  for (const double speed : {4.0, kStabiliserSpeed, 10.0}) {
    const Seaway at{5.0, 13.0, 75.0, speed, 25.0};
    ASSERT_TRUE(load(hull_, hull_.loading, {}, *ship_).ok());
    solve(speed);
    place(at);
    std::vector<ResponseMoments> off;
    const RollDampingInUse without = respond(at, off);
    std::vector<ResponseMoments> on(off.size());
    const Result<RollDampingInUse> with =
        response_moments(*transfer_, watch_, *sea_, {0.0}, speed, on, {.is_stabilised = true});
    ASSERT_TRUE(with.ok());
    const double share = std::min(1.0, speed / kStabiliserSpeed);
    EXPECT_NEAR(without.added / transfer_->critical_roll_damping, 0.03, 1e-6);
    EXPECT_NEAR(with->added / transfer_->critical_roll_damping, 0.03 + share * share * 0.08, 1e-6);
    set_roll_damping_ratio(*ship_, 0.03 + share * share * 0.08);
    ship_->stabiliser.reset();
    solve(speed);
    std::vector<ResponseMoments> damped;
    respond(at, damped);
    // Interpolation between the levels of damping.
    EXPECT_NEAR(std::sqrt(on[roll_].m0 / damped[roll_].m0), 1.0, 0.003);
    EXPECT_LT(on[roll_].m0, 0.8 * off[roll_].m0);
  }
}

// Interpolation between levels and the update of motions are all that differs: 1 % of an RMS.
TEST_F(LinearisedS175, AgreesWithMotionsSolvedAgainAtEveryTrialOfTheDamping) {
  std::printf(
      "  Hs    Tp   mu  V     damping, brute force  ratio   roll RMS deg  error %%   worst other %%\n");
  for (const Seaway& at : {Seaway{2.0, 9.0, 90.0, 0.0, 0.0}, Seaway{5.0, 12.0, 90.0, 0.0, 0.0},
                           Seaway{8.0, 17.0, 90.0, 5.0, 25.0}, Seaway{5.0, 12.0, 60.0, 8.0, 25.0},
                           Seaway{8.0, 14.0, 120.0, 8.0, 25.0}, Seaway{4.0, 8.0, 45.0, 5.0, 0.0}}) {
    solve(at.speed);
    place(at);
    std::vector<ResponseMoments> ours;
    const RollDampingInUse damping = respond(at, ours);
    EXPECT_LT(damping.residual, 1e-6);
    const RollDampingModel model = ship_->roll_damping;
    std::vector<ResponseMoments> exact;
    const double brute = damping_by_brute_force(at, model, exact);
    const double error = std::sqrt(ours[roll_].m0 / exact[roll_].m0) - 1.0;
    double worst = 0.0;
    for (std::size_t c = 0; c < ours.size(); ++c) {
      worst = std::max(worst, std::fabs(std::sqrt(ours[c].m0 / exact[c].m0) - 1.0));
    }
    std::printf("%5.1f %5.1f %4.0f %3.0f %12.4g %12.4g %8.4f %10.2f %10.3f %10.3f\n", at.hs, at.tp, at.mu_deg,
                at.speed, damping.added, brute, damping.added / transfer_->critical_roll_damping,
                std::sqrt(ours[roll_].m0) / radians(1.0), 100.0 * error, 100.0 * worst);
    EXPECT_NEAR(damping.added / brute, 1.0, 0.02);
    // A ship that hardly rolls is damped less than at any level: beyond them the parabola goes astray.
    const double tolerance = std::sqrt(ours[roll_].m0) > radians(0.5) ? 0.01 : 0.05;
    EXPECT_LT(std::fabs(error), tolerance);
    // Sway and roll that all but cancel in a lateral acceleration are no resonance.
    EXPECT_LT(worst, 2.5 * tolerance);
  }
}

TEST_F(LinearisedS175, SweepAndSingleCourseAgree) {
  const double speed = 6.0;
  solve(speed);
  place({6.0, 13.0, 60.0, speed, 30.0});
  expect_sweep_is_the_courses(speed);
}

TEST_F(LinearisedS175, AlsoInAMeasuredSpectrum) {
  const double speed = 6.0;
  solve(speed);
  place_measured();
  expect_sweep_is_the_courses(speed);
}

// The seas of [Journee1992] Table 1, all round the ship at four speeds: the steps that linearise_roll() is
// allowed are always enough.
TEST_F(LinearisedS175, ConvergesInEverySeaOfThePapersTable) {
  struct Beaufort {
    double hs;
    double t1;
  };
  constexpr std::array<Beaufort, 11> kOcean = {{{1.10, 5.8},
                                                {1.20, 5.9},
                                                {1.40, 6.0},
                                                {1.70, 6.1},
                                                {2.15, 6.5},
                                                {2.90, 7.2},
                                                {3.75, 7.8},
                                                {4.90, 8.4},
                                                {6.10, 9.0},
                                                {7.45, 9.6},
                                                {8.70, 10.1}}};
  const auto work = std::make_unique<SweepWorkspace>();
  const auto waves = std::make_unique<IncidentWaves>();
  const auto moments = std::make_unique<HeadingMoments>();
  Needs needs{};
  double worst = 0.0;
  double least = 1e9;
  double most = 0.0;
  for (const double speed : {0.0, 4.0, 8.28, 12.0}) {
    solve(speed);
    list_incident_waves(*transfer_, watch_, *waves);
    for (const Beaufort& sea : kOcean) {
      place({sea.hs, sea.t1 / 0.772, 0.0, speed, 25.0});  // Tp of a Bretschneider spectrum (formulas §9)
      list_heading_moments(*transfer_, 0, watch_, *waves, needs, *sea_, {}, *work, *moments);
      const HeadingDamping& found = moments->roll_damping;
      worst = std::max(worst, *std::max_element(found.residual.begin(), found.residual.end()));
      const auto [low, high] = std::minmax_element(found.added.begin(), found.added.end());
      least = std::min(least, *low / transfer_->critical_roll_damping);
      most = std::max(most, *high / transfer_->critical_roll_damping);
    }
  }
  std::printf("3,168 courses: damping %.4f to %.3f of critical, largest residual %.1e\n", least, most, worst);
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(least, 0.01);  // seas differ: there was something to find
  EXPECT_GT(most, 0.05);
}

// The higher the sea, the more damping; in a calm one, that of a ship that hardly rolls.
TEST_F(LinearisedS175, DampingGrowsWithTheSeaAndRollLessThanInProportion) {
  solve(0.0);
  double last_damping = 0.0;
  double last_roll_by_height = 1e9;
  std::vector<ResponseMoments> out;
  for (const double hs : {0.1, 1.0, 2.0, 4.0, 8.0}) {
    const Seaway at{hs, 14.0, 90.0, 0.0, 0.0};
    place(at);
    const double damping = respond(at, out).added;
    const double roll_by_height = std::sqrt(out[roll_].m0) / hs;
    EXPECT_GT(damping, last_damping);
    EXPECT_LT(roll_by_height, last_roll_by_height);
    last_damping = damping;
    last_roll_by_height = roll_by_height;
  }
}

}  // namespace
}  // namespace quickstrip
