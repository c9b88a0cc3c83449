// Ships transformed: what was asked for is reached, what should stay stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/response/point_motion.hpp"
#include "core/sea/spectrum.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "sim/hull_tool/hull_scale.hpp"
#include "sim/hull_tool/station_shift.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Ship {
  Hull hull;
  ImmersedSections sections;
  Hydrostatics hydrostatics;
};

void float_ship(Ship& ship) {
  ASSERT_TRUE(immerse(ship.hull, ship.hull.loading, ship.sections).ok());
  const auto h = hydrostatics(ship.hull, ship.hull.loading, ship.sections);
  ASSERT_TRUE(h.ok());
  ship.hydrostatics = *h;
}

std::unique_ptr<Ship> float_copy(const Hull& hull) {
  auto ship = std::make_unique<Ship>();
  ship->hull = hull;
  float_ship(*ship);
  return ship;
}

// The corners and middles of the paper's Figure 3.
constexpr double kCb[] = {-0.04, 0.0, 0.04};
constexpr double kLcb[] = {-0.015, 0.0, 0.015};

Status shift(const Ship& ship, const FormChange& change, ShiftedHull& out) {
  return shift_stations(ship.hull, ship.sections, ship.hydrostatics, change, out);
}

TEST(StationShift, ReachesTheBlockCoefficientAndTheCentreOfBuoyancyOfThePapersFigure) {
  const auto ship = float_copy(test::s175());
  const auto out = std::make_unique<ShiftedHull>();
  for (const double cb : kCb) {
    for (const double lcb : kLcb) {
      ASSERT_TRUE(shift(*ship, {cb, lcb * 175.0}, *out).ok()) << cb << " " << lcb;
      const auto moved = float_copy(out->hull);
      // Newton's method ends at 1e-8 of CB and of lpp.
      EXPECT_NEAR(moved->hydrostatics.cb, ship->hydrostatics.cb + cb, 2e-8);
      EXPECT_NEAR(moved->hydrostatics.lcb, ship->hydrostatics.lcb + lcb * 175.0, 4e-6);
      // lpp, breadth, draught and the midship section are those of before.
      EXPECT_EQ(moved->hull.lpp, 175.0);
      EXPECT_EQ(moved->hydrostatics.cm, ship->hydrostatics.cm);
      EXPECT_EQ(moved->hydrostatics.draught_at_lcb, 9.5);
      EXPECT_NEAR(moved->hydrostatics.volume / ship->hydrostatics.volume,
                  moved->hydrostatics.cb / ship->hydrostatics.cb, 1e-12);
    }
  }
}

TEST(StationShift, OfNothingChangesNothing) {
  const auto ship = float_copy(test::s175());
  const auto out = std::make_unique<ShiftedHull>();
  ASSERT_TRUE(shift(*ship, {}, *out).ok());
  for (std::size_t i = 0; i < ship->hull.stations.size(); ++i) {
    EXPECT_EQ(out->hull.stations[i].x, ship->hull.stations[i].x);
  }
  EXPECT_EQ(out->hydrostatics.volume, ship->hydrostatics.volume);
  EXPECT_EQ(out->hydrostatics.gml, ship->hydrostatics.gml);
}

TEST(StationShift, ThereAndBackIsTheSameShip) {
  const auto ship = float_copy(test::s175());
  const auto there = std::make_unique<ShiftedHull>();
  const auto back = std::make_unique<ShiftedHull>();
  for (const double cb : kCb) {
    for (const double lcb : kLcb) {
      ASSERT_TRUE(shift(*ship, {cb, lcb * 175.0}, *there).ok());
      const auto moved = float_copy(there->hull);
      ASSERT_TRUE(shift(*moved, {-cb, -lcb * 175.0}, *back).ok());
      double worst = 0.0;
      for (std::size_t i = 0; i < ship->hull.stations.size(); ++i) {
        worst = std::max(worst, std::fabs(back->hull.stations[i].x - ship->hull.stations[i].x));
      }
      // As near as Newton's method ends: 1e-8 of CB and lpp, times what the swing answers to it (some ten).
      EXPECT_LT(worst, 1e-6 * 175.0) << cb << " " << lcb;
      EXPECT_NEAR(back->hydrostatics.gml, ship->hydrostatics.gml, 1e-6 * ship->hydrostatics.gml);
      EXPECT_NEAR(back->hydrostatics.bm, ship->hydrostatics.bm, 1e-6 * ship->hydrostatics.bm);
    }
  }
}

