// IMO zones through the advisor: that they reach the grid the right way round, that measured motion does, and
// that no following sea is good on linear motion alone.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

/// An advisor and the hull that it speaks of.
struct Ship {
  Hull hull;
  Advisor advisor;
};

std::unique_ptr<Ship> ship_for(const std::string& hull_name) {
  auto ship = std::make_unique<Ship>();
  EXPECT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/" + hull_name, ship->hull).ok());
  ship->hull.grid.speed_step *= 3.0;  // 0, 3 ... 24 kn: a third of the time
  EXPECT_TRUE(ship->advisor.configure(ship->hull, *nordforsk_merchant(ship->hull), {}).ok());
  return ship;
}

class ZonesOnGrid : public testing::Test {
 protected:
  static void SetUpTestSuite() { ship_ = ship_for("s175.hull.toml"); }
  static void TearDownTestSuite() { ship_.reset(); }

  static const StepOutput& step(Advisor& advisor, double hs, double tp, double from_deg,
                                const MeasuredMotion* motion = nullptr) {
    SeaState sea;
    EXPECT_TRUE(sea.systems.push_back({.hs = hs,
                                       .period = tp,
                                       .from = {radians(from_deg)},
                                       .spreading = radians(20.0),
                                       .shape = SpectrumShape::kJonswap}));
    const OwnShip ship{.heading = {0.0}, .speed = 15.0 * kKnot};
    time_ += 3600.0;  // beyond every dwell: what a cycle says alone
    const StepOutput& output =
        advisor.step({.sea_state = &sea, .own_ship = &ship, .time = time_, .motion = motion});
    EXPECT_EQ(output.advice.no_advice, NoAdvice::kNone);
    return output;
  }
  static double mu_deg(std::size_t heading, double from_deg) {
    return degrees(
        encounter_angle({radians(5.0 * static_cast<double>(heading))}, {radians(from_deg)}).radians);
  }

  static inline std::unique_ptr<Ship> ship_;
  static inline double time_ = 0.0;
};

// 10 s, Hs 8 m at 18 kn: successive high waves on the courses within 45 degrees of running before them; at 45
// itself 18 cos(45) = 12.73 kn are just short of the 12.77 kn of TE/TW = 1.8 in the shortest that is long
// enough.
TEST_F(ZonesOnGrid, ASwellFromEachQuadrantMarksTheCoursesThatRunBeforeIt) {
  for (const double from : {35.0, 125.0, 215.0, 305.0}) {
    const StepOutput& output = step(ship_->advisor, 8.0, 10.0, from);
    ASSERT_NEAR(output.grid.speeds[6], 18.0 * kKnot, 1e-9);
    std::size_t num_marked = 0;
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      const bool is_marked = (output.grid.cells[6][h].hazards & kHazardSuccessiveWaves) != 0;
      num_marked += is_marked ? 1 : 0;
      EXPECT_EQ(is_marked, std::abs(mu_deg(h, from)) < 45.0 - 1e-6) << from << " " << 5 * h;
    }
    EXPECT_EQ(num_marked, 17u);
  }
}

TEST_F(ZonesOnGrid, MeasuredMotionConfirmsSuccessiveWavesAtThePresentCourse) {
  MeasuredMotion motion;
  motion.window = 600.0;
  motion.roll_rms = radians(5.0);
  motion.roll_period = 20.0;  // 15 kn before a swell of 10 s
  const StepOutput& felt = step(ship_->advisor, 8.0, 10.0, 180.0, &motion);
  EXPECT_NE(felt.present.cell.hazards & kHazardSuccessiveWavesConfirmed, 0);
  EXPECT_NE(felt.grid.cells[6][2].hazards & kHazardSuccessiveWavesConfirmed, 0);
  EXPECT_EQ(felt.grid.cells[6][36].hazards & kHazardSuccessiveWavesConfirmed, 0);
  const StepOutput& calm = step(ship_->advisor, 8.0, 10.0, 180.0);
  EXPECT_EQ(calm.present.cell.hazards & kHazardSuccessiveWavesConfirmed, 0);
  EXPECT_NE(calm.present.cell.hazards & kHazardSuccessiveWaves, 0);
}

