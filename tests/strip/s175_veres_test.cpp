// Motions of the S-175 against another program: ShipX VERES 4.02.3, which solves the sectional diffraction
// problem on the true sections by strip theory of Salvesen, Tuck and Faltinsen. Some figures of its output
// for this ship, from the Marine Systems Simulator toolbox (MIT licence), anti-roll tanks removed: T 9.5 m,
// 24,610 t, KG 9.55 m, 5 % of critical roll damping added, no surge added mass. The independent check of
// first light, beside the tank.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

struct VeresPoint {
  double speed_kn;
  double mu_deg;
  std::size_t motion;  // 0 ... 5
  double omega;
  double amplitude;  // m/m or rad/m
  double tolerance;  // fraction of the amplitude
};

// Lewis sections and equivalent motions against true sections and diffraction: a few per cent; more at
// resonance, where a shift of 1 % in frequency moves the flank of the peak.
constexpr VeresPoint kPoints[] = {
    {0, 180, 2, 0.405367, 0.8118, 0.03},     {0, 180, 4, 0.546364, 2.1128e-2, 0.05},
    {0, 90, 1, 0.523599, 0.8180, 0.03},      {0, 90, 2, 0.785398, 1.4006, 0.05},
    {0, 90, 3, 0.349066, 9.1997e-2, 0.07},   {0, 90, 3, 0.483322, 1.4407e-2, 0.07},
    {20, 180, 2, 0.546364, 1.4675, 0.06},    {20, 180, 4, 0.546364, 3.4625e-2, 0.06},
    {20, 150, 3, 0.418879, 6.4358e-3, 0.12}, {20, 150, 5, 0.523599, 3.8303e-3, 0.06},
    {20, 30, 3, 0.571199, 4.7274e-2, 0.08},  {20, 30, 4, 0.523599, 1.4698e-2, 0.06}};

TEST(S175AgainstVeres, ModifiedMethodWithTheHaskindCorrectionAgreesWithinAFewPerCent) {
  const auto hull = std::make_unique<Hull>(test::s175());
  hull->loading.gravity = 9.81;
  hull->roll_damping.ratio = 0.05;
  StripMethod method;
  method.variant = StripVariant::kModified;
  method.surge = SurgeTerms::kInertiaOnly;
  const auto loaded = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(*hull, hull->loading, method, *loaded).ok());
  for (const VeresPoint& p : kPoints) {
    const MotionTransfer t =
        motion_transfer(*loaded, p.omega, EncounterAngle{radians(p.mu_deg)}, p.speed_kn * 1852.0 / 3600.0);
    const double amplitude = std::abs(t.motion[p.motion]);
    std::printf("S-175 %2.0f kn mu %3.0f motion %zu omega %.3f: %.4g, VERES %.4g (%+.1f %%)\n", p.speed_kn,
                p.mu_deg, p.motion + 1, p.omega, amplitude, p.amplitude,
                100.0 * (amplitude / p.amplitude - 1.0));
    EXPECT_NEAR(amplitude, p.amplitude, p.tolerance * p.amplitude);
  }
}

}  // namespace
}  // namespace quickstrip
