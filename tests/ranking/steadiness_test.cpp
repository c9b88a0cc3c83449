// What is worse is shown at once, what is better waits: on grids made by hand.
#include "core/advice/steadiness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kStart = 1.6e9;  // s: as far from zero as the epoch

class SteadinessTest : public testing::Test {
 protected:
  SteadinessTest() {
    grid_->num_speeds = 4;
    grid_->num_headings = 36;
    for (std::size_t v = 0; v < 4; ++v) {
      grid_->speeds[v] = 4.0 * kKnot * static_cast<double>(v);
    }
    QS_CHECK(criteria_.push_back({.name = Name("roll"), .limit = 0.1, .caution_fraction = 0.75}));
    steady_.configure({.dwell = 600.0});
  }
  /// A cycle at `time` s in which every cell is as given; what is shown of one cell.
  Verdict cycle(double time, Verdict now, float margin, int source = 0) {
    for (std::size_t v = 0; v < 4; ++v) {
      grid_->cells[v].fill(Cell{.verdict = now, .governing = 0, .margin = margin});
    }
    steady_.begin(kStart + time, source);
    steady_.steady(criteria_, *grid_);
    return grid_->cells[2][7].verdict;
  }
  Steadiness::Shown present(Verdict now, float margin, double heading_deg = 70.0, double knots = 8.0) {
    const Cell cell{.verdict = now, .governing = 0, .margin = margin};
    return steady_.present(criteria_, *grid_, {{radians(heading_deg)}, knots * kKnot, false}, cell);
  }

  std::unique_ptr<Grid> grid_ = std::make_unique<Grid>();
  Criteria criteria_;
  Steadiness steady_;
};

TEST_F(SteadinessTest, WorseIsShownInTheSameCycle) {
  EXPECT_EQ(cycle(0, Verdict::kGood, 2.0F), Verdict::kGood);
  EXPECT_EQ(cycle(1, Verdict::kCaution, 1.2F), Verdict::kCaution);
  EXPECT_EQ(cycle(2, Verdict::kUnknown, 1.2F), Verdict::kUnknown);
  EXPECT_EQ(cycle(3, Verdict::kExceeded, 0.9F), Verdict::kExceeded);
}

TEST_F(SteadinessTest, BetterIsShownAfterTheDwell) {
  cycle(0, Verdict::kExceeded, 0.9F);
  EXPECT_EQ(cycle(1, Verdict::kGood, 2.0F), Verdict::kExceeded);
  for (double t = 2; t < 600.0; t += 1.0) {
    ASSERT_EQ(cycle(t, Verdict::kGood, 2.0F), Verdict::kExceeded) << t;
  }
  // From 1 s on; the ticks of a cell are 0.15 s.
  EXPECT_EQ(cycle(600.0, Verdict::kGood, 2.0F), Verdict::kExceeded);
  EXPECT_EQ(cycle(602.0, Verdict::kGood, 2.0F), Verdict::kGood);
}

TEST_F(SteadinessTest, TheWaitIsTheSameWhateverTheCyclePeriod) {
  for (const double period : {0.1, 1.0, 7.3, 60.0, 599.0}) {
    steady_.configure({.dwell = 600.0});
    cycle(0, Verdict::kExceeded, 0.9F);
    cycle(period, Verdict::kGood, 2.0F);  // better from here on
    double t = period;
    do {
      t += period;
    } while (cycle(t, Verdict::kGood, 2.0F) == Verdict::kExceeded && t < 2000.0);
    EXPECT_GE(t, period + 600.0 - 0.15);
    EXPECT_LE(t, period + 600.0 + period + 0.15);
  }
}

TEST_F(SteadinessTest, OneWorseCycleStartsTheWaitAgain) {
  cycle(0, Verdict::kExceeded, 0.9F);
  for (double t = 60.0; t <= 540.0; t += 60.0) {
    cycle(t, Verdict::kGood, 2.0F);
  }
  cycle(600.0, Verdict::kExceeded, 0.99F);
  for (double t = 660.0; t <= 1200.0; t += 60.0) {
    EXPECT_EQ(cycle(t, Verdict::kGood, 2.0F), Verdict::kExceeded) << t;
  }
  EXPECT_EQ(cycle(1261.0, Verdict::kGood, 2.0F), Verdict::kGood);
}

