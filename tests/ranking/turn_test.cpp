// The way from one course and speed to another, on grids made by hand.
#include "core/advice/turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/response/short_term.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kMinute = 60.0;

class TurnTest : public testing::Test {
 protected:
  /// Speeds 0 ... 12 kn by 2, headings by 10 degrees, all good; the ship turns 30 degrees a minute, slows
  /// down by 1 kn and speeds up by half a knot a minute.
  TurnTest() {
    grid_->num_speeds = 7;
    grid_->num_headings = 36;
    for (std::size_t v = 0; v < 7; ++v) {
      grid_->speeds[v] = 2.0 * kKnot * static_cast<double>(v);
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h] =
            Cell{.verdict = Verdict::kGood, .governing = 0, .margin = 2.0F, .rms_roll = 0.02F};
      }
    }
  }
  void exceed(std::size_t degrees_true, float margin) {
    for (std::size_t v = 0; v < 7; ++v) {
      grid_->cells[v][degrees_true / 10].verdict = Verdict::kExceeded;
      grid_->cells[v][degrees_true / 10].margin = margin;
    }
  }
  static TurnStart at(double degrees_true, double knots, double roll_period = 15.0) {
    return {.heading = {radians(degrees_true)}, .speed = knots * kKnot, .roll_period = roll_period};
  }
  static Way way(double turn_degrees, double knots) { return {radians(turn_degrees), knots * kKnot}; }

  std::unique_ptr<Grid> grid_ = std::make_unique<Grid>();
};

TEST_F(TurnTest, TakesAsLongAsTheSlowerOfCourseAndSpeed) {
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(0, 10), way(90, 0)).time), 3.0 * kMinute, 1e-3);
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(0, 10), way(0, -4)).time), 4.0 * kMinute, 1e-3);
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(0, 6), way(0, 4)).time), 8.0 * kMinute, 1e-3);
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(0, 10), way(90, -4)).time), 4.0 * kMinute, 1e-3);
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(0, 10), way(90, -1)).time), 3.0 * kMinute, 1e-3);
}

TEST_F(TurnTest, SpendsInACellTheTimeThatItsBreadthTakes) {
  exceed(50, 0.5F);
  // 10 degrees at 30 degrees a minute, whichever side the ship comes from.
  for (const auto& [from, turn] :
       {std::pair{0.0, 90.0}, {90.0, -90.0}, {355.0, 100.0}, {51.0 + 9.0, -40.0}}) {
    const Turn met = sum_up_turn(*grid_, at(from, 10), way(turn, 0));
    EXPECT_NEAR(static_cast<double>(met.time_exceeded), 20.0, 1e-3) << from;
    EXPECT_EQ(met.worst_verdict, Verdict::kExceeded);
    EXPECT_NEAR(degrees(static_cast<double>(met.worst_heading)), 50.0, 1e-3);
    EXPECT_EQ(met.worst_margin, 0.5F);
  }
  // It begins in the middle of the cell, or ends there: half of it.
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(50, 10), way(40, 0)).time_exceeded), 10.0, 1e-3);
  EXPECT_NEAR(static_cast<double>(sum_up_turn(*grid_, at(90, 10), way(-40, 0)).time_exceeded), 10.0, 1e-3);
  // The other way round does not pass it.
  EXPECT_EQ(sum_up_turn(*grid_, at(0, 10), way(-270, 0)).time_exceeded, 0.0F);
  EXPECT_EQ(sum_up_turn(*grid_, at(90, 10), way(270, 0)).time_exceeded, 0.0F);
}

TEST_F(TurnTest, ExposureIsTheTimeTimesHowMuchWorse) {
  exceed(50, 0.5F);  // badness 2
  EXPECT_NEAR(turn_exposure(*grid_, at(0, 10), way(90, 0), 0.5), 20.0 * (2.0 - 1.0), 1e-9);
  EXPECT_NEAR(turn_exposure(*grid_, at(0, 10), way(90, 0), 1.6), 20.0 * (2.0 - 1.6), 1e-9);
  EXPECT_EQ(turn_exposure(*grid_, at(0, 10), way(90, 0), 2.5), 0.0);
  EXPECT_EQ(turn_exposure(*grid_, at(0, 10), way(-90, 0), 0.5), 0.0);
}

