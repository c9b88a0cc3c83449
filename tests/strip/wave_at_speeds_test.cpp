// The grid is solved for many speeds at once, its sums taken at nodes of encounter frequency: the same as one
// wave at one speed after the other.
#include "core/strip/wave_at_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/strip/transfer_functions.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr std::array<double, 3> kSpeeds = {0.0, 6.0, 12.0};  // an odd number: the last one has no partner

// A row of the grid against the same waves one by one, relative to the largest of the row. Stored as floats:
// 6e-8; the rest is rounding of sums that cancel.
constexpr double kRounding = 1e-6;

void expect_the_same_one_by_one(const Hull& hull, const StripMethod& method, const HullTable* table) {
  const auto ship = std::make_unique<LoadedHull>();
  const auto grid = std::make_unique<TransferFunctions>();
  const auto work = std::make_unique<TransferWorkspace>();
  ASSERT_TRUE(load(hull, hull.loading, method, *ship, table).ok());
  ASSERT_TRUE(solve_transfer_functions(*ship, kSpeeds, *work, *grid).ok());
  for (std::size_t v = 0; v < kSpeeds.size(); ++v) {
    for (std::size_t m = 0; m < kNumSolvedDirections; m += 3) {
      std::array<double, 6> largest{};
      std::array<double, 6> error{};
      double largest_resistance = 0.0;
      double error_of_resistance = 0.0;
      for (std::size_t f = 0; f < grid->num_frequencies; ++f) {
        const EncounterAngle mu = solved_angle(m);
        const MotionTransfer one = motion_transfer(*ship, grid->omega[f], mu, kSpeeds[v]);
        for (std::size_t i = 0; i < 6; ++i) {
          const Complex stored(static_cast<double>(grid->row[v][m].re[i][f]),
                               static_cast<double>(grid->row[v][m].im[i][f]));
          largest[i] = std::max(largest[i], std::abs(one.motion[i]));
          error[i] = std::max(error[i], std::abs(stored - one.motion[i]));
        }
        const double resistance = added_resistance(*ship, grid->omega[f], mu, kSpeeds[v], one);
        largest_resistance = std::max(largest_resistance, std::fabs(resistance));
        error_of_resistance =
            std::max(error_of_resistance,
                     std::fabs(static_cast<double>(grid->added_resistance[v][m][f]) - resistance));
      }
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_LE(error[i], kRounding * largest[i] + 1e-15) << "motion " << i + 1 << ", direction " << m;
      }
      EXPECT_LE(error_of_resistance, kRounding * largest_resistance + 1e-6) << "direction " << m;
    }
  }
}

TEST(WaveAtSpeeds, GridIsTheSameAsWavesOneByOne) {
  expect_the_same_one_by_one(test::s175(), {}, nullptr);
}

TEST(WaveAtSpeeds, SoByTheModifiedMethod) {
  StripMethod modified;
  modified.variant = StripVariant::kModified;
  expect_the_same_one_by_one(test::s175(), modified, nullptr);
}

TEST(WaveAtSpeeds, SoByThePapersMethodWhereLoadsAreForcedToZero) {
  expect_the_same_one_by_one(test::s175(), kPaperMethod, nullptr);
}

TEST(WaveAtSpeeds, SoWithLoadsByBoundaryValues) {
  const Hull hull = test::s175();
  const CompiledHullTable compiled =
      compile_hull_table(hull, HullSections::kLewis, {{9.25, 9.75, 10.25}, {}});
  const Result<HullTable> table = HullTable::view(compiled.words);
  ASSERT_TRUE(table.ok());
  StripMethod method;
  method.loads = DiffractionLoads::kBoundaryValue;
  expect_the_same_one_by_one(hull, method, &*table);
  method.variant = StripVariant::kModified;
  expect_the_same_one_by_one(hull, method, &*table);
}

// A ship of 350 m at 12 m/s meets the shortest waves of the grid above the last node of her coefficients.
TEST(WaveAtSpeeds, SoBeyondTheNodesOfEncounterFrequency) {
  expect_the_same_one_by_one(test::scaled(test::wigley_hull(1, 21), 350.0 / 3.0), {}, nullptr);
}

}  // namespace
}  // namespace quickstrip
