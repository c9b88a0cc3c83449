// The all-knowing pilot against every voyage there is; the storms; one storm sailed.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/advice/nordforsk.hpp"
#include "msgs/convert/units.hpp"
#include "sim/pilot/regret.hpp"
#include "sim/pilot/storm.hpp"
#include "sim/pilot/truth.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::pilot {
namespace {

/// Two speeds, two headings.
TrueGrid small_grid(std::mt19937& random) {
  TrueGrid grid;
  grid.num_speeds = 2;
  grid.num_headings = 2;
  for (std::size_t v = 0; v < 2; ++v) {
    for (std::size_t h = 0; h < 2; ++h) {
      grid.cells[v][h] = static_cast<Hours>(random() % 3);
    }
  }
  return grid;
}

/// Least exceeded, then least not judged, over all voyages of at most four changes a watch.
struct Least {
  double exceeded = 1e9;
  double not_judged = 1e9;
};
Least by_trying_all(const std::vector<TrueGrid>& truth) {
  Least least;
  const std::size_t n = truth.size();
  for (std::size_t code = 0; code < (std::size_t{1} << (2 * n)); ++code) {
    std::vector<CellIndex> sailed;
    for (std::size_t t = 0; t < n; ++t) {
      const std::size_t cell = (code >> (2 * t)) & 3U;
      sailed.push_back({cell / 2, cell % 2});
    }
    const Tally sum = tally(truth, sailed, {0, 0});
    if (sum.most_changes_in_a_watch > kChangesPerWatch) {
      continue;
    }
    if (sum.exceeded_h < least.exceeded ||
        (sum.exceeded_h == least.exceeded && sum.not_judged_h < least.not_judged)) {
      least = {sum.exceeded_h, sum.not_judged_h};
    }
  }
  return least;
}

TEST(AllKnowingPilot, NoVoyageOfAllIsBetter) {
  std::mt19937 random(3);
  for (int round = 0; round < 4; ++round) {
    std::vector<TrueGrid> truth;
    for (int t = 0; t < 9; ++t) {  // more than a watch
      truth.push_back(small_grid(random));
    }
    const std::vector<CellIndex> sailed = all_knowing_pilot(truth, {0, 0});
    ASSERT_EQ(sailed.size(), truth.size());
    const Tally sum = tally(truth, sailed, {0, 0});
    const Least least = by_trying_all(truth);
    EXPECT_LE(sum.most_changes_in_a_watch, kChangesPerWatch);
    EXPECT_EQ(sum.exceeded_h, least.exceeded);
    EXPECT_EQ(sum.not_judged_h, least.not_judged);
  }
}

TEST(AllKnowingPilot, StaysOnTheIntendedCourseWhileThatIsInsideAndNeverLosesSteerage) {
  TrueGrid grid;
  grid.num_speeds = 3;
  grid.num_headings = 4;
  std::vector<TrueGrid> truth(20, grid);
  for (const CellIndex cell : all_knowing_pilot(truth, {2, 1})) {
    EXPECT_EQ(cell.speed, 2U);
    EXPECT_EQ(cell.heading, 1U);
  }
  for (TrueGrid& hour : truth) {
    for (std::size_t h = 0; h < 4; ++h) {
      hour.cells[0][h] = Hours::kNoSteerage;
      hour.cells[1][h] = Hours::kExceeded;
      hour.cells[2][h] = Hours::kExceeded;
    }
  }
  for (const CellIndex cell : all_knowing_pilot(truth, {2, 1})) {
    EXPECT_NE(cell.speed, 0U);
  }
}

TEST(Storms, OfASeedAreTheSameAndRiseAndFallAndStayInTheirRanges) {
  for (std::uint64_t seed = 1; seed <= 19; ++seed) {
    const Storm storm = synthetic_storm(seed);
    const Storm again = synthetic_storm(seed);
    ASSERT_EQ(storm.num_half_hours(), 60U);
    double highest = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
      ASSERT_EQ(storm.states[i].systems.size(), 2U);
      const WaveSystem& wind_sea = storm.states[i].systems[0];
      EXPECT_EQ(wind_sea.hs, again.states[i].systems[0].hs);
      highest = std::max(highest, wind_sea.hs);
      // Steepness 2 pi Hs / g Tp^2 = 2 pi / (g c^2): 1/15 ... 1/26 or so. What breaks is 1/7.
      const double steepness = kTwoPi * wind_sea.hs / (9.81 * wind_sea.period * wind_sea.period);
      EXPECT_GT(steepness, 0.026);
      EXPECT_LT(steepness, 0.039);
    }
    EXPECT_GE(highest, 3.9);
    EXPECT_LE(highest, 9.0);
    EXPECT_LT(storm.states[0].systems[0].hs, 0.8 * highest);
    EXPECT_LT(storm.states[59].systems[0].hs, 0.8 * highest);
    EXPECT_NEAR(std::remainder(degrees(storm.intended.radians), 5.0), 0.0, 1e-9);
  }
}

TEST(Regret, ShareIsOfWhatCanBeRemoved) {
  const auto hours = [](double h) { return Tally{h, 0.0, 0, 0}; };
  EXPECT_EQ(removed_share(hours(10.0), hours(2.0), hours(0.0)), 0.8);
  EXPECT_EQ(removed_share(hours(10.0), hours(6.0), hours(2.0)), 0.5);
  EXPECT_EQ(removed_share(hours(10.0), hours(12.0), hours(0.0)), -0.2);
  EXPECT_EQ(removed_share(hours(3.0), hours(3.0), hours(3.0)), 1.0);
}

TEST(Regret, WhoFollowsTheAdviceExceedsLessThanWhoHoldsOnAndNoLessThanWhoKnowsAll) {
  const Hull hull = test::s175();
  const Result<Criteria> criteria = nordforsk_merchant(hull);
  ASSERT_TRUE(criteria);
  const auto sailing = std::make_unique<Sailing>();
  ASSERT_TRUE(sailing->configure(hull, *criteria, {}));
  Storm storm = synthetic_storm(1);
  storm.states.erase(storm.states.begin(), storm.states.begin() + 16);
  storm.states.resize(16);  // its worst eight hours
  StormResult first;
  StormResult again;
  ASSERT_TRUE(sailing->sail(storm, {}, kChangesInside, 5, first));
  EXPECT_EQ(first.hours, 8.0);
  EXPECT_GT(first.hold.exceeded_h, 2.0);
  EXPECT_LT(first.follow.exceeded_h, first.hold.exceeded_h);
  EXPECT_LE(first.all_knowing.exceeded_h, first.follow.exceeded_h);
  EXPECT_LE(first.follow.most_changes_in_a_watch, kChangesPerWatch);
  EXPECT_EQ(first.hold.num_changes, 0);
  ASSERT_TRUE(sailing->sail(storm, {}, kChangesInside, 5, again));  // nothing of the first is remembered
  EXPECT_EQ(again.follow.exceeded_h, first.follow.exceeded_h);
  EXPECT_EQ(again.follow.num_changes, first.follow.num_changes);
}

}  // namespace
}  // namespace quickstrip::pilot
