#include "core/advice/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/advice/scene.hpp"

namespace quickstrip {
namespace {

using synthetic::Scene;

constexpr double kFloat = 2e-6;  // relative: cells hold floats; a probability's exponent multiplies rounding

MotionTransfer unit_response(double, double, double) {
  MotionTransfer transfer;
  transfer.motion.fill(1.0);
  return transfer;
}

class GridSweep : public testing::Test {
 protected:
  void add_crossing_seas() {
    synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 7.0, 0, 8);
    synthetic::add_system(scene_->sea, scene_->transfer, 2.0, 11.0, 22, 4);
  }
  // Of every speed and direction its own; the semi-empirical one for the lower speeds.
  void set_resistance() {
    TransferFunctions& transfer = scene_->transfer;
    for (std::size_t v = 0; v < transfer.num_speeds; ++v) {
      transfer.has_empirical_resistance[v] = kKeepsEmpiricalResistance && v < 5;
      for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
        transfer.added_resistance[v][m].fill(1e4F * static_cast<float>(v + 1) - 1e3F * static_cast<float>(m));
        if (transfer.has_empirical_resistance[v]) {
          transfer.empirical_resistance[v][m].fill(2e3F * static_cast<float>(m));
        }
      }
    }
  }
  void only_roll_limit(double rms) {
    scene_->criteria.clear();
    ASSERT_TRUE(scene_->criteria.push_back({.quantity = Quantity::kRoll, .limit = rms}));
    scene_->bind();
  }
  std::unique_ptr<Scene> scene_ = std::make_unique<Scene>();
};

TEST_F(GridSweep, OfAUnitResponseReachesAnRmsLimitAtFourTimesTheLimitInWaveHeight) {
  synthetic::fill(scene_->transfer, 9, 1.0, 40, unit_response);
  const double limit = 0.7;
  only_roll_limit(limit);
  synthetic::add_system(scene_->sea, scene_->transfer, 2.0, 9.0, 5, 6);
  scene_->sweep();
  for (std::size_t v = 0; v < 9; ++v) {
    for (std::size_t h = 0; h < kMaxHeadings; ++h) {
      const Cell& cell = scene_->grid.cells[v][h];
      EXPECT_NEAR(static_cast<double>(cell.rms_roll), 2.0 / 4.0, 1e-7);  // Hs / 4
      EXPECT_NEAR(2.0 * static_cast<double>(cell.margin), 4.0 * limit,
                  4.0 * limit * 2e-7);  // Hs at the limit
    }
  }
}

TEST_F(GridSweep, GivesInEveryCellWhatTheResponseOfThatCellGives) {
  // Two codes: rows applied to all headings, and one cell by itself.
  add_crossing_seas();
  set_resistance();
  scene_->sweep();
  for (std::size_t v = 0; v < 9; ++v) {
    for (std::size_t h = 0; h < kMaxHeadings; ++h) {
      const Heading heading{kTwoPi * static_cast<double>(h) / 72.0};
      ASSERT_TRUE(respond(scene_->inputs(), heading, scene_->grid.speeds[v], scene_->response).ok());
      const Cell& a = scene_->grid.cells[v][h];
      const Cell& b = scene_->response.cell;
      EXPECT_EQ(a.verdict, b.verdict);
      EXPECT_EQ(a.governing, b.governing);
      EXPECT_EQ(a.governing_system, b.governing_system);
      EXPECT_EQ(a.hazards, b.hazards);
      EXPECT_EQ(a.quality, b.quality & ~kQualityWideBand);  // the sweep has no fourth moment
      const auto near = [](float x, float y) {
        const auto size = static_cast<double>(std::max(std::abs(x), std::abs(y)));
        EXPECT_NEAR(static_cast<double>(x), static_cast<double>(y), kFloat * size + 1e-12);
      };
      near(a.margin, b.margin);
      near(a.rms_roll, b.rms_roll);
      near(a.rms_bridge_vertical, b.rms_bridge_vertical);
      near(a.roll_exceedance, b.roll_exceedance);
      near(a.slam_probability, b.slam_probability);
      near(a.slams_per_hour, b.slams_per_hour);
      near(a.wetness_probability, b.wetness_probability);
      near(a.low_encounter_share, b.low_encounter_share);
      near(a.added_resistance, b.added_resistance);
      EXPECT_GT(a.added_resistance, kNoResistance);
      EXPECT_EQ(a.added_resistance_empirical > kNoResistance, v < 5);
      near(a.added_resistance_empirical, b.added_resistance_empirical);
      for (std::size_t i = 0; i < scene_->criteria.size(); ++i) {
        near(a.values[i], b.values[i]);
      }
    }
  }
}

