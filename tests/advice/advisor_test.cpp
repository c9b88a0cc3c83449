// The façade with the S-175 and real strip theory: what it says, and above all when it must not say anything.
#include "core/advisor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

class AdvisorStep : public testing::Test {
 protected:
  /// Configured once: strip theory for the whole grid takes a few tenths of a second.
  static void SetUpTestSuite() {
    hull_ = std::make_unique<Hull>();
    ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull_).ok());
    advisor_ = std::make_unique<Advisor>();
    ASSERT_TRUE(advisor_->configure(*hull_, *nordforsk_merchant(*hull_), {}).ok());
  }
  static void TearDownTestSuite() {
    advisor_.reset();
    hull_.reset();
  }
  void SetUp() override {
    if (advisor_->is_rebuild_due() || !(advisor_->step(inputs()).advice.no_advice == NoAdvice::kNone)) {
      step(hull_->loading);
      ASSERT_TRUE(advisor_->rebuild().ok());
    }
    ASSERT_TRUE(sea_.systems.push_back(
        {.hs = 5.0, .period = 11.0, .from = {radians(30.0)}, .spreading = radians(30.0)}));
  }
  StepInputs inputs() { return {.sea_state = &sea_, .own_ship = &ship_}; }
  const StepOutput& step() { return advisor_->step(inputs()); }
  const StepOutput& step(const Loading& loading) {
    StepInputs with_loading = inputs();
    with_loading.loading = &loading;
    return advisor_->step(with_loading);
  }
  static void expect_silence(const StepOutput& output, NoAdvice reason) {
    EXPECT_EQ(output.advice.no_advice, reason);
    EXPECT_TRUE(output.advice.changes.empty());
    EXPECT_EQ(output.advice.present.verdict, Verdict::kUnknown);
    EXPECT_EQ(output.present.cell.verdict, Verdict::kUnknown);
    EXPECT_TRUE(output.present.quantities.empty());
    for (const auto& row : output.grid.cells) {
      for (const Cell& cell : row) {
        ASSERT_EQ(cell.verdict, Verdict::kUnknown);
      }
    }
  }

  static std::unique_ptr<Hull> hull_;
  static std::unique_ptr<Advisor> advisor_;
  SeaState sea_;
  OwnShip ship_{.heading = {radians(20.0)}, .speed = 16.0 * kKnot};
};

std::unique_ptr<Hull> AdvisorStep::hull_;
std::unique_ptr<Advisor> AdvisorStep::advisor_;

TEST_F(AdvisorStep, GivesTheVerdictOnThePresentStateAndOnTheWholeGrid) {
  const StepOutput& output = step();
  EXPECT_EQ(output.advice.no_advice, NoAdvice::kNone);
  EXPECT_EQ(output.grid.num_speeds, 25u);
  EXPECT_EQ(output.grid.num_headings, 72u);
  EXPECT_NEAR(output.grid.speeds[24], 24.0 * kKnot, 1e-9);
  EXPECT_NE(output.advice.present.verdict, Verdict::kUnknown);
  EXPECT_NEAR(output.hs, 5.0, 1e-9);
  EXPECT_EQ(output.num_systems, 1u);
  EXPECT_EQ(output.present.quantities.size(), 6u + 2u * 3u + 3u);
}

TEST_F(AdvisorStep, AtACellOfTheGridThePresentStateIsThatCell) {
  ship_ = {.heading = {radians(20.0)}, .speed = 16.0 * kKnot};
  const StepOutput& output = step();
  const Cell& cell = output.grid.cells[16][4];
  EXPECT_EQ(output.advice.present.verdict, cell.verdict);
  EXPECT_EQ(output.advice.present.governing, cell.governing);
  EXPECT_NEAR(static_cast<double>(output.advice.present.margin), static_cast<double>(cell.margin), 1e-5);
  // Roll, whose peak has points of its own: two ways of summing it, to the rounding of the cell's float.
  EXPECT_GT(advisor_->transfer_functions().peak[16][18].num_points, 0u);
  const double roll = output.present.quantities[3].rms;
  EXPECT_EQ(output.present.quantities[3].quantity, Quantity::kRoll);
  EXPECT_NEAR(static_cast<double>(cell.rms_roll), roll, 1e-6 * roll);
}

