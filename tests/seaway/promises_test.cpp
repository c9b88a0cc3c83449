// What the advisor states is what is counted: probabilities from 0.001 to 0.3, intervals, roll with quadratic
// damping. The long version is a command: quickstrip-sim simulate ... --runs K.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/seaway/equivalent_roll.hpp"
#include "sim/seaway/repeated_runs.hpp"
#include "tests/seaway/scene.hpp"

namespace quickstrip::seaway {
namespace {

struct Case {
  double hs;
  double mu_deg;
  double speed_kn;
};

TEST(Promises, CountsAgreeWithStatementsAndIntervalsHoldThem) {
  constexpr std::size_t kRuns = 14;
  std::size_t intervals = 0;
  std::size_t holding = 0;
  // Slams from 0.002 to 0.06, wet decks from 0.005 to 0.3, as the sea is higher.
  for (const Case& c : {Case{6.5, 180.0, 10.0}, Case{9.0, 150.0, 15.0}, Case{5.0, 120.0, 15.0}}) {
    Scene scene(c.hs, 9.0, c.mu_deg, 25.0, c.speed_kn);
    scene.plan.hours = 20.0;
    scene.watch_only({{Quantity::kRoll, 0},
                      {Quantity::kVerticalAcceleration, 1},
                      {Quantity::kLateralAcceleration, 0},
                      {Quantity::kSlamming, 0},
                      {Quantity::kDeckWetness, 0}});
    const std::vector<StatedCount> counts = questions_of(scene.watch, scene.plan.speed, scene.said(), {});
    Simulation simulation = scene.simulation();
    const std::vector<RepeatedCount> repeated = repeat_runs(simulation, scene.watch, counts, 1, kRuns);
    const Coverage coverage = coverage_of(counts, repeated);
    EXPECT_GT(coverage.least_ratio, 1.0 / 1.25) << c.mu_deg;
    EXPECT_LT(coverage.most_ratio, 1.25) << c.mu_deg;
    intervals += coverage.intervals;
    holding += coverage.holding;
  }
  const double share = static_cast<double>(holding) / static_cast<double>(intervals);
  EXPECT_GT(intervals, 500U);
  EXPECT_GT(share, 0.85);
  EXPECT_LT(share, 0.95);
}

// Counted in time with quadratic damping, against the advisor's stochastic linearisation.
TEST(Promises, RollWithQuadraticDampingIsTheLinearisedOnes) {
  for (const double mu_deg : {60.0, 90.0}) {
    Scene scene(5.0, 10.0, mu_deg, 25.0, 15.0);
    scene.plan.hours = 60.0;
    scene.plan.steps_roll = true;
    scene.watch_only({{Quantity::kRoll, 0}});
    Simulation simulation = scene.simulation();
    const double unit = ratio_roll_damping(*scene.loaded, 1.0);
    simulation.law = {0.02 * unit, 0.4 * unit};
    const EquivalentRoll equivalent = equivalent_roll(simulation);
    scene.loaded->roll_damping = law_model(simulation.law, scene.loaded->roll_natural_frequency);
    const double said = scene.said().quantities[0].rms;
    const Outcome got = run(simulation, scene.watch, {}, 2);
    EXPECT_GT(equivalent.damping, 1.5 * simulation.law.linear) << "the quadratic part must matter";
    EXPECT_LT(said, radians(10.0));
    EXPECT_NEAR(said / equivalent.roll_rms, 1.0, 0.01) << mu_deg;  // the same formula, another way
    EXPECT_NEAR(got.channels[0].rms / said, 1.0, 0.05) << mu_deg;  // issue 4: within 5 % below 10 degrees
    EXPECT_LT(got.channels[0].kurtosis, 2.95) << "quadratic damping cuts the largest rolls";
  }
}

// Linear damping in time is the linear ship: the same waves, the same roll.
TEST(Promises, LinearDampingInTimeIsTheLinearShip) {
  Scene scene(5.0, 10.0, 90.0, 25.0, 15.0);
  scene.plan.hours = 8.0;
  Simulation linear = scene.simulation();
  scene.plan.steps_roll = true;
  Simulation stepped = scene.simulation();
  stepped.law = {small_roll_damping(scene.loaded->roll_damping, scene.plan.speed), 0.0};
  const Outcome a = run(linear, scene.watch, {}, 5);
  const Outcome b = run(stepped, scene.watch, {}, 5);
  for (std::size_t c = 0; c < scene.watch.channels.size(); ++c) {
    EXPECT_NEAR(b.channels[c].rms / a.channels[c].rms, 1.0, 0.005) << c;  // trapezoidal rule
  }
}

}  // namespace
}  // namespace quickstrip::seaway
