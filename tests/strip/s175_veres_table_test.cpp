// Motions of the S-175 against ShipX VERES, curve by curve: tests/golden/s175_veres_amplitudes.csv (source,
// licence and conventions at its head) by the comparison that `quickstrip-hull compare` prints. The figure of
// a curve is the root mean square of the difference of amplitudes over 0.2 < omega < 1.6, omega_e > 0.1, in %
// of max(peak, a quarter of the largest peak over the directions).
//
// An open strip program of the day misses VERES by 1 to 5 % at 10 knots and 3 to 11 % at 20 knots.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "sim/hull_tool/transfer_comparison.hpp"
#include "sim/hull_tool/transfer_file.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

using hull_tool::CurveDeviation;

constexpr double kNone = 0.0;  // no limit: the motion is nil there, or nobody relies on it

struct Limits {
  double speed_kn;
  double mu_deg;
  std::array<double, 6> percent;  // surge ... yaw
};

// Strip theory by Lewis sections against true sections with diffraction: a few per cent, more in
// waves from astern at speed, where the frequency of encounter is low. Yaw in beam seas at rest is what is
// left of a moment that nearly cancels between the ends: it hangs on the phase of each section's load.
constexpr std::array<Limits, 8> kLimits = {{
    {0, 180, {1.5, kNone, 2.0, kNone, 4.0, kNone}},
    {0, 150, {1.5, 2.5, 2.0, 3.5, 4.0, 4.0}},
    {0, 30, {1.5, 2.5, 2.0, 3.5, 4.0, 4.0}},
    {0, 90, {kNone, 2.5, 2.0, 3.5, kNone, 9.0}},
    {20, 180, {1.0, kNone, 2.5, kNone, 2.5, kNone}},
    {20, 150, {1.0, 2.0, 2.5, 5.0, 2.5, 4.0}},
    {20, 90, {kNone, 2.0, 3.0, 5.0, kNone, 4.0}},
    {20, 30, {3.0, 15.0, 4.0, 10.0, 11.0, 13.0}},
}};

const Limits& limits_of(const CurveDeviation& curve) {
  for (const Limits& limits : kLimits) {
    if (limits.speed_kn == curve.speed_kn && limits.mu_deg == curve.mu_deg) {
      return limits;
    }
  }
  ADD_FAILURE() << "no limits for " << curve.speed_kn << " kn, " << curve.mu_deg << " deg";
  return kLimits[0];
}

std::vector<CurveDeviation> s175_beside_veres() {
  const auto hull = std::make_unique<Hull>(test::s175());
  StripMethod method;
  method.variant = StripVariant::kModified;  // VERES' speed terms
  method.surge = SurgeTerms::kInertiaOnly;   // VERES has no surge added mass
  const auto loaded = std::make_unique<LoadedHull>();
  EXPECT_TRUE(load(*hull, hull->loading, method, *loaded).ok());
  const auto values =
      hull_tool::read_transfer_file(QUICKSTRIP_SOURCE_DIR "/tests/golden/s175_veres_amplitudes.csv");
  return hull_tool::compare_transfer(*loaded, values, {}, hull_tool::ComparisonPoint::kWaterline);
}

TEST(S175AgainstVeres, RootMeanSquareDeviationsOfAllMotionsAt0And20KnotsAreWithinTheirLimits) {
  std::size_t num_judged = 0;
  for (const CurveDeviation& curve : s175_beside_veres()) {
    const double limit = limits_of(curve).percent[curve.motion];
    if (!(limit > 0.0)) {
      continue;
    }
    ++num_judged;
    const std::string_view name = hull_tool::kMotionNames[curve.motion];
    std::printf(
        "S-175 %2.0f kn mu %3.0f %-5.*s: RMS %4.1f %%, limit %4.1f %%, worst %+5.1f %% at %.3f rad/s\n",
        curve.speed_kn, curve.mu_deg, static_cast<int>(name.size()), name.data(), curve.rms_percent, limit,
        curve.worst_percent, curve.worst_omega);
    EXPECT_LT(curve.rms_percent, limit) << name << " at " << curve.speed_kn << " kn, " << curve.mu_deg;
    EXPECT_GE(curve.num_frequencies, 9u);
  }
  EXPECT_EQ(num_judged, 38u);
}

// The limits above can be missed: without the Haskind correction beam seas are.
TEST(S175AgainstVeres, ClassicLoadsMissTheLimitsOfHeaveAndRollInBeamSeas) {
  const auto hull = std::make_unique<Hull>(test::s175());
  StripMethod method;
  method.variant = StripVariant::kModified;
  method.surge = SurgeTerms::kInertiaOnly;
  method.loads = DiffractionLoads::kClassic;
  const auto loaded = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(*hull, hull->loading, method, *loaded).ok());
  const auto values =
      hull_tool::read_transfer_file(QUICKSTRIP_SOURCE_DIR "/tests/golden/s175_veres_amplitudes.csv");
  const auto curves =
      hull_tool::compare_transfer(*loaded, values, {}, hull_tool::ComparisonPoint::kWaterline);
  int num_beam = 0;
  for (const CurveDeviation& curve : curves) {
    if (curve.mu_deg == 90.0 && (curve.motion == 2 || curve.motion == 3)) {
      ++num_beam;
      EXPECT_GT(curve.rms_percent, limits_of(curve).percent[curve.motion]);
    }
  }
  EXPECT_EQ(num_beam, 4);
}

}  // namespace
}  // namespace quickstrip