TEST_F(AdvisorStep, AFlatSeaIsGoodForEveryCellThatMayBeJudgedAndAStormIsNot) {
  sea_.systems[0].hs = 0.3;
  const StepOutput& calm = step();
  EXPECT_EQ(calm.advice.present.verdict, Verdict::kGood);
  EXPECT_FALSE(calm.advice.change_needed);
  sea_.systems[0].hs = 12.0;
  sea_.systems[0].period = 14.0;
  const StepOutput& storm = step();
  EXPECT_EQ(storm.advice.present.verdict, Verdict::kExceeded);
  EXPECT_TRUE(storm.advice.change_needed);
}

TEST_F(AdvisorStep, EveryChangeLeadsToTheVerdictItPromises) {
  const StepOutput& output = step();
  ASSERT_TRUE(output.advice.change_needed);
  ASSERT_FALSE(output.advice.changes.empty());
  for (const Change& change : output.advice.changes) {
    const OwnShip there{.heading = {change.heading}, .speed = change.speed};
    EXPECT_NEAR(wrap_pi(change.heading - ship_.heading.radians), change.heading_change, 1e-9);
    auto response = std::make_unique<CellResponse>();
    ASSERT_TRUE(advisor_->respond_at(there.heading, there.speed, *response).ok());
    EXPECT_EQ(response->cell.verdict, change.verdict);
    EXPECT_GE(change.speed, hull_->min_steerage_speed);
  }
}

TEST_F(AdvisorStep, SeasFromTheOtherSideMirrorTheGrid) {
  // Both places of the S-175 lie on the centre plane. Spread seas: the sums run the other way round, 1e-5 of
  // floats in the exponent of a probability.
  sea_.systems[0].from = {radians(40.0)};
  const auto starboard = std::make_unique<Grid>(step().grid);
  sea_.systems[0].from = {radians(-40.0)};
  const Grid& port = step().grid;
  for (std::size_t v = 0; v < 25; ++v) {
    for (std::size_t h = 0; h < 72; ++h) {
      const Cell& a = starboard->cells[v][h];
      const Cell& b = port.cells[v][(72 - h) % 72];
      ASSERT_NEAR(static_cast<double>(a.margin), static_cast<double>(b.margin),
                  1e-5 * static_cast<double>(a.margin))
          << v << " " << h;
      ASSERT_EQ(a.governing, b.governing);
    }
  }
}

TEST_F(AdvisorStep, SaysNothingBeforeItIsConfigured) {
  const auto fresh = std::make_unique<Advisor>();
  expect_silence(fresh->step(inputs()), NoAdvice::kNotConfigured);
  EXPECT_EQ(fresh->rebuild().error(), Error::kNotConfigured);
  auto response = std::make_unique<CellResponse>();
  EXPECT_EQ(fresh->respond_at({0.0}, 5.0, *response).error(), Error::kNotConfigured);
}

TEST_F(AdvisorStep, NeverLeavesYesterdaysGreenWhenAnInputIsMissing) {
  sea_.systems[0].hs = 0.3;
  ASSERT_EQ(step().advice.present.verdict, Verdict::kGood);
  StepInputs missing = inputs();
  missing.sea_state = nullptr;
  expect_silence(advisor_->step(missing), NoAdvice::kSeaMissing);
  ASSERT_EQ(step().advice.present.verdict, Verdict::kGood);
  missing = inputs();
  missing.own_ship = nullptr;
  expect_silence(advisor_->step(missing), NoAdvice::kOwnShipMissing);
  ASSERT_EQ(step().advice.present.verdict, Verdict::kGood);
  missing = inputs();
  missing.no_advice = NoAdvice::kSeaStale;
  expect_silence(advisor_->step(missing), NoAdvice::kSeaStale);
  auto response = std::make_unique<CellResponse>();
  EXPECT_EQ(advisor_->respond_at({0.0}, 5.0, *response).error(), Error::kNotConfigured);
}