TEST_F(SteadinessTest, AfterTheDwellTheWorstOfItIsShown) {
  cycle(0, Verdict::kExceeded, 0.9F);
  cycle(60, Verdict::kGood, 2.0F);
  cycle(120, Verdict::kCaution, 1.2F);
  for (double t = 180.0; t < 660.0; t += 60.0) {
    EXPECT_EQ(cycle(t, Verdict::kGood, 2.0F), Verdict::kExceeded);
  }
  EXPECT_EQ(cycle(661.0, Verdict::kGood, 2.0F), Verdict::kCaution);
}

TEST_F(SteadinessTest, HardlyBetterWaitsThreeTimesAsLongAndNotForEver) {
  cycle(0, Verdict::kExceeded, 0.99F);
  double t = 0.0;
  while (cycle(t += 1.0, Verdict::kCaution, 1.02F) == Verdict::kExceeded && t < 4000.0) {
  }
  EXPECT_NEAR(t, 1.0 + 1800.0, 1.0);
  // At a caution fraction of 0.75 good begins at 1.333 and is clear at 1.4.
  steady_.configure({.dwell = 600.0});
  cycle(0, Verdict::kCaution, 1.2F);
  t = 0.0;
  while (cycle(t += 1.0, Verdict::kGood, 1.36F) == Verdict::kCaution && t < 4000.0) {
  }
  EXPECT_NEAR(t, 1.0 + 1800.0, 1.0);
  steady_.configure({.dwell = 600.0});
  cycle(0, Verdict::kCaution, 1.2F);
  t = 0.0;
  while (cycle(t += 1.0, Verdict::kGood, 1.41F) == Verdict::kCaution && t < 4000.0) {
  }
  EXPECT_NEAR(t, 1.0 + 600.0, 1.0);
}

TEST_F(SteadinessTest, EverythingIsShownAtOnceWhenTimeJumps) {
  for (const double jump : {-1.0, -1e6, 601.0, 1e6, std::numeric_limits<double>::quiet_NaN()}) {
    steady_.configure({.dwell = 600.0});
    cycle(0, Verdict::kExceeded, 0.9F);
    cycle(10, Verdict::kExceeded, 0.9F);
    EXPECT_EQ(cycle(10.0 + jump, Verdict::kGood, 2.0F), Verdict::kGood) << jump;
  }
  // A gap of the dwell is none.
  steady_.configure({.dwell = 600.0});
  cycle(0, Verdict::kExceeded, 0.9F);
  EXPECT_EQ(cycle(600.0, Verdict::kGood, 2.0F), Verdict::kExceeded);
}

TEST_F(SteadinessTest, TwoCyclesAtOneTimeShowTheWorse) {
  cycle(0, Verdict::kExceeded, 0.9F);
  EXPECT_EQ(cycle(0, Verdict::kGood, 2.0F), Verdict::kExceeded);
}

TEST_F(SteadinessTest, AnotherKindOfSourceIsShownAtOnceButNotTwoInTurn) {
  cycle(0, Verdict::kExceeded, 0.9F, 1);
  EXPECT_EQ(cycle(1, Verdict::kGood, 2.0F, 2), Verdict::kGood);
  cycle(2, Verdict::kExceeded, 0.9F, 1);
  EXPECT_EQ(cycle(3, Verdict::kGood, 2.0F, 2), Verdict::kExceeded);
}

TEST_F(SteadinessTest, WithoutADwellNothingWaits) {
  steady_.configure({.dwell = 0.0});
  cycle(0, Verdict::kExceeded, 0.9F);
  EXPECT_EQ(cycle(1, Verdict::kGood, 1.34F), Verdict::kGood);
  EXPECT_EQ(present(Verdict::kGood, 1.34F).verdict, Verdict::kGood);
}

TEST_F(SteadinessTest, ThePresentVerdictWaitsAndSaysHowLong) {
  cycle(0, Verdict::kExceeded, 0.9F);
  EXPECT_EQ(present(Verdict::kExceeded, 0.9F).better_in, 0.0);
  cycle(60, Verdict::kGood, 2.0F);
  EXPECT_EQ(present(Verdict::kGood, 2.0F).better_in, 600.0);
  cycle(120, Verdict::kGood, 2.0F);
  const Steadiness::Shown shown = present(Verdict::kGood, 2.0F, 74.0, 9.0);  // yaws
  EXPECT_EQ(shown.verdict, Verdict::kExceeded);
  EXPECT_EQ(shown.better_in, 540.0);
  cycle(180, Verdict::kCaution, 1.02F);
  EXPECT_NEAR(present(Verdict::kCaution, 1.02F).better_in, 3.0 * 520.0,
              1e-9);  // hardly better: 60 s count 20
}

