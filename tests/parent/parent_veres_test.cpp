// The S-175 by the parent program against ShipX VERES, an independent strip program with true sections and
// solved diffraction (tests/golden/s175_veres_amplitudes.csv; source there). Metric and window of
// hull_tool/transfer_comparison.hpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/base/angles.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/transfer_comparison.hpp"
#include "sim/hull_tool/transfer_file.hpp"
#include "sim/parent/parent_ship.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

using hull_tool::CurveDeviation;

std::vector<CurveDeviation> against_veres(SectionMethod sections, double speed_kn) {
  const Hull hull = test::s175();
  const StripMethod method{.variant = StripVariant::kModified,
                           .loads = DiffractionLoads::kBoundaryValue,
                           .surge = SurgeTerms::kInertiaOnly};
  const ParentShip parent(hull, hull.loading, method, {.sections = sections, .num_threads = 2});
  auto values =
      hull_tool::read_transfer_file(QUICKSTRIP_SOURCE_DIR "/tests/golden/s175_veres_amplitudes.csv");
  std::erase_if(values, [&](const auto& value) { return value.speed_kn != speed_kn; });
  return hull_tool::compare_transfer(
      parent.hull(), values, {}, hull_tool::ComparisonPoint::kWaterline, [&](const auto& wanted) {
        std::vector<ParentWave> waves;
        for (const hull_tool::TransferValue& value : wanted) {
          waves.push_back({value.omega, {wrap_pi(radians(value.mu_deg))}, from_knots(value.speed_kn)});
        }
        std::vector<MotionTransfer> out;
        for (const ParentResponse& response : parent.solve(waves)) {
          out.push_back(response.transfer);
        }
        return out;
      });
}

// Largest RMS of a direction, and largest difference of a frequency, both in per cent of the curve's scale.
struct Bound {
  double rms;
  double worst;
};

void expect_within(const std::vector<CurveDeviation>& curves, const std::array<Bound, 6>& bounds) {
  ASSERT_FALSE(curves.empty());
  for (const CurveDeviation& curve : curves) {
    const Bound& bound = bounds[curve.motion];
    EXPECT_LT(curve.rms_percent, bound.rms)
        << "motion " << curve.motion << ", mu " << curve.mu_deg << ", " << curve.speed_kn << " kn";
    EXPECT_LT(std::abs(curve.worst_percent), bound.worst)
        << "motion " << curve.motion << ", mu " << curve.mu_deg << ", " << curve.speed_kn << " kn, omega "
        << curve.worst_omega;
  }
}

// What is left: VERES leaves the moment of the longitudinal pressure out of pitch (1.6 % of pitch; without it
// 0.4 %), and its heave is 1.5 ... 3 % smaller about omega = 0.84 rad/s in every direction and at both
// speeds.
TEST(ParentAgainstVeres, AtRestRmsIsBelowOnePerCentButOfPitch) {
  expect_within(against_veres(SectionMethod::kCloseFit, 0.0),
                {{{0.3, 0.8}, {0.4, 0.8}, {1.2, 4.0}, {0.5, 1.2}, {2.8, 9.0}, {1.0, 2.5}}});
}

TEST(ParentAgainstVeres, AtTwentyKnotsFromAbeamAndAheadRmsIsBelowThreeHalvesPerCent) {
  auto curves = against_veres(SectionMethod::kCloseFit, 20.0);
  std::erase_if(curves, [](const CurveDeviation& curve) { return curve.mu_deg < 90.0; });
  expect_within(curves, {{{0.3, 0.8}, {0.4, 0.8}, {1.2, 3.0}, {0.4, 1.0}, {1.5, 3.5}, {0.6, 1.5}}});
}

// The worst is at omega_e = 0.118 rad/s, next to the floor, where surge, sway and yaw grow as its inverse
// square.
TEST(ParentAgainstVeres, AtTwentyKnotsInQuarteringSeasRmsIsBelowThreePerCent) {
  auto curves = against_veres(SectionMethod::kCloseFit, 20.0);
  std::erase_if(curves, [](const CurveDeviation& curve) { return curve.mu_deg > 45.0; });
  expect_within(curves, {{{0.9, 2.5}, {3.0, 12.0}, {0.5, 1.0}, {2.0, 7.5}, {2.0, 3.5}, {3.0, 12.0}}});
}

}  // namespace
}  // namespace quickstrip