TEST_F(AdvisorStep, RefusesImplausibleInputsWithTheirReason) {
  ship_.heading.radians = std::nan("");
  expect_silence(step(), NoAdvice::kOwnShipImplausible);
  ship_ = {.heading = {0.0}, .speed = std::numeric_limits<double>::infinity()};
  expect_silence(step(), NoAdvice::kOwnShipImplausible);
  ship_ = {.heading = {0.0}, .speed = 5.0};
  sea_.systems[0].hs = std::nan("");
  expect_silence(step(), NoAdvice::kSeaImplausible);
  sea_.systems.clear();
  expect_silence(step(), NoAdvice::kSeaImplausible);
}

TEST_F(AdvisorStep, ASpeedOutsideTheGridLeavesTheGridAndSaysSo) {
  ship_.speed = 26.0 * kKnot;
  const StepOutput& output = step();
  EXPECT_EQ(output.advice.no_advice, NoAdvice::kSpeedOutsideGrid);
  EXPECT_EQ(output.advice.present.verdict, Verdict::kUnknown);
  EXPECT_TRUE(output.present.quantities.empty());
  EXPECT_NE(output.grid.cells[10][30].governing, kNoCriterion);
}

TEST_F(AdvisorStep, ANewLoadingIsAnnouncedRebuiltAndThenUsed) {
  const float before = step().advice.present.margin;
  Loading loading = hull_->loading;
  loading.draught_aft = 8.6;
  loading.draught_fwd = 8.4;
  expect_silence(step(loading), NoAdvice::kLoadingChanged);
  EXPECT_TRUE(advisor_->is_rebuild_due());
  expect_silence(step(loading), NoAdvice::kLoadingChanged);  // until it is rebuilt
  ASSERT_TRUE(advisor_->rebuild().ok());
  EXPECT_FALSE(advisor_->is_rebuild_due());
  const float other = step(loading).advice.present.margin;
  EXPECT_NE(other, before);
  EXPECT_EQ(step().advice.present.margin, other);  // no loading message: the one in force stays
  step(hull_->loading);
  ASSERT_TRUE(advisor_->rebuild().ok());
  EXPECT_EQ(step().advice.present.margin, before);  // same bits
}

TEST_F(AdvisorStep, ALoadingThatCannotFloatIsRefusedUntilAnotherComes) {
  Loading unstable = hull_->loading;
  unstable.kg = 14.0;
  expect_silence(step(unstable), NoAdvice::kLoadingChanged);
  EXPECT_EQ(advisor_->rebuild().error(), Error::kUnstable);
  EXPECT_FALSE(advisor_->is_rebuild_due());
  expect_silence(step(unstable), NoAdvice::kLoadingImplausible);
  expect_silence(step(), NoAdvice::kLoadingImplausible);
  expect_silence(step(hull_->loading), NoAdvice::kLoadingChanged);
  ASSERT_TRUE(advisor_->rebuild().ok());
  EXPECT_EQ(step().advice.no_advice, NoAdvice::kNone);
}

TEST_F(AdvisorStep, ALoadingWithANaNIsRefusedAndTheOneInForceStays) {
  Loading broken = hull_->loading;
  broken.kg = std::nan("");
  expect_silence(step(broken), NoAdvice::kLoadingImplausible);
  EXPECT_FALSE(advisor_->is_rebuild_due());
  EXPECT_EQ(step().advice.no_advice, NoAdvice::kNone);
}

