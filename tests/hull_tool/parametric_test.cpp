// The ships given by formulas: the files that the project ships are what the formulas give, and such ships
// could sail.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "core/hull/imo_roll_period.hpp"
#include "core/strip/loaded_hull.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file.hpp"
#include "sim/hull_tool/parametric_form.hpp"
#include "sim/hull_tool/parametric_ships.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::hull_tool {
namespace {

std::unique_ptr<Hull> read_shipped(std::string name) {
  for (char& c : name) {
    c = c == '-' ? '_' : c;
  }
  auto hull = std::make_unique<Hull>();
  const FileStatus status =
      read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/" + name + ".hull.toml", *hull);
  EXPECT_TRUE(status.ok()) << status.line();
  return hull;
}

std::unique_ptr<LoadedHull> loaded(const Hull& hull) {
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, {}, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

TEST(ParametricShips, AreTheFilesThatTheProjectShips) {
  for (const std::string_view which : kParametricShips) {
    const auto file = read_shipped(std::string(which));
    const auto made = std::make_unique<Hull>();
    EXPECT_FALSE(make_parametric_ship(which, *made).empty());
    EXPECT_EQ(file->name.view(), made->name.view());
    EXPECT_EQ(file->lpp, made->lpp);
    // One unit of the last printed place: another C library may round the other way.
    const double place = which.starts_with("wigley") ? 1.1e-6 : 1.1e-3;
    ASSERT_EQ(file->stations.size(), made->stations.size());
    for (std::size_t i = 0; i < file->stations.size(); ++i) {
      const Station& a = file->stations[i];
      const Station& b = made->stations[i];
      EXPECT_NEAR(a.x, b.x, place);
      ASSERT_EQ(a.offsets.size(), b.offsets.size()) << which << " " << i;
      for (std::size_t k = 0; k < a.offsets.size(); ++k) {
        EXPECT_NEAR(a.offsets[k].y, b.offsets[k].y, place) << which << " " << a.x;
        EXPECT_NEAR(a.offsets[k].z, b.offsets[k].z, place) << which << " " << a.x;
      }
    }
    const auto same = [](double x, double y) { return std::fabs(x - y) < 1e-9; };
    EXPECT_TRUE(same(file->loading.kg, made->loading.kg)) << which;
    EXPECT_TRUE(same(file->loading.roll_gyradius, made->loading.roll_gyradius)) << which;
    EXPECT_TRUE(same(file->loading.pitch_gyradius, made->loading.pitch_gyradius)) << which;
    EXPECT_TRUE(same(file->loading.draught_aft, made->loading.draught_aft)) << which;
    EXPECT_EQ(file->roll_damping.ratio, made->roll_damping.ratio) << which;
    EXPECT_EQ(file->points.size(), made->points.size()) << which;
    EXPECT_TRUE(same(file->grid.speed_to, made->grid.speed_to)) << which;
  }
}

TEST(Tanker, HasTheParticularsOfTheModelTestsAndTheirMetacentricHeight) {
  const auto hull = read_shipped("tanker");
  const auto ship = loaded(*hull);
  const Hydrostatics& h = ship->hydrostatics;
  EXPECT_NEAR(h.volume, 234994.0, 50.0);   // fitted; offsets to the millimetre
  EXPECT_NEAR(h.lcb, 155.0 + 6.61, 0.01);  // fitted
  EXPECT_NEAR(h.gm, 5.78, 0.03 * 5.78);    // not fitted: it follows from our waterline and sections
  EXPECT_GT(h.cwp, 0.88);                  // 0.88 ... 0.92 of such ships
  EXPECT_LT(h.cwp, 0.92);
  // Deadweight 200,000 t and a light ship of 30,000 ... 42,000 t, 0.13 ... 0.17 of the displacement.
  EXPECT_GT(h.displacement, 230.0e6);
  EXPECT_LT(h.displacement, 242.0e6);
  // Laden tankers of that size roll in 12 ... 15 s.
  const double period = kTwoPi / ship->roll_natural_frequency;
  EXPECT_GT(period, 12.0);
  EXPECT_LT(period, 15.0);
}

TEST(Tanker, HasTheDampingAndTheSpeedOfThePaperInsideItsGrid) {
  const auto hull = read_shipped("tanker");
  EXPECT_EQ(hull->roll_damping.ratio, 0.075);
  EXPECT_GE(hull->grid.speed_to, from_knots(15.0));
}

TEST(Trawler, HasTheProportionsAndTheStabilityOfFishingVessels) {
  const auto hull = read_shipped("trawler");
  const auto ship = loaded(*hull);
  const Hydrostatics& h = ship->hydrostatics;
  EXPECT_EQ(hull->lpp, 30.60);
  EXPECT_EQ(hull->roll_damping.ratio, 0.050);
  EXPECT_GE(hull->grid.speed_to, from_knots(8.0));
  EXPECT_GT(hull->lpp / hull->breadth, 3.0);  // strip theory
  EXPECT_NEAR(h.cb, 0.56, 1e-3);
  EXPECT_GT(h.gm, 0.35);  // what IMO asks of fishing vessels
  EXPECT_LT(h.gm, 1.0);
  const double period = kTwoPi / ship->roll_natural_frequency;
  const auto estimate = imo_roll_period(hull->lpp, hull->breadth, 3.35, h.gm);
  ASSERT_TRUE(estimate.ok());
  EXPECT_NEAR(period, *estimate, 0.1 * *estimate);  // the scatter of the IS Code's formula
}

TEST(ParametricShips, HaveSectionsThatLewisFormsCanStandFor) {
  for (const char* name : {"tanker", "trawler"}) {
    const auto hull = read_shipped(name);
    const auto ship = loaded(*hull);
    EXPECT_FALSE(ship->has_replaced_section) << name;
    for (std::size_t i = 1; i < hull->stations.size(); ++i) {
      EXPECT_GT(hull->stations[i].x, hull->stations[i - 1].x);
    }
  }
}

TEST(ParametricForm, MeetsBlockCoefficientAndCentreOfBuoyancy) {
  ParametricForm form;
  form.lpp = 150.0;
  form.breadth = 22.0;
  form.draught = 8.5;
  form.depth = 12.0;
  form.cm = 0.98;
  form.waterline = {0.3, 0.0, 2.6, 2.8};
  form.deck = {0.6, 0.1, 4.0, 4.0};
  form.full_from = 0.42;
  form.full_to = 0.56;
  for (const double cb : {0.65, 0.72}) {
    for (const double lcb : {74.0, 76.0}) {
      form.cb = cb;
      form.lcb = lcb;
      const auto hull = std::make_unique<Hull>();
      hull->loading.kg = 8.0;
      ASSERT_TRUE(shape_hull(form, *hull).ok()) << cb << " " << lcb;
      const auto sections = std::make_unique<ImmersedSections>();
      ASSERT_TRUE(immerse(*hull, hull->loading, *sections).ok());
      const auto h = hydrostatics(*hull, hull->loading, *sections);
      ASSERT_TRUE(h.ok());
      EXPECT_NEAR(h->cb, cb, 1e-4);  // millimetres of offsets
      EXPECT_NEAR(h->lcb, lcb, 0.01);
      EXPECT_NEAR(h->cm, 0.98, 2e-3);  // the bilge by twenty chords
    }
  }
  form.cb = 0.95;
  const auto hull = std::make_unique<Hull>();
  EXPECT_FALSE(shape_hull(form, *hull).ok());
}

TEST(WigleyForm, IsTheFormulaOfTheReport) {
  // Amidships and at the waterline the terms are one: y = B/2; at half the depth of hull I amidships
  // (1 - 1/4) + 1/4 (1 - 2^-8) = 0.9990234375 of it, of hull III 3/4.
  EXPECT_DOUBLE_EQ(wigley_form(3, 0.0, 0.0), 0.15);
  EXPECT_DOUBLE_EQ(wigley_form(2, 0.0, 0.0), 0.3);
  EXPECT_DOUBLE_EQ(wigley_form(1, 0.0, 0.5 * 0.1875), 0.15 * 0.9990234375);
  EXPECT_DOUBLE_EQ(wigley_form(3, 0.0, 0.5 * 0.1875), 0.15 * 0.75);
  EXPECT_DOUBLE_EQ(wigley_form(1, 1.5, 0.05), 0.0);
  EXPECT_DOUBLE_EQ(wigley_form(1, 0.0, 0.1875), 0.0);
}

}  // namespace
}  // namespace quickstrip::hull_tool
