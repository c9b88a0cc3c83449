#include "sim/hull_tool/check_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/hull/imo_roll_period.hpp"

namespace quickstrip::hull_tool {
namespace {

using Remarks = std::vector<std::string>;

// Bounds of what is usual; outside them a misprint is likelier than such a ship. Gyradii: ITTC 7.5-02-07-02.1
// names 0.25 lpp and 0.35 to 0.40 B as ordinary.
constexpr double kLeastLengthToBreadth = 3.0;  // [Journee1992]: strip theory is for slender ships
constexpr double kBreadthMismatch = 0.01;
constexpr double kWidestGap = 1.0 / 8.0;     // of lpp: 9 stations
constexpr double kMissingEnd = 0.02;         // of lpp
constexpr double kTrim = 0.02;               // of lpp: sections are cut vertically to the base line
constexpr double kShortestShip = 24.0;       // m: the IS Code's formula is for ships
constexpr double kRollPeriodMismatch = 0.2;  // of the IS Code's estimate

void remark_form(const FloatingHull& ship, Remarks& remarks) {
  const Hull& hull = ship.hull;
  const double ratio = hull.lpp / hull.breadth;
  if (ratio < kLeastLengthToBreadth) {
    remarks.push_back(fmt::format("L/B = {:.2f} is below 3: strip theory is for slender hulls", ratio));
  }
  double breadth = 0.0;
  double gap = 0.0;
  double gap_x = 0.0;
  for (std::size_t i = 0; i < ship.sections.size(); ++i) {
    breadth = std::max(breadth, ship.sections[i].breadth);
    if (i > 0 && ship.sections[i].x - ship.sections[i - 1].x > gap) {
      gap_x = ship.sections[i - 1].x;
      gap = ship.sections[i].x - gap_x;
    }
  }
  if (std::abs(breadth - hull.breadth) > kBreadthMismatch * hull.breadth) {
    remarks.push_back(
        fmt::format("particulars.breadth_m = {:g}, but the greatest breadth at the waterline is {:.3f} m",
                    hull.breadth, breadth));
  }
  if (gap > kWidestGap * hull.lpp * (1.0 + 1e-9)) {
    remarks.push_back(
        fmt::format("stations are {:g} m apart at x_m = {:g}: more than lpp/8 is coarse", gap, gap_x));
  }
  const double aft = hull.stations.front().x;
  const double fore = hull.stations.back().x;
  if (aft > kMissingEnd * hull.lpp || fore < (1.0 - kMissingEnd) * hull.lpp) {
    remarks.push_back(fmt::format("stations span x_m = {:g} ... {:g} of lpp_m = {:g}: the hull ends there",
                                  aft, fore, hull.lpp));
  }
}

void remark_gyradius(const char* field, double value, double unit, const char* unit_name, double from,
                     double to, Remarks& remarks) {
  if (value < from * unit || value > to * unit) {
    remarks.push_back(fmt::format("loading.{} = {:g} is {:.2f} {}; {:.2f} ... {:.2f} is usual", field, value,
                                  value / unit, unit_name, from, to));
  }
}

void remark_stability(const FloatingHull& ship, Remarks& remarks) {
  const Loading& loading = ship.loading;
  if (loading.gm) {
    remarks.push_back(fmt::format(
        "loading.gm_m = {:g} replaces kg_m and the free surface in the stiffness (kg_m alone gives {:.3f} m)",
        *loading.gm, ship.hydrostatics.kb + ship.hydrostatics.bm - loading.kg));
  } else if (!loading.free_surface_correction) {
    remarks.push_back(
        "loading.free_surface_correction_m is absent: GM is the solid one, the true one is smaller; every "
        "output will say so");
  }
  const bool guessed = std::any_of(ship.hull.stations.begin(), ship.hull.stations.end(),
                                   [](const Station& station) { return station.is_minimal(); });
  if (guessed && !loading.gm) {
    remarks.push_back(
        "KB, and so GM, is estimated where a station has no offsets (S-175: 0.06 m too high); give "
        "loading.gm_m where it is known");
  }
  const Hydrostatics& h = ship.hydrostatics;
  const auto estimate = imo_roll_period(ship.hull.lpp, ship.hull.breadth,
                                        0.5 * (loading.draught_aft + loading.draught_fwd), h.gm);
  if (loading.measured_roll_period && estimate && ship.hull.lpp >= kShortestShip &&
      std::abs(*loading.measured_roll_period - *estimate) > kRollPeriodMismatch * *estimate) {
    remarks.push_back(
        fmt::format("loading.measured_roll_period_s = {:g} is far from the IS Code's estimate, {:.1f} s",
                    *loading.measured_roll_period, *estimate));
  }
}

void remark_loading(const FloatingHull& ship, Remarks& remarks) {
  const Loading& loading = ship.loading;
  remark_stability(ship, remarks);
  remark_gyradius("roll_gyradius_m", loading.roll_gyradius, ship.hull.breadth, "B", 0.30, 0.45, remarks);
  remark_gyradius("pitch_gyradius_m", loading.pitch_gyradius, ship.hull.lpp, "lpp", 0.22, 0.28, remarks);
  remark_gyradius("yaw_gyradius_m", loading.yaw_gyradius, ship.hull.lpp, "lpp", 0.22, 0.28, remarks);
  const double trim = loading.draught_aft - loading.draught_fwd;
  if (std::abs(trim) > kTrim * ship.hull.lpp) {
    remarks.push_back(fmt::format(
        "a trim of {:.2f} m is more than 2 % of lpp: sections stay vertical to the base line", trim));
  }
}

void remark_places(const FloatingHull& ship, Remarks& remarks) {
  const auto& sections = ship.sections;
  for (const SlammingStation& station : ship.hull.slamming) {
    if (station.x < sections.front().x || station.x > sections.back().x) {
      remarks.push_back(fmt::format("slamming station \"{}\" at x_m = {:g} lies beyond the immersed hull",
                                    station.name.view(), station.x));
    }
  }
  for (const FreeboardPoint& point : ship.hull.freeboard) {
    const double waterline = waterline_height(ship.hull, ship.loading, point.x);
    if (!(point.height > waterline)) {
      remarks.push_back(
          fmt::format("freeboard \"{}\": height_m = {:g} is not above the waterline there, {:.3f} m",
                      point.name.view(), point.height, waterline));
    }
  }
  if (ship.hull.propeller) {
    const double waterline = waterline_height(ship.hull, ship.loading, ship.hull.propeller->x);
    if (!(ship.hull.propeller->tip_z < waterline)) {
      remarks.push_back(fmt::format("propeller.tip_z_m = {:g} is not below the waterline there, {:.3f} m",
                                    ship.hull.propeller->tip_z, waterline));
    }
  }
}

bool has_role(const Hull& hull, PointRole role) {
  return std::any_of(hull.points.begin(), hull.points.end(),
                     [role](const PointOfInterest& point) { return point.role == role; });
}

}  // namespace

std::vector<std::string> warnings_of(const FloatingHull& ship) {
  Remarks remarks;
  remark_form(ship, remarks);
  remark_loading(ship, remarks);
  remark_places(ship, remarks);
  return remarks;
}

std::vector<std::string> unwatched_of(const FloatingHull& ship) {
  const Hull& hull = ship.hull;
  Remarks remarks;
  if (!has_role(hull, PointRole::kBridge)) {
    remarks.emplace_back("accelerations on the bridge: no [[point]] of role \"bridge\"");
  }
  if (!has_role(hull, PointRole::kForwardPerpendicular)) {
    remarks.emplace_back("accelerations at the forward perpendicular: no [[point]] of role \"fp\"");
  }
  if (!has_role(hull, PointRole::kDeck)) {
    remarks.emplace_back("cargo and work on deck: no [[point]] of role \"deck\"");
  }
  if (!has_role(hull, PointRole::kPassengers)) {
    remarks.emplace_back("motion sickness: no [[point]] of role \"passengers\"");
  }
  if (hull.slamming.empty()) {
    remarks.emplace_back("slamming: no [[slamming]]");
  }
  if (hull.freeboard.empty()) {
    remarks.emplace_back("shipping of water: no [[freeboard]]");
  }
  if (!hull.propeller) {
    remarks.emplace_back("propeller emergence: no [propeller]");
  }
  return remarks;
}

}  // namespace quickstrip::hull_tool