TEST_F(TurnTest, ASevereZoneAndTheUnknownCountWhateverTheirMargin) {
  Cell zone{
      .verdict = Verdict::kExceeded, .governing = 0, .hazards = kHazardParametricRollGrows, .margin = 9.0F};
  EXPECT_EQ(badness(zone), kSevereZoneBadness);
  EXPECT_EQ(badness(Cell{.verdict = Verdict::kUnknown, .governing = 0, .margin = 9.0F}), 1.0);
  EXPECT_EQ(badness(Cell{}), 1.0);
  EXPECT_NEAR(badness(Cell{.verdict = Verdict::kCaution, .governing = 0, .margin = 1.25F}), 0.8, 1e-7);
  EXPECT_EQ(badness(Cell{.verdict = Verdict::kExceeded, .governing = 0, .margin = 0.0F}), kWorstBadness);
}

/// By small steps of time and the nearest cell: what the walk must sum up.
struct Sampled {
  double time = 0.0;
  double exceeded = 0.0;
  double exposure = 0.0;
  double worst = 0.0;
  std::vector<double> rms;
};
Sampled sample(const Grid& grid, const TurnStart& start, const Way& way, double reference) {
  constexpr int kSteps = 40'000;
  const double rate = way.speed_change > 0.0 ? start.handling.speeding_up : start.handling.slowing;
  const double course_time = std::abs(way.heading_change) / start.handling.turn_rate;
  const double speed_time = std::abs(way.speed_change) / rate;
  Sampled out;
  out.time = std::max(course_time, speed_time);
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps * out.time;
    const double heading = start.heading.radians + way.heading_change * std::min(t / course_time, 1.0);
    const double speed =
        start.speed + (speed_time > 0.0 ? way.speed_change * std::min(t / speed_time, 1.0) : 0.0);
    std::size_t v = 0;
    for (std::size_t k = 1; k < grid.num_speeds; ++k) {
      if (std::abs(grid.speeds[k] - speed) < std::abs(grid.speeds[v] - speed)) {
        v = k;
      }
    }
    const auto h = static_cast<std::size_t>(std::llround(degrees(wrap_two_pi(heading)) / 10.0)) % 36;
    const Cell& cell = grid.cells[v][h];
    out.exceeded += cell.verdict == Verdict::kExceeded ? out.time / kSteps : 0.0;
    out.exposure += std::max(0.0, badness(cell) - std::max(1.0, reference)) * out.time / kSteps;
    out.worst = std::max(out.worst, badness(cell));
    out.rms.push_back(static_cast<double>(cell.rms_roll));
  }
  return out;
}

TEST_F(TurnTest, AgreesWithSamplingOnRandomGrids) {
  std::mt19937 random(1228);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 60; ++round) {
    for (std::size_t v = 0; v < 7; ++v) {
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h].verdict = static_cast<Verdict>(random() % 4);
        grid_->cells[v][h].margin = static_cast<float>(0.3 + 2.0 * unit(random));
        grid_->cells[v][h].rms_roll = static_cast<float>(0.2 * unit(random));
      }
    }
    const TurnStart start = at(360.0 * unit(random), 12.0 * unit(random), 12.0);
    const Way some = way(700.0 * (unit(random) - 0.5), 12.0 * unit(random) - start.speed / kKnot);
    const double reference = 2.0 * unit(random);
    const Sampled by_steps = sample(*grid_, start, some, reference);
    const Turn met = sum_up_turn(*grid_, start, some);
    const double step = by_steps.time / 40'000.0;
    // A boundary falls anywhere in a step, and there are at most 43 of them.
    EXPECT_NEAR(static_cast<double>(met.time), by_steps.time, 1e-3);
    EXPECT_NEAR(static_cast<double>(met.time_exceeded), by_steps.exceeded, 43.0 * step);
    EXPECT_NEAR(turn_exposure(*grid_, start, some, reference), by_steps.exposure,
                43.0 * kWorstBadness * step);
    // A cell may be touched for less than a step.
    double exponent = 0.0;
    for (const double rms : by_steps.rms) {
      const double ratio = static_cast<double>(met.max_roll) / rms;
      exponent -= step / start.roll_period * std::log1p(-std::exp(-0.5 * ratio * ratio));
    }
    EXPECT_NEAR(exponent, 1.0, 0.01) << round;
    const double worst =
        badness(Cell{.verdict = met.worst_verdict, .governing = 0, .margin = met.worst_margin});
    EXPECT_GE(worst, by_steps.worst - 1e-6);
  }
}

