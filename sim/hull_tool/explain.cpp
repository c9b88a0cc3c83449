// core's refusals in the words of the hull file: which field, which value, what would be right.
#include <fmt/format.h>

#include <cmath>

#include "msgs/files/hull_table_file.hpp"
#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {
namespace {

// "--kg-m = 12" or "ship.hull.toml: loading.kg_m = 12".
std::string named(const FloatingHull& ship, const std::optional<double>& option, const char* option_name,
                  const char* field, double value) {
  return option ? fmt::format("{}: {} = {:g}", ship.file, option_name, value)
                : fmt::format("{}: loading.{} = {:g}", ship.file, field, value);
}

std::string unstable(const FloatingHull& ship, const LoadingOptions& options) {
  Loading loading = ship.loading;
  loading.gm = 1.0;  // any positive GM: KM does not depend on it
  const auto result = hydrostatics(ship.hull, loading, ship.sections);
  const std::string where = named(ship, options.kg, "--kg-m", "kg_m", loading.kg);
  if (!result) {
    return fmt::format("{}: {}", where, message(Error::kUnstable));
  }
  const double correction = loading.free_surface_correction.value_or(0.0);
  const double km = result->kb + result->bm;
  return fmt::format("{}: {} ({:.3f} m); less than {:.3f} m (KM {:.3f} m less free surface {:g} m) is wanted",
                     where, message(Error::kUnstable), km - loading.kg - correction, km - correction, km,
                     correction);
}

std::string overtopped(const FloatingHull& ship, const LoadingOptions& options) {
  for (const Station& station : ship.hull.stations) {
    const double waterline = waterline_height(ship.hull, ship.loading, station.x);
    if (station.is_minimal() || !(station.offsets.back().z < waterline) || station.offsets.back().y == 0.0) {
      continue;
    }
    const bool aft = station.x < 0.5 * ship.hull.lpp;
    const std::string where =
        aft ? named(ship, options.draught_aft, "--draught-aft-m", "draught_aft_m", ship.loading.draught_aft)
            : named(ship, options.draught_fwd, "--draught-fwd-m", "draught_fwd_m", ship.loading.draught_fwd);
    return fmt::format(
        "{}: the waterline at x_m = {:g} lies {:.3f} m above base, the highest offset of that station {:g} "
        "m; "
        "offsets up to the deck edge or a lesser draught are wanted",
        where, station.x, waterline, station.offsets.back().z);
  }
  return fmt::format("{}: {}", ship.file, message(Error::kDraughtAboveDeck));
}

std::string one_draught(const FloatingHull& ship, const LoadingOptions& options) {
  const Loading& design = ship.hull.loading;
  const bool fwd =
      ship.loading.draught_aft == design.draught_aft && ship.loading.draught_fwd != design.draught_fwd;
  if (options.draught_aft || options.draught_fwd) {
    const double value = fwd ? ship.loading.draught_fwd : ship.loading.draught_aft;
    return fmt::format(
        "{}: --draught-{}-m = {:g}: stations of breadth, draught and area hold at the file's {:g} m "
        "alone; offsets are wanted",
        ship.file, fwd ? "fwd" : "aft", value, fwd ? design.draught_fwd : design.draught_aft);
  }
  double deepest = 0.0;
  for (const Station& station : ship.hull.stations) {
    deepest = std::max(deepest, station.draught);
  }
  return fmt::format(
      "{}: loading.draught_aft_m = {:g}: no station is as deep (deepest: station.draught_m = {:g}); "
      "the draught at which breadth, draught and area were taken is wanted",
      ship.file, design.draught_aft, deepest);
}

std::string too_few(const FloatingHull& ship, const LoadingOptions& options) {
  return fmt::format(
      "{}: of {} stations fewer than 3 lie in the water; a greater draught is wanted",
      named(ship, options.draught_aft, "--draught-aft-m", "draught_aft_m", ship.loading.draught_aft),
      ship.hull.stations.size());
}

// Of what is watched: list_channels refuses it.
std::string place_out_of_range(const FloatingHull& ship) {
  for (const FreeboardPoint& point : ship.hull.freeboard) {
    const double waterline = waterline_height(ship.hull, ship.loading, point.x);
    if (!(point.height > waterline)) {
      return fmt::format(
          "{}: freeboard \"{}\": height_m = {:g}: a deck edge above the waterline there, {:g} m, is wanted",
          ship.file, point.name.view(), point.height, waterline);
    }
  }
  const double aft = ship.hull.stations.front().x;
  const double fore = ship.hull.stations.back().x;
  for (const SlammingStation& station : ship.hull.slamming) {
    if (!(station.x >= aft && station.x <= fore)) {
      return fmt::format("{}: slamming \"{}\": x_m = {:g}: a number from {:g} to {:g} m is wanted", ship.file,
                         station.name.view(), station.x, aft, fore);
    }
  }
  return fmt::format("{}: [loading] and [[station]] together: {}", ship.file, message(Error::kOutOfRange));
}

}  // namespace

std::string explain(Error error, const FloatingHull& ship, const LoadingOptions& options) {
  switch (error) {
    case Error::kUnstable:
      return unstable(ship, options);
    case Error::kDraughtAboveDeck:
      return overtopped(ship, options);
    case Error::kDraughtNotSupported:
      return one_draught(ship, options);
    case Error::kTooFewStations:
      return too_few(ship, options);
    case Error::kOutOfRange:
      return place_out_of_range(ship);
    case Error::kHullTableNeeded:
      return kHullTableWanted;
    default:
      return fmt::format("{}: [loading] and [[station]] together: {}", ship.file, message(error));
  }
}

}  // namespace quickstrip::hull_tool
