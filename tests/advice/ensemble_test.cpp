// The ensemble of seas and ships: its draws, its ships against ships built with the same GM and damping, and
// what it counts against what the margins say.
#include "core/advice/ensemble.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "core/sea/moments.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMembers = 16;

double cumulative(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

TEST(Ensemble, EachQuantityTakesEachSixteenthOfItsDistributionOnceWithTheDeviationAskedFor) {
  Uncertainty uncertainty;
  uncertainty.height_part.fill(0.1);
  std::array<double, kMembers> z{};
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < kMembers; ++k) {
    z[k] = (draw_member(k, uncertainty, 1.0).height_factor[1] - 1.0) / 0.1;
    sum += z[k];
    square += z[k] * z[k];
  }
  EXPECT_NEAR(sum, 0.0, 1e-9);
  EXPECT_NEAR(square / kMembers, 1.0, 1e-5);
  std::sort(z.begin(), z.end());
  for (std::size_t k = 0; k < kMembers; ++k) {
    // Each lies in its own sixteenth; the common scale of 1 / 0.96 moves none out of it.
    EXPECT_GT(cumulative(z[k]), static_cast<double>(k) / kMembers);
    EXPECT_LT(cumulative(z[k]), static_cast<double>(k + 1) / kMembers);
  }
}

TEST(Ensemble, QuantitiesAreNotDrawnTogether) {
  Uncertainty uncertainty;
  uncertainty.height_part.fill(0.1);
  uncertainty.period_part.fill(0.1);
  uncertainty.gm = 0.1;
  uncertainty.roll_damping_part = 0.1;
  double height_period = 0.0;
  double gm_damping = 0.0;
  double height_gm = 0.0;
  for (std::size_t k = 0; k < kMembers; ++k) {
    const EnsembleMember member = draw_member(k, uncertainty, 1.0);
    const double height = (member.height_factor[0] - 1.0) / 0.1;
    const double gm = member.roll.stiffness_part / 0.1;
    height_period += height * (member.period_factor[0] - 1.0) / 0.1 / kMembers;
    gm_damping += gm * (member.roll.damping_factor - 1.0) / 0.1 / kMembers;
    height_gm += height * gm / kMembers;
  }
  // The correlation of 16 independent pairs has a standard deviation of a quarter: twice that.
  EXPECT_LT(std::abs(height_period), 0.5);
  EXPECT_LT(std::abs(gm_damping), 0.5);
  EXPECT_LT(std::abs(height_gm), 0.5);
}

TEST(Ensemble, AShiftedSpectrumHasTheHeightPeriodAndDirectionOfItsMember) {
  auto sea = std::make_unique<DirectionalSpectrum>();
  auto out = std::make_unique<DirectionalSpectrum>();
  for (int f = 0; f < 20; ++f) {
    ASSERT_TRUE(sea->frequencies.push_back(0.3 + 0.05 * f));
  }
  for (int d = 0; d < 24; ++d) {
    ASSERT_TRUE(sea->directions.push_back(kTwoPi * d / 24.0));
  }
  sea->density[7][5] = 2.0;
  sea->density[8][5] = 1.0;
  EnsembleMember member;
  member.height_factor.fill(1.2);
  member.period_factor.fill(1.1);
  member.turned.fill(0.2);
  shift_sea(member, *sea, *out);
  const auto m0 = [](const DirectionalSpectrum& of) {  // trapezia around two bands, one direction
    const double step = kTwoPi / 24.0;
    return step * (0.5 * of.density[7][5] * (of.frequencies[8] - of.frequencies[6]) +
                   0.5 * of.density[8][5] * (of.frequencies[9] - of.frequencies[7]));
  };
  EXPECT_NEAR(m0(*out) / m0(*sea), 1.44, 1e-12);
  EXPECT_NEAR(out->frequencies[7], sea->frequencies[7] / 1.1, 1e-12);
  EXPECT_NEAR(out->directions[5], sea->directions[5] + 0.2, 1e-12);
}

Hull few_speeds() {
  Hull hull = test::s175();
  hull.grid.speed_from = 0.0;
  hull.grid.speed_to = 10.0;
  hull.grid.speed_step = 5.0;
  return hull;
}

SeaState quartering_sea() {
  SeaState sea;
  EXPECT_TRUE(sea.systems.push_back(
      {4.0, 15.0, PeriodKind::kPeak, WaveFrom{radians(140.0)}, radians(25.0), SpectrumShape::kJonswap, 3.3}));
  return sea;
}

