// The ship by her compiled table against the parent program on the same sections, solved at every frequency:
// what the table costs in accuracy.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/strip/equations_of_motion.hpp"
#include "sim/parent/parent_ship.hpp"
#include "tests/hull_table/compiled.hpp"

namespace quickstrip::test {
namespace {

StripMethod by_table() {
  StripMethod method;
  method.variant = StripVariant::kModified;
  method.loads = DiffractionLoads::kBoundaryValue;
  return method;
}

std::vector<ParentWave> waves_at(double speed, double lpp) {
  std::vector<ParentWave> out;
  for (const double mu_deg : {30.0, 60.0, 90.0, 120.0, 150.0, 180.0}) {
    for (double length = 0.35; length < 3.0; length *= 1.25) {
      const double omega = std::sqrt(kTwoPi * kStandardGravity / (length * lpp));
      out.push_back({omega, EncounterAngle{radians(mu_deg)}, speed});
    }
  }
  return out;
}

/// Greatest differences of the six motions, as parts of the greatest motion over all waves; printed.
std::array<double, 6> differences(double speed) {
  const auto hull = thinned_s175(3);
  const Compiled table(*hull, HullSections::kCloseFit, {{9.5}, {}});
  const auto on_board = loaded(*hull, hull->loading, &table.view, by_table());
  EXPECT_NE(on_board->table, nullptr);
  const ParentShip parent(*hull, hull->loading, by_table(),
                          {.sections = SectionMethod::kCloseFit, .diffracts_at_encounter = false});
  std::array<double, 6> difference{};
  std::array<double, 6> greatest{};
  for (const ParentResponse& wanted : parent.solve(waves_at(speed, hull->lpp))) {
    const RegularWaveRoll got =
        regular_wave_roll(*on_board, wanted.wave.omega, wanted.wave.mu, wanted.wave.speed, 1.0);
    for (std::size_t i = 0; i < 6; ++i) {
      greatest[i] = std::max(greatest[i], std::abs(wanted.transfer.motion[i]));
      difference[i] = std::max(difference[i], std::abs(got.transfer.motion[i] - wanted.transfer.motion[i]));
    }
  }
  std::printf("V = %g m/s, worst of each motion [%% of its greatest]:", speed);
  for (std::size_t i = 0; i < 6; ++i) {
    difference[i] /= greatest[i];
    std::printf(" %.2f", 100.0 * difference[i]);
  }
  std::printf("\n");
  return difference;
}

// Interpolation alone is left: in K, in direction, and core's parabolas between encounter frequencies. What
// potentials at the frequency of encounter change at speed is a choice of theory (--potentials), not the
// table's.
constexpr double kTable = 5e-3;

TEST(OnBoardAgainstParent, AtRestTheTableCostsLessThanHalfAPerCentOfAMotion) {
  for (const double part : differences(0.0)) {
    EXPECT_LT(part, kTable);
  }
}

TEST(OnBoardAgainstParent, AtTwentyKnotsTooWithPotentialsAtTheWavesFrequency) {
  for (const double part : differences(10.3)) {
    EXPECT_LT(part, kTable);
  }
}

}  // namespace
}  // namespace quickstrip::test