// Slopes of the curve of areas between the stations.
std::vector<double> slopes(const Ship& ship) {
  std::vector<double> out;
  for (std::size_t i = 1; i < ship.sections.size(); ++i) {
    out.push_back((ship.sections[i].area - ship.sections[i - 1].area) /
                  (ship.sections[i].x - ship.sections[i - 1].x));
  }
  return out;
}

double sharpest_bend(const std::vector<double>& slopes) {
  double bend = 0.0;
  for (std::size_t i = 1; i < slopes.size(); ++i) {
    bend = std::max(bend, std::fabs(slopes[i] - slopes[i - 1]));
  }
  return bend;
}

TEST(StationShift, KeepsTheCurveOfAreasSmooth) {
  const auto ship = float_copy(test::s175());
  const auto before = slopes(*ship);
  const auto out = std::make_unique<ShiftedHull>();
  for (const double cb : kCb) {
    for (const double lcb : kLcb) {
      ASSERT_TRUE(shift(*ship, {cb, lcb * 175.0}, *out).ok());
      const auto moved = float_copy(out->hull);
      const auto after = slopes(*moved);
      ASSERT_EQ(after.size(), before.size());
      for (std::size_t i = 0; i < after.size(); ++i) {
        // Every section keeps its area; neighbours keep their order, at 0.5 ... 1.5 of their distance.
        EXPECT_EQ(moved->sections[i].area, ship->sections[i].area);
        EXPECT_EQ(after[i] > 0.0, before[i] > 0.0);
        if (before[i] != 0.0) {
          EXPECT_GT(after[i] / before[i], 1.0 / 1.5);
          EXPECT_LT(after[i] / before[i], 1.0 / 0.5);
        }
      }
      EXPECT_LT(sharpest_bend(after), 1.5 * sharpest_bend(before)) << cb << " " << lcb;
    }
  }
}

TEST(StationShift, SaysHowMuchIsPossibleWhereTooMuchIsAskedFor) {
  const auto ship = float_copy(test::s175());
  const auto out = std::make_unique<ShiftedHull>();
  const FormChange much{0.2, 0.0};
  ASSERT_EQ(shift(*ship, much, *out).error(), Error::kOutOfRange);
  const double share = possible_share(ship->hull, ship->sections, ship->hydrostatics, much);
  EXPECT_TRUE(shift(*ship, {share * much.cb, 0.0}, *out).ok());
  EXPECT_FALSE(shift(*ship, {(share + 0.002) * much.cb, 0.0}, *out).ok());
  EXPECT_GT(share * much.cb, 0.08);  // twice what the paper's figure has
}

TEST(StationShift, MovesAHullOfMinimalFormWithTrimToo) {
  Hull hull = test::s175();
  for (Station& station : hull.stations) {  // those that reach the base line, at a draught that falls forward
    station.draught = 9.5;
  }
  const auto offsets = float_copy(hull);
  Hull minimal = hull;
  minimal.stations.clear();
  for (const ImmersedSection& section : offsets->sections) {
    if (section.breadth > 0.0 && section.draught == 9.5) {
      Station station;
      station.x = section.x;
      station.breadth = section.breadth;
      station.draught = 9.5 + (87.5 - section.x) * 0.004;
      station.area = section.area;
      QS_CHECK(minimal.stations.push_back(station));
    }
  }
  minimal.loading.draught_aft = 9.5 + 87.5 * 0.004;
  minimal.loading.draught_fwd = 9.5 - 87.5 * 0.004;
  const auto ship = float_copy(minimal);
  const auto out = std::make_unique<ShiftedHull>();
  ASSERT_TRUE(shift(*ship, {0.04, 2.0}, *out).ok());
  EXPECT_NEAR(out->hydrostatics.cb, ship->hydrostatics.cb + 0.04, 2e-8);
  EXPECT_NEAR(out->hydrostatics.lcb, ship->hydrostatics.lcb + 2.0, 4e-6);
}

