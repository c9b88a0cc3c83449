// A ship of minimal sections in a crossing sea on 36 headings and 8 speeds: RMS of roll, of the vertical
// acceleration at the bridge, probability of slamming, verdict. Built with either profile of capacities.
#include <cmath>
#include <cstdio>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"

namespace {

using namespace quickstrip;

// 175 m, breadth and draught those of the S-175; parabolic waterline, full amidships.
void fill(Hull& hull) {
  hull.lpp = 175.0;
  hull.breadth = 25.4;
  constexpr int kStations = 21;
  for (int i = 0; i < kStations; ++i) {
    const double x = static_cast<double>(i) / (kStations - 1);
    const double from_midship = 2.0 * x - 1.0;
    const double fullness = 1.0 - 0.9 * std::pow(std::fabs(from_midship), 3);
    Station station;
    station.x = x * hull.lpp;
    station.breadth = hull.breadth * fullness;
    station.draught = 9.5;
    station.area = station.breadth * station.draught * (0.95 - 0.25 * from_midship * from_midship);
    static_cast<void>(hull.stations.push_back(station));
  }
  hull.loading.draught_aft = 9.5;
  hull.loading.draught_fwd = 9.5;
  hull.loading.kg = 9.5;
  hull.loading.gm = 1.0;
  hull.loading.roll_gyradius = 8.9;
  hull.loading.pitch_gyradius = 42.0;
  hull.loading.yaw_gyradius = 42.0;
  static_cast<void>(hull.points.push_back({Name("bridge"), PointRole::kBridge, 30.0, 2.0, 35.0}));
  static_cast<void>(hull.points.push_back({Name("fp"), PointRole::kForwardPerpendicular, 175.0, 0.0, 16.0}));
  static_cast<void>(hull.slamming.push_back({Name("bow"), 157.5, std::nullopt}));
  static_cast<void>(hull.freeboard.push_back({Name("bow"), 175.0, 16.0}));
  constexpr double kKnot = 1852.0 / 3600.0;
  hull.grid = {
      .speed_from = 0.0, .speed_to = 21.0 * kKnot, .speed_step = 3.0 * kKnot, .heading_step = kPi / 18.0};
}

}  // namespace

int main() {
  static Hull hull;
  static Advisor advisor;
  fill(hull);
  const auto criteria = nordforsk_merchant(hull);
  if (!criteria || !advisor.configure(hull, *criteria, StripMethod{})) {
    std::fputs("the ship is refused\n", stderr);
    return 1;
  }
  SeaState sea;
  static_cast<void>(sea.systems.push_back({4.0, 10.0, PeriodKind::kPeak, WaveFrom{radians(30.0)},
                                           radians(25.0), SpectrumShape::kBretschneider, 1.0}));
  static_cast<void>(sea.systems.push_back(
      {2.0, 14.0, PeriodKind::kPeak, WaveFrom{radians(120.0)}, radians(20.0), SpectrumShape::kJonswap, 3.3}));
  const OwnShip ship{Heading{0.0}, 5.0, false};
  StepInputs inputs;
  inputs.sea_state = &sea;
  inputs.own_ship = &ship;
  const Grid& grid = advisor.step(inputs).grid;
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < grid.num_headings; ++h) {
      const Cell& cell = grid.cells[v][h];
      std::printf("%zu %zu %d %.9g %.9g %.9g\n", v, h, static_cast<int>(cell.verdict),
                  static_cast<double>(cell.rms_roll), static_cast<double>(cell.rms_bridge_vertical),
                  static_cast<double>(cell.slam_probability));
    }
  }
  return 0;
}
