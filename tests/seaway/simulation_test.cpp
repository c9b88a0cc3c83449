// The simulated ship against the advisor, its mirror image, Gauss's and Rice's laws.
#include "sim/seaway/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/seaway/equivalent_roll.hpp"
#include "tests/seaway/scene.hpp"

namespace quickstrip::seaway {
namespace {

TEST(Simulation, VarianceAndPeriodOfEveryChannelAreTheAdvisors) {
  for (const double mu_deg : {30.0, 135.0}) {
    Scene scene(5.0, 9.0, mu_deg, 25.0, 15.0);
    scene.plan.hours = 40.0;
    Simulation simulation = scene.simulation();
    const Outcome got = run(simulation, scene.watch, {}, 1);
    const Stated said = scene.said();
    for (std::size_t c = 0; c < scene.watch.channels.size(); ++c) {
      const ChannelOutcome& channel = got.channels[c];
      // Four standard errors, and 0.5 % for what the advisor's 48 frequencies leave.
      EXPECT_NEAR(channel.rms / said.quantities[c].rms, 1.0, 0.005 + 4.0 * channel.rms_error / channel.rms)
          << "channel " << c << " at " << mu_deg;
      EXPECT_NEAR(channel.t2 / said.quantities[c].t2, 1.0, 0.02) << "channel " << c << " at " << mu_deg;
    }
  }
}

// Without sampling: the sums over the cells are the simulation's own m0 and m2.
TEST(Simulation, MomentsOfItsCellsAreTheAdvisorsOnAllHeadings) {
  for (const double mu_deg : {0.0, 60.0, 90.0, 180.0}) {
    Scene scene(5.0, 9.0, mu_deg, 25.0, 15.0);
    const Simulation simulation = scene.simulation();
    const Stated said = scene.said();
    for (std::size_t c = 0; c < scene.watch.channels.size(); ++c) {
      const SpectralMoments m =
          channel_moments(simulation.answers, scene.watch.channels[c], simulation.answers.wave_row[c]);
      EXPECT_NEAR(std::sqrt(m.m0) / said.quantities[c].rms, 1.0, 0.01) << "channel " << c << " at " << mu_deg;
      EXPECT_NEAR(kTwoPi * std::sqrt(m.m0 / m.m2) / said.quantities[c].t2, 1.0, 0.01)
          << "channel " << c << " at " << mu_deg;
    }
  }
}

TEST(Simulation, TheSameSeedGivesTheSameBits) {
  Scene scene(5.0, 9.0, 135.0, 25.0, 15.0);
  scene.plan.hours = 4.0;
  Simulation simulation = scene.simulation();
  std::vector<double> first;
  const auto keep_roll = [&](std::vector<double>& into) {
    return [&](std::size_t, const Series& series) {
      into.insert(into.end(), series[3].begin(), series[3].end());
    };
  };
  static_cast<void>(run(simulation, scene.watch, {}, 9, keep_roll(first)));
  Simulation again = scene.simulation();
  std::vector<double> second;
  static_cast<void>(run(again, scene.watch, {}, 9, keep_roll(second)));
  EXPECT_EQ(first, second);
  std::vector<double> other;
  static_cast<void>(run(again, scene.watch, {}, 10, keep_roll(other)));
  EXPECT_NE(first, other);
}

TEST(Simulation, ABlockDoesNotDependOnThoseBeforeIt) {
  Scene scene(5.0, 9.0, 90.0, 25.0, 15.0);
  scene.plan.hours = 4.0;
  scene.plan.steps_roll = true;
  Simulation simulation = scene.simulation();
  BinAmplitudes third;
  make_block(simulation, 9, 2, third);
  for (std::size_t b = 0; b < 3; ++b) {
    BinAmplitudes block;
    make_block(simulation, 9, b, block);
    EXPECT_EQ(block.re == third.re, b == 2) << b;
  }
}

TEST(Simulation, AMirroredSeaMovesHerAsMuch) {
  const Scene starboard(5.0, 9.0, 60.0, 25.0, 15.0);
  const Scene port(5.0, 9.0, -60.0, 25.0, 15.0);
  const Simulation one = starboard.simulation();
  const Simulation other = port.simulation();
  for (std::size_t c = 0; c < starboard.watch.channels.size(); ++c) {
    const SpectralMoments a =
        channel_moments(one.answers, starboard.watch.channels[c], one.answers.wave_row[c]);
    const SpectralMoments b =
        channel_moments(other.answers, port.watch.channels[c], other.answers.wave_row[c]);
    EXPECT_NEAR(a.m0 / b.m0, 1.0, 1e-5) << c;  // single precision, other order
    EXPECT_NEAR(a.m2 / b.m2, 1.0, 1e-5) << c;
  }
}

TEST(Simulation, LinearMotionsAreGaussian) {
  Scene scene(5.0, 9.0, 90.0, 25.0, 15.0);
  scene.plan.hours = 100.0;
  scene.watch_only({{Quantity::kHeave, 0}, {Quantity::kRoll, 0}, {Quantity::kPitch, 0}});
  Simulation simulation = scene.simulation();
  const Outcome got = run(simulation, scene.watch, {}, 4);
  // Some 20,000 waves in groups of four (roll: ten): sqrt(24 / 5,000) = 0.07 is a generous standard error.
  for (const ChannelOutcome& channel : got.channels) {
    EXPECT_NEAR(channel.kurtosis, 3.0, 0.1);
  }
}

// Ochi's slam on a process made by hand: one row of cells that is the relative motion itself.
Simulation synthetic_motion(double least_omega, double most_omega) {
  Simulation out;
  out.num_blocks = 200;
  out.block_s = 3600.0;
  out.num_samples = 16384;
  out.answers.num_rows = kWaveRow + 1;
  out.answers.step = kTwoPi / out.block_s;
  out.answers.wave_row = {kWaveRow};
  const auto first = static_cast<std::uint32_t>(least_omega / out.answers.step);
  const auto last = static_cast<std::uint32_t>(most_omega / out.answers.step);
  for (std::uint32_t n = first; n <= last; ++n) {
    out.answers.bin.push_back(n);
    for (std::size_t row = 0; row < out.answers.num_rows; ++row) {
      out.answers.re.push_back(row == kWaveRow ? 0.1F : 0.0F);
      out.answers.im.push_back(0.0F);
    }
  }
  out.answers.num_bins = last + 1;
  return out;
}

Watch one_relative_motion() {
  Watch out;
  Channel channel{.quantity = Quantity::kSlamming};
  channel.form.wave = 1.0;
  EXPECT_TRUE(out.channels.push_back(channel));
  return out;
}

TEST(Counting, SlamsOfASyntheticProcessAreOchis) {
  Simulation simulation = synthetic_motion(0.5, 1.3);
  const Watch watch = one_relative_motion();
  const SpectralMoments m = channel_moments(simulation.answers, watch.channels[0], kWaveRow);
  std::vector<Question> questions;
  for (const auto& [draught, speed] : {std::pair(1.0, 0.5), std::pair(2.0, 1.0), std::pair(1.0, 2.0)}) {
    questions.push_back({0, Passing::kReentry, draught * std::sqrt(m.m0), speed * std::sqrt(m.m2)});
  }
  const Outcome got = run(simulation, watch, questions, 3);
  EXPECT_NEAR(got.channels[0].t2 / (kTwoPi * std::sqrt(m.m0 / m.m2)), 1.0, 0.003);  // 100,000 cycles
  const std::array<double, 3> exponents = {0.5 * (1.0 + 0.25), 0.5 * (4.0 + 1.0), 0.5 * (1.0 + 4.0)};
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Answer& answer = got.answers[i];
    const double expected = std::exp(-exponents[i]);                            // [Ochi1964]
    EXPECT_NEAR(answer.events / answer.encounters / expected, 1.0, 0.04) << i;  // 8,000 events in groups
    // Of ratio_interval(): two standard errors at most are covered by 1.2 times the interval and more.
    const auto interval = ratio_interval(answer.per_encounter);
    ASSERT_TRUE(interval.has_value());
    EXPECT_LT(interval->low, 1.02 * expected);
    EXPECT_GT(interval->high, 0.98 * expected);
  }
}

// Narrow-banded: a crossing of u is that of the envelope's excursion, a cycle each, and the cycles above are
// exp(-u^2 / 2 m0) of all; with a wide band one cycle may have several.
TEST(Counting, ANarrowBandHasOneCrossingACycleAndAWideOneMore) {
  const Watch watch = one_relative_motion();
  Simulation narrow = synthetic_motion(0.78, 0.82);
  const double m0 = channel_moments(narrow.answers, watch.channels[0], kWaveRow).m0;
  const std::vector<Question> above = {{0, Passing::kAbove, std::sqrt(m0), 0.0}};
  const Outcome of_narrow = run(narrow, watch, above, 3);
  const Answer& one = of_narrow.answers[0];
  EXPECT_NEAR(one.events / one.encounters, std::exp(-0.5), 0.01);  // groups of forty: 2,000 of them
  EXPECT_EQ(one.encounters_with_event, one.events);
  EXPECT_LT(of_narrow.channels[0].bandwidth, 0.1);
  Simulation wide = synthetic_motion(0.05, 1.5);
  const double wide_m0 = channel_moments(wide.answers, watch.channels[0], kWaveRow).m0;
  const std::vector<Question> above_wide = {{0, Passing::kAbove, std::sqrt(wide_m0), 0.0}};
  const Outcome of_wide = run(wide, watch, above_wide, 3);
  const Answer& several = of_wide.answers[0];
  EXPECT_NEAR(several.events / several.encounters, std::exp(-0.5), 0.01);  // Rice: crossings all the same
  EXPECT_LT(several.encounters_with_event, 0.97 * several.events);
  // White between 0 and omega: m_n = omega^(n+1) / (n + 1), so m2^2 / (m0 m4) = 5/9.
  // Crests less than a sample apart are not told from one: omega dt = 0.33.
  EXPECT_NEAR(of_wide.channels[0].bandwidth, std::sqrt(4.0 / 9.0), 0.02);
}

TEST(Simulation, RefusesHoursOutsideItsRange) {
  Scene scene(5.0, 9.0, 90.0, 0.0, 0.0);
  for (const double hours : {0.0, -1.0, 2.0 * kMostHours, std::nan("")}) {
    scene.plan.hours = hours;
    EXPECT_FALSE(prepare(*scene.loaded, scene.watch, scene.beams(), scene.plan).ok()) << hours;
  }
}

}  // namespace
}  // namespace quickstrip::seaway