TEST_F(GridSweep, HasAllVerdictsInACrossingSea) {
  add_crossing_seas();
  synthetic::scale_heights(scene_->sea, 0.6);
  scene_->sweep();
  std::array<std::size_t, 4> count{};
  for (std::size_t v = 0; v < 9; ++v) {
    for (std::size_t h = 0; h < kMaxHeadings; ++h) {
      ++count[static_cast<std::size_t>(scene_->grid.cells[v][h].verdict)];
    }
  }
  EXPECT_GT(count[static_cast<std::size_t>(Verdict::kGood)], 0u);
  EXPECT_GT(count[static_cast<std::size_t>(Verdict::kCaution)], 0u);
  EXPECT_GT(count[static_cast<std::size_t>(Verdict::kExceeded)], 0u);
}

TEST_F(GridSweep, IsMirroredForASymmetricShipInALongCrestedSea) {
  scene_->hull.points[0].y = 0.0;
  scene_->bind();
  synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 7.0, 0, 0);  // from north
  scene_->sweep();
  for (std::size_t v = 0; v < 9; ++v) {
    for (std::size_t h = 1; h < kMaxHeadings; ++h) {
      const Cell& starboard = scene_->grid.cells[v][h];
      const Cell& port = scene_->grid.cells[v][kMaxHeadings - h];
      for (std::size_t i = 0; i < scene_->criteria.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(starboard.values[i]), static_cast<double>(port.values[i]),
                    kFloat * static_cast<double>(port.values[i]));
      }
      EXPECT_EQ(starboard.verdict, port.verdict);
    }
  }
}

TEST_F(GridSweep, GivesNothingAtAllWhereALongCrestedSeaMovesNothing) {
  // Waves from ahead and from astern do not roll the ship: rounding of the transforms is not taken for roll.
  only_roll_limit(0.1);
  synthetic::add_system(scene_->sea, scene_->transfer, 9.0, 7.0, 0, 0);
  scene_->sweep();
  for (std::size_t v = 0; v < 9; ++v) {
    EXPECT_EQ(scene_->grid.cells[v][0].rms_roll, 0.0F);
    EXPECT_EQ(scene_->grid.cells[v][36].rms_roll, 0.0F);
    EXPECT_GT(scene_->grid.cells[v][1].rms_roll, 0.0F);
  }
}

TEST_F(GridSweep, TurnsWithTheSea) {
  // Sea and heading turned by the same angle: the same cell, in all four quadrants.
  synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 7.0, 4, 0);
  scene_->sweep();
  const Cell before = scene_->grid.cells[5][10];
  for (const std::size_t turn : {18u, 36u, 54u}) {
    scene_->sea = SeaEnergy{};
    synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 7.0, 4 + turn, 0);
    scene_->sweep();
    for (std::size_t i = 0; i < scene_->criteria.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(scene_->grid.cells[5][10 + turn].values[i]),
                  static_cast<double>(before.values[i]), kFloat * static_cast<double>(before.values[i]));
    }
    EXPECT_NE(scene_->grid.cells[5][10].values, before.values);
  }
}