TEST_F(ZonesOnGrid, TheStepSaysWhichRollPeriodTheyStandOn) {
  const StepOutput& output = step(ship_->advisor, 2.0, 10.0, 180.0);
  EXPECT_EQ(output.roll_period.source, RollPeriodSource::kComputed);
  EXPECT_NEAR(output.roll_period.longest / output.roll_period.shortest, 1.1 / 0.9, 1e-12);
}

// What is asked at one course and speed is what the grid says there.
TEST_F(ZonesOnGrid, TheCellAskedForIsTheCellOfTheGrid) {
  const StepOutput& output = step(ship_->advisor, 3.0, 12.0, 200.0);
  CellResponse asked;
  for (std::size_t v = 1; v < output.grid.num_speeds; v += 2) {
    for (std::size_t h = 0; h < output.grid.num_headings; h += 5) {
      const double heading = radians(5.0 * static_cast<double>(h));
      ASSERT_TRUE(ship_->advisor.respond_at({heading}, output.grid.speeds[v], asked).ok());
      EXPECT_EQ(asked.cell.hazards, output.grid.cells[v][h].hazards) << v << " " << h;
      EXPECT_EQ(asked.cell.verdict, output.grid.cells[v][h].verdict) << v << " " << h;
    }
  }
}

// Before the rule counted the waves themselves not one cell of these was unknown.
TEST_F(ZonesOnGrid, SomeOfTheSternIsUnknownAndNotAllOfIt) {
  for (const double tp : {10.0, 14.0}) {
    const StepOutput& output = step(ship_->advisor, 2.0, tp, 180.0);
    std::size_t unknown_astern = 0;
    std::size_t astern = 0;
    for (std::size_t v = 1; v < output.grid.num_speeds; ++v) {
      for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
        const Cell& cell = output.grid.cells[v][h];
        const bool is_astern = std::abs(mu_deg(h, 180.0)) < 60.0;
        const bool is_unknown = cell.verdict == Verdict::kUnknown;
        astern += is_astern ? 1 : 0;
        unknown_astern += is_astern && is_unknown ? 1 : 0;
        EXPECT_TRUE(is_astern || !is_unknown) << tp << " " << v << " " << h;
      }
    }
    EXPECT_GT(unknown_astern, 0u) << tp;
    EXPECT_LT(2 * unknown_astern, astern) << tp;
    const double cells = static_cast<double>((output.grid.num_speeds - 1) * output.grid.num_headings);
    EXPECT_NEAR(output.unknown_share, static_cast<double>(unknown_astern) / cells, 1e-12);
  }
}

// A hull of minimal form has no offsets above its waterline: GM in waves is not known.
TEST_F(ZonesOnGrid, WithoutStabilityInWavesNoFollowingCellIsGood) {
  const auto minimal = ship_for("s175_minimal.hull.toml");
  const StepOutput& output = step(minimal->advisor, 2.0, 10.0, 180.0);
  std::size_t num_unknown = 0;
  std::size_t num_good = 0;
  for (std::size_t v = 1; v < output.grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      const Cell& cell = output.grid.cells[v][h];
      if (std::abs(mu_deg(h, 180.0)) < 60.0 - 1e-6) {
        EXPECT_NE(cell.verdict, Verdict::kGood) << v << " " << h;
        EXPECT_NE(cell.hazards & kHazardZonesUnknown, 0);
        num_unknown += cell.verdict == Verdict::kUnknown ? 1 : 0;
      } else {
        num_good += cell.verdict == Verdict::kGood ? 1 : 0;
      }
    }
  }
  EXPECT_GT(num_unknown, 0u);
  EXPECT_GT(num_good, 0u);  // ahead her motions may still be judged
}

}  // namespace
}  // namespace quickstrip
