#include "sim/hull_tool/parametric_ships.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/parametric_form.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr ParametricForm kTanker{
    .lpp = 310.0,
    .breadth = 47.17,
    .draught = 18.90,
    .depth = 25.0,
    .sheer_aft = 0.0,
    .sheer_fore = 3.5,
    .cb = 234994.0 / (310.0 * 47.17 * 18.90),  // 0.850
    .cm = 0.995,
    .lcb = 155.0 + 6.61,
    .full_from = 0.36,
    .full_to = 0.76,
    .area_end_aft = 0.015,
    .waterline = {0.33, 0.0, 3.2, 4.8},
    .deck = {0.55, 0.10, 4.5, 6.0},
};

constexpr ParametricForm kTrawler{
    .lpp = 30.60,
    .breadth = 8.00,
    .draught = 3.35,
    .depth = 4.20,
    .sheer_aft = 0.8,
    .sheer_fore = 3.0,
    .cb = 0.56,
    .cm = 0.86,
    .lcb = 0.5 * 30.60 - 0.015 * 30.60,
    .full_from = 0.46,
    .full_to = 0.50,
    .area_end_aft = 0.03,
    .waterline = {0.45, 0.0, 3.0, 2.2},
    .deck = {0.75, 0.10, 4.0, 4.0},
};

void add_point(Hull& hull, const char* name, PointRole role, double x, double y, double z) {
  QS_CHECK(hull.points.push_back({Name(name), role, x, y, z}));
}

void set_grid(Hull& hull, double steerage_kn, double to_kn, double step_kn) {
  hull.min_steerage_speed = from_knots(steerage_kn);
  hull.grid = {0.0, from_knots(to_kn), from_knots(step_kn), radians(5.0)};
}

// Where the paper takes accelerations: 0.75 lpp forward, 0.75 of the half-breadth to port, half the draught
// above the waterline.
void add_point_of_the_paper(Hull& hull) {
  add_point(hull, "point of the paper", PointRole::kOther, 0.75 * hull.lpp, 0.375 * hull.breadth,
            1.5 * hull.loading.draught_aft);
}

void make_tanker(Hull& hull) {
  hull.name = Name("tanker, 200,000 t (our lines)");
  QS_CHECK(shape_hull(kTanker, hull).ok());
  hull.loading.kg = 13.32;
  hull.loading.free_surface_correction = 0.0;
  hull.loading.roll_gyradius = 14.77;
  hull.loading.pitch_gyradius = 77.47;
  hull.loading.yaw_gyradius = 79.30;
  hull.roll_damping.ratio = 0.075;
  add_point(hull, "bridge", PointRole::kBridge, 40.0, 0.0, 48.0);
  add_point(hull, "forward perpendicular", PointRole::kForwardPerpendicular, 310.0, 0.0, 28.5);
  add_point_of_the_paper(hull);
  QS_CHECK(hull.slamming.push_back({Name("bow"), 279.0, std::nullopt}));
  QS_CHECK(hull.freeboard.push_back({Name("bow"), 310.0, 28.5}));
  QS_CHECK(hull.freeboard.push_back({Name("main deck"), 155.0, 25.0}));
  hull.propeller = Propeller{7.0, 9.6};
  set_grid(hull, 3.0, 16.0, 1.0);
}

void make_trawler(Hull& hull) {
  hull.name = Name("trawler, 30.60 m (our lines)");
  QS_CHECK(shape_hull(kTrawler, hull).ok());
  hull.loading.kg = 2.95;
  hull.loading.free_surface_correction = 0.05;
  hull.loading.roll_gyradius = 3.04;
  hull.loading.pitch_gyradius = 7.65;
  hull.loading.yaw_gyradius = 7.65;
  hull.roll_damping.ratio = 0.050;
  add_point(hull, "wheelhouse", PointRole::kBridge, 19.0, 0.0, 9.0);
  add_point(hull, "forward perpendicular", PointRole::kForwardPerpendicular, 30.60, 0.0, 7.2);
  add_point(hull, "working deck", PointRole::kDeck, 9.0, 0.0, 5.2);
  add_point_of_the_paper(hull);
  QS_CHECK(hull.slamming.push_back({Name("bow"), 27.54, std::nullopt}));
  QS_CHECK(hull.freeboard.push_back({Name("bow"), 30.60, 7.2}));
  QS_CHECK(hull.freeboard.push_back({Name("working deck"), 15.3, 4.2}));
  hull.propeller = Propeller{1.2, 2.2};
  set_grid(hull, 2.0, 10.0, 0.5);
}

constexpr double kWigleyLength = 3.0;
constexpr double kWigleyDraught = 0.1875;
constexpr double kWigleyDeck = 0.3;
constexpr int kWigleyIntervals = 40;  // along the ship
constexpr int kWigleyPanels = 24;     // keel to waterline

double wigley_breadth(int which) {
  return which == 1 || which == 3 ? 0.3 : 0.6;
}

Station wigley_station(int which, double x) {
  const auto rounded = [](double metres) { return std::round(1.0e6 * metres) / 1.0e6; };
  Station station;
  station.x = rounded(x);
  for (int i = 0; i <= kWigleyPanels; ++i) {
    const double z = kWigleyDraught * i / kWigleyPanels;
    const double y = wigley_form(which, x - 0.5 * kWigleyLength, kWigleyDraught - z);
    QS_CHECK(station.offsets.push_back({rounded(y), rounded(z)}));
  }
  QS_CHECK(station.offsets.push_back({station.offsets.back().y, kWigleyDeck}));
  return station;
}

