// The parent program: against the program on board where both have the same sections, and against identities.
#include "sim/parent/parent_ship.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/base/angles.hpp"
#include "core/sea/dispersion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

StripMethod with_loads(DiffractionLoads loads, StripVariant variant = StripVariant::kModified) {
  return {.variant = variant, .loads = loads, .surge = SurgeTerms::kInertiaOnly};
}

std::vector<ParentWave> waves(std::initializer_list<double> speeds, std::initializer_list<double> mus_deg,
                              std::initializer_list<double> omegas) {
  std::vector<ParentWave> out;
  for (const double speed : speeds) {
    for (const double mu : mus_deg) {
      for (const double omega : omegas) {
        out.push_back({omega, {radians(mu)}, speed});
      }
    }
  }
  return out;
}

// What is left of the difference is the section table (5e-3 of a coefficient, sections/table_accuracy_test)
// and interpolation in frequency; roll at resonance shows the damping's share of it.
TEST(ParentShip, WithLewisFormsIsTheProgramOnBoardToTheAccuracyOfItsTable) {
  const Hull hull = test::s175();
  for (const DiffractionLoads loads : {DiffractionLoads::kClassic, DiffractionLoads::kHaskind}) {
    const auto quick = std::make_unique<LoadedHull>();
    ASSERT_TRUE(load(hull, hull.loading, with_loads(loads), *quick));
    const ParentShip parent(hull, hull.loading, with_loads(loads),
                            {.sections = SectionMethod::kLewis, .num_threads = 2});
    EXPECT_NEAR(parent.hull().roll_natural_frequency / quick->roll_natural_frequency, 1.0, 1e-3);
    const auto asked = waves({0.0, 8.0}, {45.0, 90.0, 150.0}, {0.3, 0.5, 0.8});
    for (const ParentResponse& solved : parent.solve(asked)) {
      const MotionTransfer own =
          motion_transfer(*quick, solved.wave.omega, solved.wave.mu, solved.wave.speed);
      EXPECT_DOUBLE_EQ(solved.transfer.encounter_frequency, own.encounter_frequency);
      for (std::size_t j = 0; j < 6; ++j) {
        const double scale = j < 3 ? 1.0 : wave_number(solved.wave.omega, hull.loading.gravity);
        EXPECT_LT(std::abs(solved.transfer.motion[j] - own.motion[j]), 0.01 * scale)
            << "motion " << j << ", omega " << solved.wave.omega << ", mu " << degrees(solved.wave.mu.radians)
            << ", speed " << solved.wave.speed;
      }
    }
  }
}

// Haskind's relation of a hull of one section: |X_j|^2 = rho g^2 b_jj L / omega of the ship's own length, and
// X_4 / X_2 = b_24 / b_22. Not used anywhere in the solution by boundary values.
TEST(ParentShip, LoadsByBoundaryValuesObeyHaskindInBeamSeas) {
  const Hull hull = test::box_barge(100.0, 20.0, 7.0, 12.0, 5);
  for (const SectionMethod method : {SectionMethod::kCloseFit, SectionMethod::kFrank}) {
    const ParentShip parent(hull, hull.loading, with_loads(DiffractionLoads::kBoundaryValue),
                            {.sections = method});
    const double rho = parent.hull().density;
    const double g = parent.hull().gravity;
    for (const ParentResponse& solved : parent.solve(waves({0.0}, {90.0}, {0.4, 0.7, 1.0, 1.4}))) {
      const auto damping = [&](StripQuantity q) { return solved.integrals.plain[q][0] / hull.lpp; };
      const double per_metre = rho * g * g / solved.wave.omega;
      // The box's mapping is rounded at the bilge, and so its pressure is on another contour than its flow.
      const double tolerance = method == SectionMethod::kFrank ? 0.01 : 0.02;
      EXPECT_NEAR(std::abs(solved.load[1]) / hull.lpp / std::sqrt(per_metre * damping(kB22)), 1.0, tolerance);
      EXPECT_NEAR(std::abs(solved.load[2]) / hull.lpp / std::sqrt(per_metre * damping(kB33)), 1.0, tolerance);
      const Complex lever = solved.load[3] / solved.load[1];
      EXPECT_NEAR(lever.real(), damping(kB24) / damping(kB22), 0.05);
      EXPECT_NEAR(lever.imag(), 0.0, 0.05);
    }
  }
}