TEST_F(AdvisorStep, FlagsSpeedOverGroundAndAnUnknownFreeSurface) {
  EXPECT_EQ(step().quality & (kQualitySpeedOverGround | kQualityFreeSurfaceUnknown), 0u);
  ship_.speed_over_ground = true;
  EXPECT_NE(step().quality & kQualitySpeedOverGround, 0u);
  EXPECT_NE(step().grid.cells[5][5].quality & kQualitySpeedOverGround, 0u);
  Loading loading = hull_->loading;
  loading.free_surface_correction.reset();
  step(loading);
  ASSERT_TRUE(advisor_->rebuild().ok());
  EXPECT_NE(step().quality & kQualityFreeSurfaceUnknown, 0u);
}

TEST_F(AdvisorStep, UsesAMeasuredSpectrumWhenGivenOne) {
  auto spectrum = std::make_unique<DirectionalSpectrum>();
  for (int f = 0; f < 20; ++f) {
    ASSERT_TRUE(spectrum->frequencies.push_back(0.3 + 0.05 * f));
  }
  for (int d = 0; d < 36; ++d) {
    ASSERT_TRUE(spectrum->directions.push_back(radians(10.0 * d)));
  }
  for (std::size_t f = 4; f < 12; ++f) {
    spectrum->density[f][9] = 3.0;  // from 090
  }
  StepInputs both = inputs();
  both.spectrum = spectrum.get();
  const StepOutput& output = advisor_->step(both);
  EXPECT_EQ(output.advice.no_advice, NoAdvice::kNone);
  EXPECT_NEAR(degrees(output.systems[0].from.radians), 90.0, 1.0);
}

TEST_F(AdvisorStep, GivesTheSameBitsForTheSameInputs) {
  const auto first = std::make_unique<StepOutput>(step());
  sea_.systems[0].hs = 2.0;
  step();
  sea_.systems[0].hs = 5.0;
  const StepOutput& again = step();
  for (std::size_t v = 0; v < 25; ++v) {
    for (std::size_t h = 0; h < 72; ++h) {
      ASSERT_EQ(first->grid.cells[v][h].values, again.grid.cells[v][h].values);
    }
  }
  EXPECT_EQ(first->advice.present.margin, again.advice.present.margin);
}

TEST_F(AdvisorStep, ConfigureStepRebuildAndQueryAllocateNothing) {
  const auto response = std::make_unique<CellResponse>();
  const Criteria criteria = advisor_->criteria();
  Loading other = hull_->loading;
  other.kg = 9.0;
  const test::HeapGuard guard;
  const bool configured = advisor_->configure(*hull_, criteria, {}).ok();
  step();
  const bool answered = advisor_->respond_at({1.0}, 5.0, *response).ok();
  step(other);
  const bool rebuilt = advisor_->rebuild().ok();
  step(other);
  const std::size_t allocations = guard.allocations();
  EXPECT_TRUE(configured && answered && rebuilt);
  EXPECT_EQ(allocations, 0u);
}

TEST(AdvisorConfigure, RefusesBadCriteriaAndABadGrid) {
  auto hull = std::make_unique<Hull>();
  ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull).ok());
  const auto advisor = std::make_unique<Advisor>();
  Criteria criteria = *nordforsk_merchant(*hull);
  criteria[0].limit = 0.0;
  EXPECT_EQ(advisor->configure(*hull, criteria, {}).error(), Error::kOutOfRange);
  criteria[0].limit = 0.1;
  hull->grid.heading_step = radians(7.0);
  EXPECT_EQ(advisor->configure(*hull, criteria, {}).error(), Error::kOutOfRange);
  hull->grid.heading_step = radians(10.0);
  hull->grid.speed_step = 0.4 * kKnot;
  EXPECT_EQ(advisor->configure(*hull, criteria, {}).error(), Error::kTooMany);
  EXPECT_EQ(advisor->step({}).advice.no_advice, NoAdvice::kNotConfigured);
  hull->grid = {.speed_from = 10.0 * kKnot,
                .speed_to = 12.0 * kKnot,
                .speed_step = kKnot,
                .heading_step = radians(15.0)};
  EXPECT_TRUE(advisor->configure(*hull, criteria, {}).ok());
  EXPECT_EQ(advisor->transfer_functions().num_speeds, 3u);
}

}  // namespace
}  // namespace quickstrip
