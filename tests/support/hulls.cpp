#include "tests/support/hulls.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "msgs/files/hull_file.hpp"

namespace quickstrip::test {
namespace {

constexpr double kWigleyLength = 3.0;
constexpr double kWigleyDraught = 0.1875;
constexpr double kWigleyDeck = 0.3;

double wigley_breadth(int which) {
  return which == 1 || which == 3 ? 0.3 : 0.6;
}

// What every hull needs beside its stations; speeds up to Fn 0.3.
void fill_common(Hull& hull, double deck) {
  hull.loading.roll_gyradius = 0.35 * hull.breadth;
  hull.loading.pitch_gyradius = 0.25 * hull.lpp;
  hull.loading.yaw_gyradius = 0.25 * hull.lpp;
  hull.loading.free_surface_correction = 0.0;
  PointOfInterest bow;
  bow.name = Name("bow");
  bow.role = PointRole::kForwardPerpendicular;
  bow.x = hull.lpp;
  bow.z = deck;
  QS_CHECK(hull.points.push_back(bow));
  QS_CHECK(hull.slamming.push_back({Name("bow"), 0.9 * hull.lpp, std::nullopt}));
  QS_CHECK(hull.freeboard.push_back({Name("bow"), hull.lpp, deck}));
  const double speed = 0.3 * std::sqrt(kStandardGravity * hull.lpp);
  hull.grid = {0.0, speed, speed / 6.0, kPi / 12.0};
}

Station wigley_station(int which, double x, std::size_t points) {
  Station station;
  station.x = x;
  for (std::size_t i = 0; i < points; ++i) {
    const double z = kWigleyDraught * static_cast<double>(i) / static_cast<double>(points - 1);
    const double y = wigley_half_breadth(which, x - 0.5 * kWigleyLength, kWigleyDraught - z);
    QS_CHECK(station.offsets.push_back({y, z}));
  }
  QS_CHECK(station.offsets.push_back({station.offsets.back().y, kWigleyDeck}));
  return station;
}

}  // namespace

Hull box_barge(double length, double breadth, double draught, double depth, std::size_t stations) {
  Hull hull;
  hull.name = Name("box barge");
  hull.lpp = length;
  hull.breadth = breadth;
  hull.loading.draught_aft = draught;
  hull.loading.draught_fwd = draught;
  hull.loading.kg = draught;
  fill_common(hull, depth);
  for (std::size_t i = 0; i < stations; ++i) {
    Station station;
    station.x = length * static_cast<double>(i) / static_cast<double>(stations - 1);
    QS_CHECK(station.offsets.push_back({0.0, 0.0}));
    QS_CHECK(station.offsets.push_back({0.5 * breadth, 0.0}));
    QS_CHECK(station.offsets.push_back({0.5 * breadth, depth}));
    QS_CHECK(hull.stations.push_back(station));
  }
  return hull;
}

double wigley_half_breadth(int which, double from_midship, double depth) {
  const double x2 = std::pow(2.0 * from_midship / kWigleyLength, 2);
  const double z2 = std::pow(depth / kWigleyDraught, 2);
  const double alpha = which <= 2 ? 1.0 : 0.0;
  const double fine = (1.0 - z2) * (1.0 - x2) * (1.0 + 0.2 * x2);
  const double full = z2 * (1.0 - std::pow(z2, 4)) * std::pow(1.0 - x2, 4);
  return std::max(0.0, 0.5 * wigley_breadth(which) * (fine + alpha * full));
}

Hull wigley_hull(int which, std::size_t stations, std::size_t points) {
  Hull hull;
  hull.name = Name("Wigley");
  hull.lpp = kWigleyLength;
  hull.breadth = wigley_breadth(which);
  hull.loading.draught_aft = kWigleyDraught;
  hull.loading.draught_fwd = kWigleyDraught;
  hull.loading.kg = which == 1 ? 0.12 : which == 3 ? 0.13 : 0.17;  // GM 0.02 ... 0.12 m
  hull.loading.water_density = 1000.0;
  hull.loading.viscosity = 1.14e-6;  // fresh water of 15 degrees [ITTC 7.5-02-01-03]
  fill_common(hull, kWigleyDeck);
  for (std::size_t i = 0; i < stations; ++i) {
    const double x = kWigleyLength * static_cast<double>(i) / static_cast<double>(stations - 1);
    QS_CHECK(hull.stations.push_back(wigley_station(which, x, points)));
  }
  return hull;
}

Hull s175() {
  Hull hull;
  const FileStatus status =
      read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml", hull);
  QS_CHECK(status.ok());
  hull.roll_damping.method = RollDampingMethod::kRatio;
  hull.roll_damping.ratio = 0.05;
  return hull;
}

}  // namespace quickstrip::test
