// quickstrip-hull hydrostatics: displacement, centres and stability of the loaded hull, one row or one
// object.
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/floating_hull.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string file;
  LoadingOptions loading;
  std::string format = "csv";
};

using Row = std::array<std::pair<const char*, std::optional<double>>, 11>;

// The roll period is that of undamped roll with strip theory's a44 at that frequency.
Row row_of(const LoadedHull& hull) {
  const Hydrostatics& h = hull.hydrostatics;
  return {{{"displacement_t", h.displacement / 1000.0},
           {"lcb_m", h.lcb},
           {"kb_m", h.kb},
           {"gm_m", h.gm},
           {"gml_m", h.gml},
           {"lcf_m", h.lcf},
           {"waterplane_area_m2", h.waterplane_area},
           {"cb", h.cb},
           {"cm", h.cm},
           {"cwp", h.cwp},
           {"roll_period_s", kTwoPi / hull.roll_natural_frequency}}};
}

std::string as_csv(const Row& row) {
  std::string header;
  for (const auto& [key, value] : row) {
    header += (header.empty() ? "" : ",") + std::string(key);
  }
  Csv csv(header);
  for (const auto& [key, value] : row) {
    csv.add(value);
  }
  csv.end_row();
  return csv.text();
}

std::string as_json(const Row& row) {
  nlohmann::ordered_json json;
  for (const auto& [key, value] : row) {
    json[key] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  }
  return json.dump(2) + "\n";
}

void run(const Options& options) {
  const StripShip ship = load_strip_ship({options.file, options.loading, {}, std::nullopt});
  const Row row = row_of(*ship.loaded);
  print_result(options.format == "json" ? as_json(row) : as_csv(row));
}

}  // namespace

void add_hydrostatics(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("hydrostatics", "Displacement, centres, stability, form coefficients");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  add_loading_options(*command, options->loading);
  command->add_option("--format", options->format, "csv or json; default csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command->footer(
      "gml_m is taken about the centre of buoyancy: c55 about G = rho g volume gml. A quantity that is not "
      "known is an empty field (null).");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
