#include "sim/hull_tool/hull_scale.hpp"

#include <cmath>
#include <optional>

namespace quickstrip::hull_tool {
namespace {

void multiply(std::optional<double>& value, double factor) {
  if (value) {
    *value *= factor;
  }
}

void scale_stations(Hull& hull, double scale) {
  hull.lpp *= scale;
  hull.breadth *= scale;
  for (Station& station : hull.stations) {
    station.x *= scale;
    station.breadth *= scale;
    station.draught *= scale;
    station.area *= scale * scale;
    for (Offset& offset : station.offsets) {
      offset.y *= scale;
      offset.z *= scale;
    }
  }
}

void scale_loading(Loading& loading, double scale) {
  loading.draught_aft *= scale;
  loading.draught_fwd *= scale;
  loading.kg *= scale;
  multiply(loading.free_surface_correction, scale);
  multiply(loading.gm, scale);
  loading.roll_gyradius *= scale;
  loading.pitch_gyradius *= scale;
  loading.yaw_gyradius *= scale;
  multiply(loading.measured_roll_period, std::sqrt(scale));
}

void scale_places(Hull& hull, double scale) {
  for (PointOfInterest& point : hull.points) {
    point.x *= scale;
    point.y *= scale;
    point.z *= scale;
  }
  for (SlammingStation& station : hull.slamming) {
    station.x *= scale;
    multiply(station.threshold_velocity, std::sqrt(scale));
  }
  for (FreeboardPoint& point : hull.freeboard) {
    point.x *= scale;
    point.height *= scale;
  }
  if (hull.propeller) {
    hull.propeller->x *= scale;
    hull.propeller->tip_z *= scale;
  }
  if (hull.roll_damping.bilge_keel) {
    hull.roll_damping.bilge_keel->x_aft *= scale;
    hull.roll_damping.bilge_keel->x_fwd *= scale;
    hull.roll_damping.bilge_keel->breadth *= scale;
  }
  if (hull.roll_damping.stabiliser) {
    hull.roll_damping.stabiliser->speed *= std::sqrt(scale);
  }
}

}  // namespace

void scale_by_froude(Hull& hull, double scale) {
  const double speed_scale = std::sqrt(scale);
  scale_stations(hull, scale);
  scale_loading(hull.loading, scale);
  scale_places(hull, scale);
  hull.min_steerage_speed *= speed_scale;
  hull.handling.turn_rate /= speed_scale;  // accelerations are the same at every scale
  for (CalmWaterResistance& point : hull.resistance) {
    point.speed *= speed_scale;
    point.force *= scale * scale * scale;  // of water of one density: friction of the larger ship is less
  }
  hull.grid.speed_from *= speed_scale;
  hull.grid.speed_to *= speed_scale;
  hull.grid.speed_step *= speed_scale;
}

}  // namespace quickstrip::hull_tool
