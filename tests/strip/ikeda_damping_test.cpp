// Roll damping of a whole ship after Ikeda: against an independent evaluation of the same formulas, against
// the simple formula, and against what must follow from scale, speed and the place of G.
#include "core/strip/ikeda_damping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"
#include "core/strip/hydrodynamic_coefficients.hpp"
#include "core/strip/loaded_hull.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

using test::s175;
using test::scaled;

std::unique_ptr<LoadedHull> loaded(const Hull& hull) {
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, StripMethod{}, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

// As in the reference data: KG 9.52 m, keels of 45 x 0.45 m amidships.
Hull reference_ship() {
  Hull hull = s175();
  hull.loading.kg = 9.52;
  hull.loading.viscosity = 1.188e-6;
  hull.roll_damping.method = RollDampingMethod::kIkeda;
  hull.roll_damping.bilge_keel = BilgeKeel{65.0, 110.0, 0.45};
  return hull;
}

RollDampingComponents components_of(const LoadedHull& hull, double speed, double amplitude, double omega) {
  return roll_damping_components(hull.roll_damping, speed, amplitude, omega);
}

std::vector<std::vector<double>> reference_rows() {
  std::ifstream file(QUICKSTRIP_SOURCE_DIR "/tests/golden/s175_ikeda_reference.csv");
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'F') {
      continue;
    }
    std::istringstream text(line);
    std::vector<double> row;
    for (std::string field; std::getline(text, field, ',');) {
      row.push_back(std::stod(field));
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(IkedaDamping, ComponentsOfTheS175AreThoseOfTheReferenceData) {
  const auto ship = loaded(reference_ship());
  const auto rows = reference_rows();
  ASSERT_EQ(rows.size(), 90u);
  std::array<double, 7> worst{};
  for (const auto& row : rows) {
    const double speed = row[1];
    const double omega = row[2];
    const RollDampingComponents ours = components_of(*ship, speed, radians(row[3]), omega);
    const double factor =
        ikeda_wave_speed_factor(omega, speed, ship->hydrostatics.draught_at_lcb, ship->gravity);
    // Lift with Journee's smooth kappa (column 7); the wave factor is printed only.
    const std::array<double, 6> got = {ours.friction,    ours.eddy,          ours.lift,
                                       ours.keel_normal, ours.keel_pressure, factor};
    const std::array<double, 6> wanted = {row[4], row[5], row[7], row[8], row[9], row[16]};
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (wanted[i] == 0.0) {
        EXPECT_EQ(got[i], 0.0);
        continue;
      }
      worst[i] = std::max(worst[i], std::fabs(got[i] / wanted[i] - 1.0));
      // The figure. Same formulas; what differs is where sections are clipped and how keels are cut.
      EXPECT_NEAR(got[i] / wanted[i], 1.0, 0.02)
          << "component " << i << " at " << speed << ' ' << omega << ' ' << row[3];
    }
    const RollDampingComponents still = components_of(*ship, 0.0, radians(row[3]), omega);
    EXPECT_NEAR(ours.eddy / still.eddy, row[17], 2e-5 * row[17]);  // digits of the file
  }
  std::printf(
      "largest differences: friction %.4f, eddies %.4f, lift %.4f, keel normal %.4f, pressure %.4f, wave "
      "factor %.5f\n",
      worst[0], worst[1], worst[2], worst[3], worst[4], worst[5]);
}

TEST(IkedaDamping, LiftWithTheStepsOfKappaIsTheReferenceDatasOtherColumn) {
  // kappa = 0.1 (C_M 0.92 ... 0.97) against the smooth fit's 0.17: the ratio of k_N.
  const auto ship = loaded(reference_ship());
  const double base = kTwoPi * 9.5 / 175.0;
  const double per_kappa = 4.1 * 25.4 / 175.0 - 0.045;
  const double smooth = base + lift_kappa(ship->hydrostatics.cm) * per_kappa;
  const double stepped = base + 0.1 * per_kappa;
  const double ours = components_of(*ship, 6.21505, 0.1, 0.35).lift;
  EXPECT_NEAR(ours * stepped / smooth, 2.85628e7, 0.005 * 2.85628e7);  // C_M and C_B to four digits
}

TEST(IkedaDamping, StripTheoryOfAHullWithClosedEndsHasNoRollDampingOfSpeedToBeCountedTwice) {
  const auto ship = loaded(reference_ship());
  for (const double omega : {0.2, 0.35, 0.7}) {
    const double still = hydrodynamic_coefficients(*ship, omega, 0.0).b[3][3];
    EXPECT_NEAR(hydrodynamic_coefficients(*ship, omega, 10.0).b[3][3] / still, 1.0, 1e-9)
        << omega;  // rounding
  }
}

TEST(IkedaDamping, WaveDampingAtSpeedIsIkedasLessWhatStripTheoryHas) {
  // A hull that ends in a transom, so that strip theory has a part of its own.
  Hull hull = reference_ship();
  while (hull.stations.back().x > 120.0) {
    ASSERT_TRUE(hull.stations.resize(hull.stations.size() - 1));
  }
  auto ship = std::make_unique<LoadedHull>();
  StripMethod no_end_terms;
  no_end_terms.end_terms = false;
  ASSERT_TRUE(load(hull, hull.loading, no_end_terms, *ship).ok());
  const auto keel = hull.roll_damping.bilge_keel;
  const auto by_ikeda = ikeda_roll_damping(*ship, keel, 1.188e-6);
  ASSERT_TRUE(by_ikeda.ok());
  for (const double omega : {0.3, 0.37, 0.6}) {
    for (const double speed : {3.0, 8.0}) {
      const double still = hydrodynamic_coefficients(*ship, omega, 0.0).b[3][3];
      const double own = hydrodynamic_coefficients(*ship, omega, speed).b[3][3];
      EXPECT_GT(std::fabs(own / still - 1.0), 1e-3);
      const double factor =
          ikeda_wave_speed_factor(omega, speed, ship->hydrostatics.draught_at_lcb, ship->gravity);
      const double added = roll_damping_components(*by_ikeda, speed, 0.1, omega).wave;
      const double wanted = std::max(0.0, std::min(factor, 12.0) * still - own);
      EXPECT_NEAR(added, wanted, 0.02 * (wanted + still)) << omega << ' ' << speed;  // table over frequency
      EXPECT_EQ(roll_damping_components(*by_ikeda, 0.0, 0.1, omega).wave, 0.0);
    }
  }
}

TEST(IkedaDamping, TableOfTheKeelsPressureMeetsTheDirectSum) {
  const Hull hull = reference_ship();
  const auto ship = loaded(hull);
  double worst = 0.0;
  double at = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double amplitude = RollAmplitudeNodes::kLast * i / 400.0;
    const double direct = keel_pressure_damping(*ship, *hull.roll_damping.bilge_keel, amplitude);
    const double table = components_of(*ship, 0.0, amplitude, 1.0).keel_pressure;
    const double error = std::fabs(table / direct - 1.0);
    at = error > worst ? amplitude : at;
    worst = std::max(worst, error);
  }
  std::printf("largest error of the table: %.2g at %.1f degrees\n", worst, at * 180.0 / kPi);
  // Parabolas over 1.4 degrees: the pressure's cosine of the arc is steepest at the beginning.
  EXPECT_LT(worst, 3e-3);
}