TEST_F(GridSweep, AddsVariancesOfTwoSystemsBeforeAnyProbability) {
  scene_->criteria.clear();
  ASSERT_TRUE(scene_->criteria.push_back(
      {.quantity = Quantity::kDeckWetness, .statistic = Statistic::kProbability, .limit = 0.5}));
  scene_->bind();
  synthetic::add_system(scene_->sea, scene_->transfer, 1.0, 7.0, 0, 0);
  scene_->sweep();
  const Heading head{0.0};
  ASSERT_TRUE(respond(scene_->inputs(), head, 0.0, scene_->response).ok());
  // Raise the sea until P = 1 %: the exponent goes with the square of height.
  const double exponent = -std::log(scene_->response.quantities.back().probability);
  synthetic::scale_heights(scene_->sea, std::sqrt(exponent / std::log(100.0)));
  scene_->sweep();
  EXPECT_NEAR(static_cast<double>(scene_->grid.cells[0][0].wetness_probability), 0.01, 1e-7);
  // The same system once more.
  scene_->sea.num_systems = 2;
  scene_->sea.part[1] = scene_->sea.part[0];
  scene_->sweep();
  EXPECT_NEAR(static_cast<double>(scene_->grid.cells[0][0].wetness_probability), 0.10, 1e-6);
}

TEST_F(GridSweep, NamesTheSystemThatContributesMostOfTheGoverningVariance) {
  only_roll_limit(0.1);
  synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 8.0, 0, 0);   // from north
  synthetic::add_system(scene_->sea, scene_->transfer, 3.0, 8.0, 18, 0);  // from east
  scene_->sweep();
  EXPECT_EQ(scene_->grid.cells[0][0].governing_system, 1);   // heading north: the beam sea from east rolls
  EXPECT_EQ(scene_->grid.cells[0][18].governing_system, 0);  // heading east: the one from north
}

TEST_F(GridSweep, MarksSpeedsBelowSteerage) {
  add_crossing_seas();
  scene_->sweep();
  EXPECT_NE(scene_->grid.cells[1][0].hazards & kHazardNoSteerage, 0);  // 1 m/s < 1.5
  EXPECT_EQ(scene_->grid.cells[2][0].hazards & kHazardNoSteerage, 0);
}

TEST_F(GridSweep, DoesNotCallFollowingSeasGoodWhereEncounterFrequencyVanishes) {
  synthetic::fill(scene_->transfer, 9, 1.0, 40, unit_response);
  only_roll_limit(10.0);  // never reached
  // 8 m/s, waves of 5.2 s from dead astern: their peak travels with the ship, |omega_e| < 0.1 from 1.1
  // to 1.3.
  synthetic::add_system(scene_->sea, scene_->transfer, 1.0, 5.2, 36, 0);
  scene_->sweep();
  const Cell& following = scene_->grid.cells[8][0];
  EXPECT_GT(following.low_encounter_share, 0.2F);
  EXPECT_EQ(following.verdict, Verdict::kUnknown);
  EXPECT_NE(following.hazards & kHazardFollowingUnwatched, 0);
  EXPECT_EQ(scene_->grid.cells[8][36].verdict, Verdict::kGood);  // the same sea from ahead
}

TEST_F(GridSweep, DoesNotCallFollowingSeasGoodWhereTheirLoadsAreForcedToZero) {
  // Then the variances hold nothing of them: the share of the wave energy speaks.
  synthetic::fill(scene_->transfer, 9, 1.0, 40, [](double speed, double mu, double omega) {
    MotionTransfer transfer = unit_response(speed, mu, omega);
    if (std::abs(omega - omega * omega / kStandardGravity * speed * std::cos(mu)) < 0.1) {
      transfer.motion.fill(0.0);
    }
    return transfer;
  });
  only_roll_limit(10.0);
  synthetic::add_system(scene_->sea, scene_->transfer, 1.0, 5.2, 36, 0);
  scene_->sweep();
  EXPECT_GT(scene_->grid.cells[8][0].low_encounter_share, 0.2F);
  EXPECT_EQ(scene_->grid.cells[8][0].verdict, Verdict::kUnknown);
  EXPECT_EQ(scene_->grid.cells[8][36].verdict, Verdict::kGood);
  ASSERT_TRUE(respond(scene_->inputs(), {0.0}, 8.0, scene_->response).ok());
  EXPECT_EQ(scene_->response.cell.verdict, Verdict::kUnknown);
}

TEST_F(GridSweep, LandsOnTheLimitWhenHeightsAreScaledByTheMarginOfACell) {
  add_crossing_seas();
  scene_->sweep();
  const Cell cell = scene_->grid.cells[6][13];
  ASSERT_NE(cell.governing, kNoCriterion);
  synthetic::scale_heights(scene_->sea, static_cast<double>(cell.margin));
  scene_->sweep();
  const Cell& scaled = scene_->grid.cells[6][13];
  EXPECT_EQ(scaled.governing, cell.governing);
  EXPECT_NEAR(static_cast<double>(scaled.margin), 1.0, 1e-6);
}