TEST_F(TurnTest, InOneStateTheLargestRollIsTheMostProbableMaximumOfThatTime) {
  // -ln(1 - x) = x + x^2 / 2: for n = 24 the level differs by (1 / 2n) / (2 ln n) = 0.33 %, and the most
  // probable maximum is the larger n's limit. A turn of twelve minutes and a roll period of 30 s.
  const Turn met = sum_up_turn(*grid_, at(0, 12, 30.0), way(0, -12));
  const double rms = static_cast<double>(grid_->cells[0][0].rms_roll);
  const double omega = kTwoPi / 30.0;
  const double most_probable = most_probable_maximum(rms * rms, rms * rms * omega * omega, 12.0 * kMinute);
  EXPECT_NEAR(static_cast<double>(met.max_roll) / most_probable, 1.0033, 0.0007);
}

TEST_F(TurnTest, OneAmplitudeIsAboutItsRms) {
  // sqrt(-2 ln(1 - 1/e)) = 0.9578, for a turn of one roll period.
  const Turn met = sum_up_turn(*grid_, at(0, 12, 20.0), way(10, 0));
  EXPECT_NEAR(static_cast<double>(met.max_roll), 0.9578 * 0.02, 1e-5);
}

TEST_F(TurnTest, OfManyShipsAThirdRollNoFurtherThanSaid) {
  // Amplitudes drawn one a period through a turn past beam seas: the largest stays below what is said in
  // 1/e of the ships. 20,000 of them: three standard deviations of a share are 1 %.
  for (std::size_t h = 0; h < 36; ++h) {
    const double off_beam = radians(10.0 * static_cast<double>(h) - 90.0);
    grid_->cells[5][h].rms_roll = static_cast<float>(0.03 + 0.09 * std::exp(-4.0 * off_beam * off_beam));
  }
  const TurnStart start = at(0.0, 10.0, 10.0);
  const double said = static_cast<double>(sum_up_turn(*grid_, start, way(180, 0)).max_roll);
  std::mt19937 random(41);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  constexpr int kShips = 20'000;
  int below = 0;
  for (int ship = 0; ship < kShips; ++ship) {
    double largest = 0.0;
    for (double t = 10.0 * unit(random); t < 6.0 * kMinute; t += 10.0) {
      const auto h = static_cast<std::size_t>(std::lround(t / kMinute * 3.0));
      const double rms = static_cast<double>(grid_->cells[5][h].rms_roll);
      largest = std::max(largest, rms * std::sqrt(-2.0 * std::log(1.0 - unit(random))));
    }
    below += largest < said ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(below) / kShips, std::exp(-1.0), 0.012);
  EXPECT_GT(degrees(said), degrees(0.12));  // more than the greatest RMS on the way
}

TEST_F(TurnTest, WithoutARollPeriodNoRollIsSaid) {
  EXPECT_EQ(sum_up_turn(*grid_, at(0, 10, 0.0), way(90, 0)).max_roll, kNotComputed);
}

TEST_F(TurnTest, ATurnToTheOtherSideOfTheMirrorMeetsTheSame) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto mirrored = std::make_unique<Grid>(*grid_);
  for (std::size_t v = 0; v < 7; ++v) {
    for (std::size_t h = 0; h < 36; ++h) {
      grid_->cells[v][h].verdict = unit(random) < 0.4 ? Verdict::kExceeded : Verdict::kGood;
      grid_->cells[v][h].margin = static_cast<float>(0.3 + unit(random));
      mirrored->cells[v][(36 - h) % 36] = grid_->cells[v][h];
    }
  }
  for (int round = 0; round < 200; ++round) {
    const double heading = 359.0 * unit(random);
    const double knots = 12.0 * unit(random);
    const Way to_starboard = way(300.0 * unit(random), 12.0 * unit(random) - knots);
    const Way to_port{-to_starboard.heading_change, to_starboard.speed_change};
    const Turn a = sum_up_turn(*grid_, at(heading, knots), to_starboard);
    const Turn b = sum_up_turn(*mirrored, at(-heading, knots), to_port);
    EXPECT_NEAR(a.time_exceeded, b.time_exceeded, 1e-2F);
    EXPECT_EQ(a.worst_margin, b.worst_margin);
    EXPECT_NEAR(a.max_roll, b.max_roll, 1e-6F);
    EXPECT_NEAR(turn_exposure(*grid_, at(heading, knots), to_starboard, 1.0),
                turn_exposure(*mirrored, at(-heading, knots), to_port, 1.0), 1e-6);
  }
}

}  // namespace
}  // namespace quickstrip