TEST(IkedaDamping, FourPlacesAPanelOfTheKeelAreEnough) {
  // Against the keel in 450 pieces, each with four places of its own.
  const Hull hull = reference_ship();
  const auto ship = loaded(hull);
  double fine = 0.0;
  constexpr int kPieces = 450;
  for (int i = 0; i < kPieces; ++i) {
    const double from = 65.0 + 45.0 * i / kPieces;
    fine += keel_pressure_damping(*ship, {from, from + 45.0 / kPieces, 0.45}, 0.2);
  }
  EXPECT_NEAR(keel_pressure_damping(*ship, {65.0, 110.0, 0.45}, 0.2), fine, 1e-3 * fine);
}

TEST(IkedaDamping, GaussianRollIsTheRayleighMeanOfHarmonicRoll) {
  const Hull hull = reference_ship();
  const auto ship = loaded(hull);
  for (const double rms : {0.01, 0.05, 0.1, 0.17}) {
    double energy = 0.0;
    double of_amplitude = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const double a = rms * 8.0 * (i + 0.5) / kSteps;
      const double density = a / (rms * rms) * std::exp(-0.5 * a * a / (rms * rms)) * rms * 8.0 / kSteps;
      energy += density * a * a * added_roll_damping(ship->roll_damping, 3.0, a, 0.4);
      of_amplitude += density * a * a;
    }
    const double mean = energy / of_amplitude;
    // Interpolation in two tables, 1e-3 of the pressure each.
    EXPECT_NEAR(added_roll_damping_gaussian(ship->roll_damping, 3.0, rms, 0.4), mean, 1e-3 * mean) << rms;
  }
}

TEST(IkedaDamping, DampingQuadraticInTheRateIsThatOfStochasticLinearisation) {
  Hull hull = reference_ship();
  hull.roll_damping.bilge_keel.reset();  // bare: eddies are all that is nonlinear
  const auto ship = loaded(hull);
  constexpr double kRms = 0.08;
  constexpr double kOmega = 0.4;
  const double linear = added_roll_damping(ship->roll_damping, 0.0, 0.0, kOmega);
  const double b2 = ship->roll_damping.eddy / (8.0 / (3.0 * kPi));  // eddy = 8/(3 pi) B2
  EXPECT_NEAR(added_roll_damping_gaussian(ship->roll_damping, 0.0, kRms, kOmega) - linear,
              std::sqrt(8.0 / kPi) * kOmega * kRms * b2, 1e-9 * b2);  // closed form
}