/// A ship of few speeds in one sea, swept as she is or shifted.
class ShiftedShip {
 public:
  explicit ShiftedShip(const Hull& hull) : hull_(hull), criteria_(*nordforsk_merchant(hull)) {
    EXPECT_TRUE(load(hull_, hull_.loading, {}, *ship_).ok());
    EXPECT_TRUE(list_channels(hull_, hull_.loading, ship_->hydrostatics, SwellUp::kOff, watch_).ok());
    const std::array<double, 3> speeds{0.0, 5.0, 10.0};
    EXPECT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *transfer_).ok());
    channels_ = bind_criteria(criteria_, watch_);
    const auto omega = std::span(transfer_->omega).first(transfer_->num_frequencies);
    EXPECT_TRUE(place_on_grid(quartering_sea(), omega, *sea_).ok());
  }
  [[nodiscard]] double gm() const { return ship_->hydrostatics.gm; }
  const Grid& sweep(const RollShift& shift) {
    const GridInputs inputs{.transfer = *transfer_,
                            .watch = watch_,
                            .waves = *waves_,
                            .criteria = criteria_,
                            .channels = channels_,
                            .sea = *sea_,
                            .lpp = hull_.lpp,
                            .roll_shift = shift};
    list_incident_waves(*transfer_, watch_, *waves_);
    EXPECT_TRUE(sweep_grid(inputs, *workspace_, *grid_).ok());
    return *grid_;
  }

 private:
  Hull hull_;
  Criteria criteria_;
  std::unique_ptr<LoadedHull> ship_ = std::make_unique<LoadedHull>();
  Watch watch_;
  std::unique_ptr<IncidentWaves> waves_ = std::make_unique<IncidentWaves>();
  CriteriaChannels channels_;
  std::unique_ptr<TransferWorkspace> work_ = std::make_unique<TransferWorkspace>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  std::unique_ptr<GridWorkspace> workspace_ = std::make_unique<GridWorkspace>();
  std::unique_ptr<Grid> grid_ = std::make_unique<Grid>();
};

/// Largest difference of RMS roll as a part of the largest RMS roll.
double largest_difference(const Grid& a, const Grid& b) {
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t v = 0; v < a.num_speeds; ++v) {
    for (std::size_t h = 0; h < a.num_headings; ++h) {
      const auto x = static_cast<double>(a.cells[v][h].rms_roll);
      const auto y = static_cast<double>(b.cells[v][h].rms_roll);
      difference = std::max(difference, std::abs(x - y));
      largest = std::max(largest, y);
    }
  }
  EXPECT_GT(largest, 0.01);
  return difference / largest;
}

TEST(EnsembleShip, WithAnotherGmIsTheShipBuiltWithThatGm) {
  for (const bool has_keels : {false, true}) {
    Hull hull = few_speeds();
    if (has_keels) {
      hull.roll_damping.method = RollDampingMethod::kIkeda;
      hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
    }
    const auto base = std::make_unique<ShiftedShip>(hull);
    const auto unshifted = std::make_unique<Grid>(base->sweep({}));
    for (const double part : {-0.1, -0.05, 0.05, 0.1}) {
      Hull other = hull;
      other.loading.gm = base->gm() * (1.0 + part);
      const auto built = std::make_unique<ShiftedShip>(other);
      const double error = largest_difference(base->sweep({.stiffness_part = part}), built->sweep({}));
      const double effect = largest_difference(*unshifted, built->sweep({}));
      std::printf("GM %+.0f %%, %s: roll within %.2f %% of her largest (left out: %.1f %%)\n", 100.0 * part,
                  has_keels ? "Ikeda" : "ratio", 100.0 * error, 100.0 * effect);
      // What is left out: in long waves the roll moment of the waves goes with GM too. So a member feels its
      // GM by some three fifths of what the ship built with it does.
      EXPECT_LT(error, 0.45 * effect);
    }
  }
}

TEST(EnsembleShip, WithOtherDampingIsTheShipBuiltWithThatDamping) {
  Hull hull = few_speeds();
  const auto base = std::make_unique<ShiftedShip>(hull);
  Hull other = hull;
  other.roll_damping.ratio = 1.4 * hull.roll_damping.ratio;
  const auto built = std::make_unique<ShiftedShip>(other);
  // The tabulated admittance (strip/roll_update.hpp).
  EXPECT_LT(largest_difference(base->sweep({.damping_factor = 1.4}), built->sweep({})), 2e-3);
}

class EnsembleOfAnAdvisor : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(advisor_->configure(hull_, criteria_, {}).ok());
    inputs_.sea_state = &sea_;
    inputs_.own_ship = &ship_;
    inputs_.ensemble_members = kMembers;
  }
  Hull hull_ = few_speeds();
  // One limit: the margin of a cell is then the height at which it is reached.
  Criteria criteria_ = [] {
    Criteria roll;
    EXPECT_TRUE(roll.push_back({.name = Name("roll"), .quantity = Quantity::kRoll, .limit = radians(2.0)}));
    return roll;
  }();
  SeaState sea_ = quartering_sea();
  OwnShip ship_{.heading = {0.0}, .speed = 5.0};
  StepInputs inputs_;
  std::unique_ptr<Advisor> advisor_ = std::make_unique<Advisor>();
};