std::unique_ptr<LoadedHull> loaded(const Hull& hull) {
  auto out = std::make_unique<LoadedHull>();
  StripMethod method;
  method.surge = SurgeTerms::kInertiaOnly;  // viscous surge damping has the length in metres in it
  EXPECT_TRUE(load(hull, hull.loading, method, *out).ok());
  return out;
}

TEST(StationShift, RefusesAHullThatIsFullFromEndToEnd) {
  const auto ship = float_copy(test::box_barge(100.0, 20.0, 6.0, 10.0));
  const auto out = std::make_unique<ShiftedHull>();
  EXPECT_EQ(shift(*ship, {-0.01, 0.0}, *out).error(), Error::kOutOfRange);
  EXPECT_EQ(shift(*ship, {0.0, 1.0}, *out).error(), Error::kOutOfRange);
  EXPECT_EQ(possible_share(ship->hull, ship->sections, ship->hydrostatics, {-0.01, 0.0}), 0.0);
}

// Significant vertical acceleration [m/s2] at the paper's point in its Beaufort 8, bow-quartering seas, Fn
// 0.20.
double acceleration_of_the_paper(const Hull& hull) {
  const auto ship = loaded(hull);
  const auto spectrum =
      spectrum_of({4.9, 8.4, PeriodKind::kMean, WaveFrom{0.0}, 0.0, SpectrumShape::kBretschneider, 1.0});
  const double speed = 0.2 * std::sqrt(kStandardGravity * hull.lpp);
  const Position point{0.75 * hull.lpp - ship->hydrostatics.lcb, 0.375 * hull.breadth,
                       0.5 * hull.loading.draught_aft - ship->g_height};
  constexpr double kStep = 0.02;
  double m0 = 0.0;
  for (double omega = 0.2; omega < 2.2; omega += kStep) {
    const auto motion = motion_transfer(*ship, omega, {radians(135.0)}, speed);
    m0 +=
        kStep * density(*spectrum, omega) * std::norm(point_acceleration(motion, point, kStandardGravity).z);
  }
  return 2.0 * std::sqrt(m0);
}

// [Journee1992] §5 of its Figure 3: the centre of buoyancy and the block coefficient change the acceleration
// hardly, size changes it strongly. Found -6 ... +8 % and -45 ... +60 %.
TEST(Transform, ShowsWhatThePaperSaysOfFormAndSize) {
  const auto ship = float_copy(test::s175());
  const double before = acceleration_of_the_paper(ship->hull);
  const auto out = std::make_unique<ShiftedHull>();
  for (const FormChange& change :
       {FormChange{-0.04, 0.0}, FormChange{0.04, 0.0}, FormChange{0.0, -2.625}, FormChange{0.0, 2.625}}) {
    ASSERT_TRUE(shift(*ship, change, *out).ok());
    const double after = acceleration_of_the_paper(out->hull);
    std::printf("CB %+.2f, LCB %+.3f m: acceleration %.3f for %.3f m/s2\n", change.cb, change.lcb, after,
                before);
    EXPECT_NEAR(after, before, 0.1 * before);
  }
  for (const double scale : {0.5, 1.5}) {
    const auto scaled = std::make_unique<Hull>(ship->hull);
    scale_by_froude(*scaled, scale);
    const double after = acceleration_of_the_paper(*scaled);
    std::printf("scale %.1f: acceleration %.3f for %.3f m/s2\n", scale, after, before);
    EXPECT_GT(std::fabs(after - before), 0.3 * before);
    EXPECT_EQ(after > before, scale < 1.0);
  }
}

}  // namespace
}  // namespace quickstrip::hull_tool