void make_wigley(int which, Hull& hull) {
  constexpr std::array kNames = {"Wigley hull I", "Wigley hull II", "Wigley hull III", "Wigley hull IV"};
  constexpr std::array kHeights = {0.12, 0.17, 0.13, 0.17};  // KG: GM 0.02 ... 0.12 m
  const auto index = static_cast<std::size_t>(which - 1);
  hull.name = Name(kNames[index]);
  hull.lpp = kWigleyLength;
  hull.breadth = wigley_breadth(which);
  for (int i = 0; i <= kWigleyIntervals; ++i) {
    QS_CHECK(hull.stations.push_back(wigley_station(which, kWigleyLength * i / kWigleyIntervals)));
  }
  hull.loading.draught_aft = kWigleyDraught;
  hull.loading.draught_fwd = kWigleyDraught;
  hull.loading.kg = kHeights[index];
  hull.loading.free_surface_correction = 0.0;  // a model has no tanks
  hull.loading.roll_gyradius = 0.35 * hull.breadth;
  hull.loading.pitch_gyradius = 0.25 * kWigleyLength;
  hull.loading.yaw_gyradius = 0.25 * kWigleyLength;
  hull.loading.water_density = 1000.0;
  hull.loading.viscosity = 1.14e-6;  // fresh water of 15 degrees [ITTC 7.5-02-01-03]
  add_point(hull, "bow", PointRole::kForwardPerpendicular, kWigleyLength, 0.0, kWigleyDeck);
  add_point(hull, "midship", PointRole::kOther, 0.5 * kWigleyLength, 0.0, kWigleyDeck);
  QS_CHECK(hull.slamming.push_back({Name("bow"), 0.9 * kWigleyLength, std::nullopt}));
  QS_CHECK(hull.freeboard.push_back({Name("bow"), kWigleyLength, kWigleyDeck}));
  set_grid(hull, 0.0, 4.2, 0.7);
  hull.grid.heading_step = radians(15.0);
}

}  // namespace

double wigley_form(int which, double from_midship, double depth) {
  const double x2 = std::pow(2.0 * from_midship / kWigleyLength, 2);
  const double z2 = std::pow(depth / kWigleyDraught, 2);
  const double fine = (1.0 - z2) * (1.0 - x2) * (1.0 + 0.2 * x2);
  const double full = which <= 2 ? z2 * (1.0 - std::pow(z2, 4)) * std::pow(1.0 - x2, 4) : 0.0;
  return std::max(0.0, 0.5 * wigley_breadth(which) * (fine + full));
}

std::string_view make_parametric_ship(std::string_view which, Hull& out) {
  if (which == "tanker") {
    make_tanker(out);
    return "A crude oil tanker of the size of [Journee1992] section 5: 310 m, 200,000 t deadweight, roll "
           "damping "
           "ratio\n0.075. Her lines are OURS, the paper's are not public: made by `quickstrip-hull "
           "parametric "
           "tanker`, from powers\n(sim/hull_tool/parametric_form.hpp). 310 x 47.17 x 18.90 m, 234,994 m3, "
           "LCB "
           "6.61 m forward of midship, KG 13.32 m\nand gyradii are those, from memory, of the 200,000 t "
           "tanker of Dutch model tests (van Oortmerssen 1976,\nPinkster 1980; GM 5.78 m there). Deck, "
           "bridge and "
           "freeboards are usual ones. No bulb. Free surfaces: none assumed.";
  }
  if (which == "trawler") {
    make_trawler(out);
    return "A trawler of the size of [Journee1992] section 5: 30.60 m, roll damping ratio 0.050. Her lines "
           "are OURS, "
           "the\npaper's are not public: made by `quickstrip-hull parametric trawler`, from powers\n"
           "(sim/hull_tool/parametric_form.hpp), with the proportions of trawlers of that time: L/B 3.8, B/T "
           "2.4, "
           "CB 0.56.\nKG gives a GM of about twice the 0.35 m that IMO asks of fishing vessels; gyradii 0.38 "
           "B and "
           "0.25 lpp.";
  }
  constexpr std::array<std::string_view, 4> kWigleys = {"wigley-i", "wigley-ii", "wigley-iii", "wigley-iv"};
  const auto found = std::find(kWigleys.begin(), kWigleys.end(), which);
  QS_CHECK(found != kWigleys.end());
  make_wigley(static_cast<int>(found - kWigleys.begin()) + 1, out);
  return "A Wigley hull of the Delft experiments, model scale, fresh water, made by `quickstrip-hull "
         "parametric` "
         "from its\nformula, not measured:\n  y = (B/2) [(1 - z^2)(1 - x^2)(1 + 0.2 x^2) + alpha z^2 (1 - "
         "z^8)(1 - x^2)^4],  x = 2X/L, z = depth/d,\nalpha = 1 (I, II) or 0 (III, IV); L 3 m, B 0.3 (I, III) "
         "or "
         "0.6 m (II, IV), d 0.1875 m, wall-sided above the\nwaterline. J.M.J. Journee, Experiments and "
         "Calculations on Four Wigley Hullforms, report 0909, Delft 1992:\npitch gyradius 0.25 L. Heights, "
         "roll "
         "gyradius and the speeds of the grid (Fn 0 ... 0.4) are ours.";
}

}  // namespace quickstrip::hull_tool