TEST_F(EnsembleOfAnAdvisor, OfHeightsAloneExceedsWhereTheHeightIsAboveTheMargin) {
  sea_.systems[0].hs = 5.0;
  inputs_.uncertainty.height_part.fill(0.15);
  const StepOutput& output = advisor_->step(inputs_);
  ASSERT_EQ(output.ensemble.num_members(), static_cast<int>(kMembers));
  std::array<double, kMembers> factor{};
  for (std::size_t k = 0; k < kMembers; ++k) {
    factor[k] = draw_member(k, inputs_.uncertainty, 1.0).height_factor[0];
  }
  int num_partial = 0;
  for (std::size_t v = 0; v < output.grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      const auto margin = static_cast<double>(output.grid.cells[v][h].margin);
      // A height within rounding of the margin may fall on either side.
      const auto above = std::count_if(factor.begin(), factor.end(), [&](double f) { return f > margin; });
      const auto near = std::count_if(factor.begin(), factor.end(),
                                      [&](double f) { return std::abs(f - margin) < 1e-4 * margin; });
      const bool is_watched = output.grid.cells[v][h].governing != kNoCriterion;
      ASSERT_TRUE(is_watched);
      EXPECT_NEAR(output.ensemble.num_exceeded(v, h), static_cast<double>(above), static_cast<double>(near));
      num_partial += above > 0 && above < static_cast<std::ptrdiff_t>(kMembers) ? 1 : 0;
    }
  }
  EXPECT_GT(num_partial, 20);  // the case tells something
}

TEST_F(EnsembleOfAnAdvisor, WithoutUncertaintyIsSixteenTimesTheVerdict) {
  const StepOutput& output = advisor_->step(inputs_);
  for (std::size_t v = 0; v < output.grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      const bool is_exceeded = output.grid.cells[v][h].margin < 1.0F;
      EXPECT_EQ(output.ensemble.num_exceeded(v, h), is_exceeded ? 16 : 0);
    }
  }
}

TEST_F(EnsembleOfAnAdvisor, SpreadOverCyclesIsThatOfOneCycleAndOldMembersDoNotCount) {
  inputs_.uncertainty.height_part.fill(0.15);
  inputs_.uncertainty.direction.fill(0.2);
  inputs_.uncertainty.gm = 0.05;
  const auto at_once = std::make_unique<Ensemble>(advisor_->step(inputs_).ensemble);
  const auto other = std::make_unique<Advisor>();
  ASSERT_TRUE(other->configure(hull_, criteria_, {}).ok());
  inputs_.ensemble_members = 4;
  for (int cycle = 1; cycle <= 4; ++cycle) {
    inputs_.time = cycle;
    EXPECT_EQ(other->step(inputs_).ensemble.num_members(), 4 * cycle);
  }
  EXPECT_EQ(other->step(inputs_).ensemble.exceeded, at_once->exceeded);
  inputs_.time = 4.0 + kMemberLife + 1.0;
  EXPECT_EQ(other->step(inputs_).ensemble.num_members(), 4);
  inputs_.time = 3.0;  // the clock was set back
  EXPECT_EQ(other->step(inputs_).ensemble.num_members(), 4);
  inputs_.own_ship = nullptr;
  EXPECT_EQ(other->step(inputs_).ensemble.num_members(), 0);  // no advice, no certainty
}

TEST_F(EnsembleOfAnAdvisor, LeavesTheTrueSeaForQuestions) {
  inputs_.uncertainty.height_part.fill(0.3);
  inputs_.uncertainty.period_part.fill(0.2);
  inputs_.ensemble_members = 0;
  const auto before = std::make_unique<CellResponse>();
  const auto after = std::make_unique<CellResponse>();
  advisor_->step(inputs_);
  ASSERT_TRUE(advisor_->respond_at({1.0}, 3.0, *before).ok());
  inputs_.ensemble_members = 3;
  advisor_->step(inputs_);
  ASSERT_TRUE(advisor_->respond_at({1.0}, 3.0, *after).ok());
  ASSERT_EQ(before->quantities.size(), after->quantities.size());
  for (std::size_t q = 0; q < before->quantities.size(); ++q) {
    EXPECT_EQ(before->quantities[q].rms, after->quantities[q].rms);
  }
}

}  // namespace
}  // namespace quickstrip
