#include "core/hull/physical_range.hpp"

#include <cmath>

namespace quickstrip {
namespace {

constexpr double kLeastLength = 0.01;  // m
constexpr double kMostLength = 1e4;
constexpr double kMostLengths = 100.0;   // of lpp, any coordinate
constexpr double kLeastGyradius = 1e-4;  // of lpp
constexpr double kMostPeriod = 1e4;      // s
constexpr double kMostRatio = 10.0;      // of critical damping

/// NaN is in no range.
bool is_in(double value, double least, double most) {
  return value >= least && value <= most;
}

Status status_of(bool is_within, bool is_finite) {
  return is_within ? Status{} : Status{is_finite ? Error::kOutOfRange : Error::kNotFinite};
}

/// All within +-most.
struct Coordinates {
  double most;
  bool is_within = true;
  bool is_finite = true;

  void add(double value) {
    is_within = is_within && is_in(value, -most, most);
    is_finite = is_finite && std::isfinite(value);
  }
};

}  // namespace

Status check_physical_range(const Hull& hull) {
  const bool is_sized = is_in(hull.lpp, kLeastLength, kMostLength) && is_in(hull.breadth, 0.0, kMostLength);
  if (!is_sized) {
    return status_of(false, std::isfinite(hull.lpp) && std::isfinite(hull.breadth));
  }
  Coordinates all{kMostLengths * hull.lpp};
  for (const Station& station : hull.stations) {
    all.add(station.x);
    all.add(station.breadth);
    all.add(station.draught);
    all.add(station.area / hull.lpp);
    for (const Offset& offset : station.offsets) {
      all.add(offset.y);
      all.add(offset.z);
    }
  }
  for (const PointOfInterest& point : hull.points) {
    all.add(point.x);
    all.add(point.y);
    all.add(point.z);
  }
  for (const SlammingStation& station : hull.slamming) {
    all.add(station.x);
  }
  for (const FreeboardPoint& point : hull.freeboard) {
    all.add(point.x);
    all.add(point.height);
  }
  all.is_within = all.is_within && is_in(hull.roll_damping.ratio, 0.0, kMostRatio);
  all.is_finite = all.is_finite && std::isfinite(hull.roll_damping.ratio);
  return status_of(all.is_within, all.is_finite);
}

Status check_physical_range(const Loading& loading, double lpp) {
  Coordinates heights{kMostLengths * lpp};
  for (const double value : {loading.draught_aft, loading.draught_fwd, loading.kg,
                             loading.free_surface_correction.value_or(0.0), loading.gm.value_or(0.0)}) {
    heights.add(value);
  }
  bool is_within = heights.is_within;
  bool is_finite = heights.is_finite;
  for (const double gyradius : {loading.roll_gyradius, loading.pitch_gyradius, loading.yaw_gyradius}) {
    is_within = is_within && is_in(gyradius, kLeastGyradius * lpp, kMostLengths * lpp);
    is_finite = is_finite && std::isfinite(gyradius);
  }
  is_within = is_within && is_in(loading.water_density, 1.0, 1e5) && is_in(loading.gravity, 0.1, 100.0) &&
              is_in(loading.viscosity, 1e-12, 1.0) &&
              is_in(loading.measured_roll_period.value_or(1.0), 1e-3, kMostPeriod);
  is_finite = is_finite && std::isfinite(loading.water_density) && std::isfinite(loading.gravity) &&
              std::isfinite(loading.viscosity) && std::isfinite(loading.measured_roll_period.value_or(1.0));
  return status_of(is_within, is_finite);
}

}  // namespace quickstrip