// A raft follows the wave: the deviations are of the order of k B and (k L)^2/24, k B = 0.017 and 0.002 here.
TEST(ParentShip, FollowsLongWaves) {
  const Hull hull = test::s175();
  const ParentShip parent(hull, hull.loading, with_loads(DiffractionLoads::kBoundaryValue));
  for (const ParentResponse& solved : parent.solve(waves({0.0}, {40.0, 90.0, 150.0}, {0.08}))) {
    const double k = wave_number(solved.wave.omega, hull.loading.gravity);
    const double mu = solved.wave.mu.radians;
    const Complex i(0.0, 1.0);
    const std::array<Complex, 6> follows = {
        -i * std::cos(mu),     -i * std::sin(mu),    1.0,
        -i * k * std::sin(mu), i * k * std::cos(mu), -k * std::sin(mu) * std::cos(mu)};
    for (std::size_t j = 0; j < 6; ++j) {
      const double scale = j < 3 ? 1.0 : k;
      // Roll: its resonance is 4.4 times as fast, 1/(1 - 1/4.4^2) = 1.054 at 0.08 rad/s.
      // Yaw: her mass is spread wider along her length than the water that she displaces.
      const double tolerance = j == 3 ? 0.08 : j == 5 ? 0.12 : 0.03;
      EXPECT_LT(std::abs(solved.transfer.motion[j] - follows[j]), tolerance * scale)
          << j << " " << degrees(mu);
    }
  }
}

TEST(ParentShip, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Hull hull = test::s175();
  const StripMethod method = with_loads(DiffractionLoads::kBoundaryValue, StripVariant::kOrdinary);
  const auto asked = waves({0.0, 10.0}, {30.0, 120.0}, {0.4, 0.6});
  const ParentShip alone(hull, hull.loading, method, {.num_threads = 1});
  const ParentShip shared(hull, hull.loading, method, {.num_threads = 3});
  const auto one = alone.solve(asked);
  const auto three = shared.solve(asked);
  for (std::size_t w = 0; w < asked.size(); ++w) {
    EXPECT_EQ(one[w].transfer.motion, three[w].transfer.motion);
    EXPECT_EQ(one[w].load, three[w].load);
    EXPECT_EQ(one[w].added_resistance, three[w].added_resistance);
  }
}

TEST(ParentShip, AnsweringToItsOwnDampingChangesNothing) {
  const Hull hull = test::s175();
  const ParentShip parent(hull, hull.loading, with_loads(DiffractionLoads::kBoundaryValue));
  const auto scratch = std::make_unique<LoadedHull>(parent.hull());
  const double damping = reference_roll_damping(parent.hull().roll_damping, 5.0);
  for (const ParentResponse& solved : parent.solve(waves({5.0}, {60.0, 120.0}, {0.35, 0.6}))) {
    const MotionTransfer same = ParentShip::damped(solved, damping, *scratch);
    const MotionTransfer less = ParentShip::damped(solved, 0.0, *scratch);
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_LT(std::abs(same.motion[j] - solved.transfer.motion[j]),
                1e-12 * std::abs(solved.transfer.motion[j]));
    }
    EXPECT_GT(std::abs(less.motion[3]), std::abs(same.motion[3]));
  }
}

TEST(ParentShip, RefusesWavesOutsideItsFrequenciesAndLoadingsThatDoNotFloat) {
  const Hull hull = test::s175();
  const ParentShip parent(hull, hull.loading, StripMethod{});
  EXPECT_THROW(static_cast<void>(parent.solve(waves({0.0}, {90.0}, {15.0}))), std::invalid_argument);
  Loading top_heavy = hull.loading;
  top_heavy.kg = 12.0;
  EXPECT_THROW(ParentShip(hull, top_heavy, StripMethod{}), std::invalid_argument);
}

}  // namespace
}  // namespace quickstrip
