#include "msgs/convert/digest.hpp"

#include <optional>

namespace quickstrip {
namespace {

void add(Fnv1a& fnv, const std::optional<double>& value) {
  fnv.add(value.has_value() ? 1.0 : 0.0);
  fnv.add(value.value_or(0.0));
}

void add(Fnv1a& fnv, const Name& name) {
  fnv.add(std::string_view(name.bytes.data(), name.bytes.size()));
}

void add(Fnv1a& fnv, const Station& station) {
  for (const double value : {station.x, station.breadth, station.draught, station.area}) {
    fnv.add(value);
  }
  fnv.add(static_cast<double>(station.offsets.size()));
  for (const Offset& offset : station.offsets) {
    fnv.add(offset.y);
    fnv.add(offset.z);
  }
}

void add(Fnv1a& fnv, const Loading& loading) {
  for (const double value :
       {loading.draught_aft, loading.draught_fwd, loading.kg, loading.roll_gyradius, loading.pitch_gyradius,
        loading.yaw_gyradius, loading.water_density, loading.viscosity, loading.gravity}) {
    fnv.add(value);
  }
  add(fnv, loading.free_surface_correction);
  add(fnv, loading.gm);
  add(fnv, loading.measured_roll_period);
}

void add(Fnv1a& fnv, const RollDamping& damping) {
  fnv.add(static_cast<double>(damping.method));
  fnv.add(damping.ratio);
  const BilgeKeel keel = damping.bilge_keel.value_or(BilgeKeel{});
  for (const double value : {keel.x_aft, keel.x_fwd, keel.breadth}) {
    fnv.add(value);
  }
}

void add_places(Fnv1a& fnv, const Hull& hull) {
  for (const PointOfInterest& point : hull.points) {
    add(fnv, point.name);
    for (const double value : {static_cast<double>(point.role), point.x, point.y, point.z}) {
      fnv.add(value);
    }
  }
  for (const SlammingStation& station : hull.slamming) {
    add(fnv, station.name);
    fnv.add(station.x);
    add(fnv, station.threshold_velocity);
  }
  for (const FreeboardPoint& point : hull.freeboard) {
    add(fnv, point.name);
    fnv.add(point.x);
    fnv.add(point.height);
  }
}

}  // namespace

std::int64_t hull_digest(const Hull& hull, const Loading& loading) {
  Fnv1a fnv;
  add(fnv, hull.name);
  fnv.add(hull.lpp);
  fnv.add(hull.breadth);
  for (const Station& station : hull.stations) {
    add(fnv, station);
  }
  add(fnv, loading);
  add(fnv, hull.roll_damping);
  add_places(fnv, hull);
  const Propeller propeller = hull.propeller.value_or(Propeller{});
  const GridDefinition& grid = hull.grid;
  for (const double value : {propeller.x, propeller.tip_z, hull.min_steerage_speed, grid.speed_from,
                             grid.speed_to, grid.speed_step, grid.heading_step}) {
    fnv.add(value);
  }
  fnv.add(hull.handling.turn_rate);
  fnv.add(hull.handling.slowing);
  fnv.add(hull.handling.speeding_up);
  for (const CalmWaterResistance& point : hull.resistance) {
    fnv.add(point.speed);
    fnv.add(point.force);
  }
  return fnv.as_int64();
}

}  // namespace quickstrip