TEST(IkedaDamping, VanishingRollLeavesTheLinearPartsAlone) {
  const auto ship = loaded(reference_ship());
  const RollDampingComponents still = components_of(*ship, 5.0, 0.0, ship->roll_natural_frequency);
  EXPECT_EQ(still.eddy, 0.0);
  EXPECT_GT(still.friction, 0.0);
  EXPECT_GT(still.lift, 0.0);
  EXPECT_GT(still.keel_normal, 0.0);  // C_D ~ b / (l amplitude): a force linear in the rate
  EXPECT_DOUBLE_EQ(still.sum(), small_roll_damping(ship->roll_damping, 5.0));
  // Damping grows with roll, and linearly in eddies and normal force.
  const RollDampingComponents a = components_of(*ship, 5.0, 0.1, 0.4);
  const RollDampingComponents b = components_of(*ship, 5.0, 0.2, 0.4);
  EXPECT_NEAR(b.eddy / a.eddy, 2.0, 1e-12);
  EXPECT_GT(b.keel_pressure, a.keel_pressure);
  EXPECT_TRUE(depends_on_amplitude(ship->roll_damping));
}

TEST(IkedaDamping, FroudeScalingHoldsFrictionExceptedUnlessViscosityIsScaledToo) {
  constexpr double kScale = 4.0;
  Hull large_hull = scaled(reference_ship(), kScale);  // viscosity x scale^1.5
  const auto ship = loaded(reference_ship());
  const auto large = loaded(large_hull);
  const double times = std::pow(kScale, 4.5);  // N m s: mass L^2 / T
  const double speed = 5.0;
  const double omega = 0.4;
  const auto small_parts = components_of(*ship, speed, 0.15, omega);
  const auto large_parts = components_of(*large, speed * 2.0, 0.15, omega / 2.0);
  EXPECT_NEAR(large_parts.friction / small_parts.friction, times, 1e-6 * times);  // rounding of offsets
  EXPECT_NEAR(large_parts.eddy / small_parts.eddy, times, 1e-6 * times);
  EXPECT_NEAR(large_parts.lift / small_parts.lift, times, 1e-6 * times);
  EXPECT_NEAR(large_parts.keel_normal / small_parts.keel_normal, times, 1e-6 * times);
  EXPECT_NEAR(large_parts.keel_pressure / small_parts.keel_pressure, times, 1e-6 * times);
  // Water as viscous as it is: laminar friction goes with sqrt(viscosity).
  large_hull.loading.viscosity = reference_ship().loading.viscosity;
  const auto in_water = loaded(large_hull);
  const double friction = components_of(*in_water, speed * 2.0, 0.15, omega / 2.0).friction;
  EXPECT_NEAR(friction / small_parts.friction, times * std::pow(kScale, -0.75), 1e-6 * times);
}

TEST(IkedaDamping, LiftingGAboveTheWaterlineRaisesEveryComponentAsPredicted) {
  // Ikeda's OG is positive below the waterline; here it goes from +0.5 m (G below) to -0.5 m (G above).
  Hull hull = reference_ship();
  hull.loading.gm = 1.0;  // stiffness kept
  hull.loading.kg = 9.0;
  const auto low = loaded(hull);
  hull.loading.kg = 10.0;
  const auto high = loaded(hull);
  EXPECT_NEAR(low->g_height, -0.5, 1e-9);
  EXPECT_NEAR(high->g_height, 0.5, 1e-9);
  const auto below = components_of(*low, 5.0, 0.1, 0.4);
  const auto above = components_of(*high, 5.0, 0.1, 0.4);
  // Lift: 1 - 1.4 OG/lR + 0.7 OG^2/(l0 lR) with lR = 4.75, l0 = 2.85.
  const auto lift = [](double og) { return 1.0 - 1.4 * og / 4.75 + 0.7 * og * og / (2.85 * 4.75); };
  EXPECT_NEAR(above.lift / below.lift, lift(-0.5) / lift(0.5), 1e-9);
  EXPECT_GT(lift(-0.5) / lift(0.5), 1.3);
  // Friction ~ r^2, r = (... - 2 OG) / pi: a metre adds 2/pi to r.
  const double surface = 1.7 * 9.5 + low->hydrostatics.cb * 25.4;
  const double reach = (0.887 + 0.145 * low->hydrostatics.cb) * surface;
  EXPECT_NEAR(above.friction / below.friction, std::pow((reach + 1.0) / (reach - 1.0), 2), 1e-9);
  EXPECT_GT(above.eddy, below.eddy);                // more depth below G
  EXPECT_GT(above.keel_normal, below.keel_normal);  // longer lever
  EXPECT_GT(above.keel_pressure, below.keel_pressure);
}

