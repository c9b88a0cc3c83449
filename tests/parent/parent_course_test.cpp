// Statistics of the parent program by brute force.
#include "sim/parent/parent_course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/base/angles.hpp"
#include "core/response/mean_added_resistance.hpp"
#include "core/response/moments.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr double kSpeed = 8.0;  // m/s

WaveSystem bow_sea() {
  WaveSystem out;
  out.hs = 4.9;
  out.period = 8.4;
  out.period_kind = PeriodKind::kMean;
  out.from = WaveFrom{wrap_two_pi(kPi - radians(135.0))};
  out.shape = SpectrumShape::kBretschneider;
  return out;
}

// The program on board on this hull.
struct OnBoard {
  LoadedHull hull;
  TransferFunctions transfer;
  TransferWorkspace work;
  SeaEnergy sea;
  Watch watch;
  std::vector<ResponseMoments> moments;
  double resistance = 0.0;
};

std::unique_ptr<OnBoard> on_board(const Hull& hull, const StripMethod& method) {
  auto out = std::make_unique<OnBoard>();
  EXPECT_TRUE(load(hull, hull.loading, method, out->hull));
  EXPECT_TRUE(solve_transfer_functions(out->hull, std::span(&kSpeed, 1), out->work, out->transfer));
  EXPECT_TRUE(list_channels(hull, hull.loading, out->hull.hydrostatics, method.swell_up, out->watch));
  SeaState state;
  EXPECT_TRUE(state.systems.push_back(bow_sea()));
  EXPECT_TRUE(
      place_on_grid(state, std::span(out->transfer.omega).first(out->transfer.num_frequencies), out->sea));
  out->moments.resize(out->watch.channels.size());
  EXPECT_TRUE(response_moments(out->transfer, out->watch, out->sea, Heading{0.0}, kSpeed, out->moments).ok());
  const auto resistance = mean_added_resistance(out->transfer, out->sea, Heading{0.0}, kSpeed);
  EXPECT_TRUE(resistance.ok());
  out->resistance = resistance->strip;
  return out;
}

ParentStatistics by_parent(const ParentShip& parent, const OnBoard& quick, std::size_t parts) {
  const EncounterAngle mu{radians(135.0)};
  const auto omegas =
      parent_frequencies(parent.hull(), mu, kSpeed,
                         std::span(quick.transfer.omega).first(quick.transfer.num_frequencies), parts);
  const ParentCourse course(parent, mu, kSpeed, omegas);
  return course.respond(*spectrum_of(bow_sea()), quick.watch);
}

// Same sections, so what differs is the table, the few frequencies of the program on board and its sums: 1 %
// of an RMS with Ikeda's damping, which both find for themselves, and swell-up on.
TEST(ParentCourse, OfLewisFormsHasTheStatisticsOfTheProgramOnBoard) {
  Hull hull;
  ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", hull));
  const StripMethod method{};
  const auto quick = on_board(hull, method);
  const ParentShip parent(hull, hull.loading, method, {.sections = SectionMethod::kLewis, .num_threads = 2});
  const ParentStatistics truth = by_parent(parent, *quick, 3);
  ASSERT_TRUE(depends_on_amplitude(parent.hull().roll_damping));
  EXPECT_NEAR(quick->resistance / truth.added_resistance, 1.0, 0.01);
  for (std::size_t c = 0; c < quick->watch.channels.size(); ++c) {
    EXPECT_NEAR(std::sqrt(quick->moments[c].m0 / truth.moments[c].m0), 1.0, 0.01) << "channel " << c;
    EXPECT_NEAR(std::sqrt(quick->moments[c].m2 / truth.moments[c].m2), 1.0, 0.01) << "channel " << c;
  }
}

TEST(ParentCourse, DoesNotDependOnItsFrequencies) {
  const Hull hull = test::box_barge(100.0, 20.0, 7.0, 12.0, 5);
  const StripMethod method{.loads = DiffractionLoads::kClassic};  // one flow a frequency
  const auto quick = on_board(hull, method);
  const ParentShip parent(hull, hull.loading, method, {.sections = SectionMethod::kLewis, .num_threads = 2});
  const ParentStatistics coarse = by_parent(parent, *quick, 4);
  const ParentStatistics fine = by_parent(parent, *quick, 8);
  EXPECT_NEAR(coarse.added_resistance / fine.added_resistance, 1.0, 1e-3);
  for (std::size_t c = 0; c < quick->watch.channels.size(); ++c) {
    EXPECT_NEAR(std::sqrt(coarse.moments[c].m0 / fine.moments[c].m0), 1.0, 1e-3) << "channel " << c;
  }
}

TEST(ParentCourse, WantsFrequenciesInOrderAndTwoOfThem) {
  const Hull hull = test::s175();
  const ParentShip parent(hull, hull.loading, StripMethod{}, {.sections = SectionMethod::kLewis});
  const std::vector<double> nodes = {0.3, 0.6, 1.2};
  const auto omegas = parent_frequencies(parent.hull(), {radians(90.0)}, 0.0, nodes);
  EXPECT_TRUE(std::is_sorted(omegas.begin(), omegas.end()));
  EXPECT_GT(std::count_if(
                omegas.begin(), omegas.end(),
                [&](double w) { return std::fabs(w / parent.hull().roll_natural_frequency - 1.0) < 0.05; }),
            6);
  EXPECT_THROW(ParentCourse(parent, {radians(90.0)}, 0.0, std::vector<double>{0.5}), std::invalid_argument);
}

}  // namespace
}  // namespace quickstrip