TEST_F(GridSweep, WithFewerHeadingsIsTheSameCellsThinnedOut) {
  add_crossing_seas();
  scene_->sweep();
  const auto fine = std::make_unique<Grid>(scene_->grid);
  scene_->num_headings = 24;
  scene_->sweep();
  EXPECT_EQ(scene_->grid.num_headings, 24u);
  for (std::size_t h = 0; h < 24; ++h) {
    EXPECT_EQ(scene_->grid.cells[4][h].values, fine->cells[4][3 * h].values);
  }
}

TEST_F(GridSweep, GivesTheSameBitsTwice) {
  add_crossing_seas();
  scene_->sweep();
  const auto first = std::make_unique<Grid>(scene_->grid);
  scene_->workspace = GridWorkspace{};
  scene_->sweep();
  for (std::size_t v = 0; v < 9; ++v) {
    for (std::size_t h = 0; h < kMaxHeadings; ++h) {
      EXPECT_EQ(scene_->grid.cells[v][h].values, first->cells[v][h].values);
    }
  }
}

TEST_F(GridSweep, RefusesASeaWithoutEnergyAndOneOnOtherFrequencies) {
  scene_->sea.num_frequencies = 40;
  EXPECT_EQ(sweep_grid(scene_->inputs(), scene_->workspace, scene_->grid).error(), Error::kEmptySpectrum);
  add_crossing_seas();
  scene_->sea.num_frequencies = 39;
  EXPECT_EQ(sweep_grid(scene_->inputs(), scene_->workspace, scene_->grid).error(), Error::kTooMany);
  scene_->sea.num_frequencies = 40;
  scene_->num_headings = 50;
  EXPECT_EQ(sweep_grid(scene_->inputs(), scene_->workspace, scene_->grid).error(), Error::kOutOfRange);
}

TEST_F(GridSweep, MakesOnlyTheCellsUnknownWhoseMotionsAreNotANumber) {
  add_crossing_seas();
  scene_->transfer.row[3][20].re[3][5] = std::nanf("");
  scene_->sweep();
  EXPECT_EQ(scene_->grid.cells[3][20].verdict, Verdict::kUnknown);
  EXPECT_NE(scene_->grid.cells[4][20].governing, kNoCriterion);
}

TEST_F(GridSweep, FlagsHighFroudeNumberAndALostTail) {
  add_crossing_seas();
  scene_->hull.lpp = 30.0;  // 0.35 sqrt(g L) = 6.0 m/s
  scene_->sea.lost_tail = 0.02;
  scene_->sweep();
  EXPECT_EQ(scene_->grid.cells[5][0].quality & kQualityHighFroude, 0u);
  EXPECT_NE(scene_->grid.cells[7][0].quality & kQualityHighFroude, 0u);
  EXPECT_NE(scene_->grid.cells[5][0].quality & kQualityTailLost, 0u);
}

TEST_F(GridSweep, ResponseOfACellListsEveryChannelWithItsSystems) {
  add_crossing_seas();
  ASSERT_TRUE(respond(scene_->inputs(), {1.0}, 3.3, scene_->response).ok());
  ASSERT_EQ(scene_->response.quantities.size(), scene_->watch.channels.size());
  EXPECT_EQ(scene_->response.num_systems, 2u);
  for (const QuantityResponse& quantity : scene_->response.quantities) {
    EXPECT_NEAR(quantity.variance[0] + quantity.variance[1], quantity.rms * quantity.rms,
                1e-12 * quantity.rms * quantity.rms);
    EXPECT_NEAR(quantity.significant, 2.0 * quantity.rms, 1e-15);
    EXPECT_GE(quantity.t1, quantity.t2);  // Schwarz: m1^2 <= m0 m2
    EXPECT_EQ(quantity.probability >= 0.0, quantity.quantity >= Quantity::kSlamming);
  }
}

}  // namespace
}  // namespace quickstrip