TEST(IkedaDamping, SimpleFormulaOfKawaharaIsMetWithinAFactorOfTwo) {
  // Kawahara's regression for this ship at omega 0.3491 (formulas §5, x 1e-3): eddies and keels at 5, 10 and
  // 20 degrees. It knows the hull by C_B, C_M and B/d alone, not its sections, hence the loose bound.
  const auto ship = loaded(reference_ship());
  const double unit = ship->hydrostatics.displacement * 25.4 * 25.4 * std::sqrt(2.0 * ship->gravity / 25.4);
  EXPECT_NEAR(unit, 1.396e10, 0.005e10);
  struct Figure {
    double degrees;
    double eddy;
    double keel;
  };
  for (const Figure& f : {Figure{5.0, 0.538, 1.33}, Figure{10.0, 1.08, 2.25}, Figure{20.0, 2.15, 4.53}}) {
    const auto ours = components_of(*ship, 0.0, radians(f.degrees), 0.349066);
    const double eddy = 1e3 * ours.eddy / unit;
    const double keel = 1e3 * (ours.keel_normal + ours.keel_pressure) / unit;
    std::printf("%4.0f deg: eddies %.3f (Kawahara %.3f), keels %.3f (%.3f)\n", f.degrees, eddy, f.eddy, keel,
                f.keel);
    EXPECT_GT(eddy, 0.5 * f.eddy);
    EXPECT_LT(eddy, 2.0 * f.eddy);
    EXPECT_GT(keel, 0.5 * f.keel);
    EXPECT_LT(keel, 2.0 * f.keel);
  }
}

TEST(IkedaDamping, RangeIsCheckedOfTheHullAndOfTheRoll) {
  const auto ship = loaded(reference_ship());
  const RollDampingModel& model = ship->roll_damping;
  EXPECT_EQ(model.outside_range, 0);
  EXPECT_EQ(roll_damping_outside_range(model, radians(10.0), 0.35), 0);
  EXPECT_EQ(roll_damping_outside_range(model, radians(21.0), 0.35), kOutsideAmplitude);
  EXPECT_EQ(roll_damping_outside_range(model, radians(10.0), 1.0), kOutsideFrequency);  // omega-hat 1.14
  EXPECT_NE(roll_damping_outside_range(model, std::nan(""), 0.35) & kOutsideAmplitude, 0);

  Hull hull = reference_ship();
  hull.roll_damping.bilge_keel = BilgeKeel{10.0, 160.0, 0.05};
  EXPECT_EQ(loaded(hull)->roll_damping.outside_range, kOutsideKeelBreadth | kOutsideKeelLength);
  Hull barge = test::box_barge(100.0, 20.0, 6.0, 10.0);
  barge.roll_damping.method = RollDampingMethod::kIkeda;
  const unsigned box = loaded(barge)->roll_damping.outside_range;
  EXPECT_EQ(box, kOutsideBlockCoefficient | kOutsideMidshipCoefficient | kOutsideSectionFullness);
}

TEST(IkedaDamping, ModelFollowsTheLoading) {
  const Hull hull = reference_ship();
  const auto at_design = loaded(hull);
  Loading light = hull.loading;
  light.draught_aft = 8.0;
  light.draught_fwd = 7.5;
  light.kg = 9.0;
  auto lighter = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(hull, light, StripMethod{}, *lighter).ok());
  EXPECT_NE(lighter->roll_damping.lift, at_design->roll_damping.lift);
  EXPECT_NE(lighter->roll_damping.keel_pressure[5], at_design->roll_damping.keel_pressure[5]);
  EXPECT_DOUBLE_EQ(lighter->roll_damping.natural_frequency, lighter->roll_natural_frequency);
}

TEST(IkedaDamping, ARatioReplacesIt) {
  const auto ship = loaded(reference_ship());
  set_roll_damping_ratio(*ship, 0.05);
  EXPECT_FALSE(depends_on_amplitude(ship->roll_damping));
  const double b44 = 2.0 * 0.05 * ship->restoring.c44 / ship->roll_natural_frequency;
  EXPECT_DOUBLE_EQ(added_roll_damping(ship->roll_damping, 7.0, 0.3, 0.6), b44);
  EXPECT_DOUBLE_EQ(added_roll_damping_gaussian(ship->roll_damping, 7.0, 0.3, 0.6), b44);
  EXPECT_DOUBLE_EQ(small_roll_damping(ship->roll_damping, 7.0), b44);
  EXPECT_EQ(roll_damping_outside_range(ship->roll_damping, 1.0, 5.0), 0);
}

}  // namespace
}  // namespace quickstrip
