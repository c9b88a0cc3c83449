#include <cmath>

#include "tests/support/hulls.hpp"

namespace quickstrip::test {
namespace {

void scale_stations(Hull& hull, double scale) {
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
  loading.roll_gyradius *= scale;
  loading.pitch_gyradius *= scale;
  loading.yaw_gyradius *= scale;
  loading.viscosity *= std::pow(scale, 1.5);
  if (loading.free_surface_correction) {
    *loading.free_surface_correction *= scale;
  }
  if (loading.gm) {
    *loading.gm *= scale;
  }
  if (loading.measured_roll_period) {
    *loading.measured_roll_period *= std::sqrt(scale);
  }
}

void scale_places(Hull& hull, double scale) {
  for (PointOfInterest& point : hull.points) {
    point.x *= scale;
    point.y *= scale;
    point.z *= scale;
  }
  for (SlammingStation& station : hull.slamming) {
    station.x *= scale;
    if (station.threshold_velocity) {
      *station.threshold_velocity *= std::sqrt(scale);
    }
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
}

}  // namespace

Hull scaled(const Hull& hull, double scale) {
  Hull out = hull;
  const double speed_scale = std::sqrt(scale);
  out.lpp *= scale;
  out.breadth *= scale;
  scale_stations(out, scale);
  scale_loading(out.loading, scale);
  scale_places(out, scale);
  out.min_steerage_speed *= speed_scale;
  out.grid.speed_from *= speed_scale;
  out.grid.speed_to *= speed_scale;
  out.grid.speed_step *= speed_scale;
  return out;
}

}  // namespace quickstrip::test