TEST_F(SteadinessTest, OnAnotherCourseThereIsNothingToWaitForButItsOwnCell) {
  // Every cell but those about 200 degrees is exceeded, and has been.
  const auto cells = [&](double time, Verdict to) {
    steady_.begin(kStart + time, 0);
    for (std::size_t v = 0; v < 4; ++v) {
      grid_->cells[v].fill(Cell{.verdict = Verdict::kExceeded, .governing = 0, .margin = 0.9F});
      grid_->cells[v][20] = Cell{.verdict = to, .governing = 0, .margin = 2.0F};
    }
    steady_.steady(criteria_, *grid_);
  };
  cells(0, Verdict::kGood);
  EXPECT_EQ(present(Verdict::kExceeded, 0.9F).verdict, Verdict::kExceeded);
  cells(60, Verdict::kGood);
  EXPECT_EQ(present(Verdict::kGood, 2.0F, 200.0).verdict, Verdict::kGood);
  // Had that cell itself been bad a minute ago, she would wait as it does.
  cells(120, Verdict::kExceeded);
  EXPECT_EQ(present(Verdict::kExceeded, 0.9F).verdict, Verdict::kExceeded);
  cells(180, Verdict::kGood);
  cells(240, Verdict::kGood);
  const Steadiness::Shown shown = present(Verdict::kGood, 2.0F, 200.0);
  EXPECT_EQ(shown.verdict, Verdict::kExceeded);
  EXPECT_NEAR(shown.better_in, 540.0, 0.15);
}

TEST_F(SteadinessTest, OnRandomSeriesWorseNeverWaitsAndBetterAlwaysDoes) {
  // By definition: shown is never better than now; and it became better only if all cycles of a dwell were.
  std::mt19937 random(302);
  std::vector<std::pair<double, int>> history;
  int shown_before = -1;
  std::size_t improved = 0;
  double time = 0.0;
  double changed = 0.0;  // when what is shown did last
  for (int i = 0; i < 20'000; ++i) {
    time += 0.5 + 60.0 * std::uniform_real_distribution<double>(0.0, 1.0)(random);
    const bool calm = (i / 50) % 2 == 0;
    const auto now = calm && random() % 20 != 0 ? Verdict::kGood : static_cast<Verdict>(random() % 4);
    const int shown = severity(cycle(time, now, 2.0F));
    history.emplace_back(time, severity(now));
    ASSERT_GE(shown, severity(now));
    if (shown < shown_before) {
      ++improved;
      int worst = 0;
      double since = time;
      for (auto it = history.rbegin();
           it != history.rend() && it->second < shown_before && it->first > changed; ++it) {
        since = it->first;
        worst = std::max(worst, it->second);
      }
      ASSERT_GE(time - since, 600.0 - 0.31) << i;
      ASSERT_EQ(shown, worst) << i;
    }
    changed = shown == shown_before ? changed : time;
    shown_before = shown;
  }
  EXPECT_GT(improved, 50u);
}

TEST_F(SteadinessTest, ARecommendationIsKnownAgainUntilItIsReached) {
  Advice advice;
  ASSERT_TRUE(advice.changes.push_back({.heading = radians(120.0),
                                        .speed = 6.0 * kKnot,
                                        .heading_change = radians(50.0),
                                        .speed_change = -2.0 * kKnot}));
  steady_.follow(advice);
  const Standing at_first = steady_.standing({{radians(70.0)}, 8.0 * kKnot, false});
  EXPECT_TRUE(at_first.is_there && at_first.turns && at_first.changes_speed);
  EXPECT_EQ(at_first.side, 1);
  const Standing turned = steady_.standing({{radians(119.0)}, 8.0 * kKnot, false});
  EXPECT_TRUE(turned.is_there && !turned.turns && turned.changes_speed);
  EXPECT_FALSE(steady_.standing({{radians(119.0)}, 6.2 * kKnot, false}).is_there);
  steady_.follow(Advice{});
  EXPECT_FALSE(steady_.standing({{radians(70.0)}, 8.0 * kKnot, false}).is_there);
}

}  // namespace
}  // namespace quickstrip
