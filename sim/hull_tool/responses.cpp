// quickstrip-hull responses: statistics of every watched quantity in one sea, by speed and relative wave
// direction.
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/advice/cell_response.hpp"
#include "core/advice/nordforsk.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/spectrum_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  SpectrumOptions spectrum;
  std::vector<double> speeds_kn;
  std::vector<double> mus_deg;
};

struct QuantityName {
  const char* name;
  const char* unit;
};

QuantityName name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kSurge:
      return {"surge", "m"};
    case Quantity::kSway:
      return {"sway", "m"};
    case Quantity::kHeave:
      return {"heave", "m"};
    case Quantity::kRoll:
      return {"roll", "rad"};
    case Quantity::kPitch:
      return {"pitch", "rad"};
    case Quantity::kYaw:
      return {"yaw", "rad"};
    case Quantity::kLongitudinalAcceleration:
      return {"longitudinal_acceleration", "m/s2"};
    case Quantity::kLateralAcceleration:
      return {"lateral_acceleration", "m/s2"};
    case Quantity::kVerticalAcceleration:
      return {"vertical_acceleration", "m/s2"};
    case Quantity::kSlamming:
      return {"slamming", "m"};
    case Quantity::kDeckWetness:
      return {"deck_wetness", "m"};
  }
  return {"unknown", ""};
}

std::string place_of(const QuantityResponse& q, const Hull& hull) {
  switch (q.quantity) {
    case Quantity::kLongitudinalAcceleration:
    case Quantity::kLateralAcceleration:
    case Quantity::kVerticalAcceleration:
      return std::string(hull.points[q.place].name.view());
    case Quantity::kSlamming:
      return std::string(hull.slamming[q.place].name.view());
    case Quantity::kDeckWetness:
      return std::string(hull.freeboard[q.place].name.view());
    default:
      return "G";
  }
}

std::optional<double> if_computed(double value) {
  return value < 0.0 ? std::nullopt : std::optional<double>(value);
}

// All that one speed needs; some MB, on the heap.
struct Solved {
  TransferWorkspace work;
  TransferFunctions transfer;
  Watch watch;
  SeaEnergy sea;
  CellResponse cell;
};

void refuse(const std::string& file, Status status) {
  if (!status) {
    throw InputError{file + ": " + message(status.error())};
  }
}

void add_rows(const Options& options, const StripShip& ship, double speed_kn, Solved& s, Csv& csv) {
  const Hull& hull = ship.floating->hull;
  const Result<Criteria> criteria = nordforsk_merchant(hull);
  if (!criteria) {
    throw InputError{ship.floating->file + ": " + message(criteria.error())};
  }
  const double speed = from_knots(speed_kn);
  refuse(ship.floating->file,
         solve_transfer_functions(*ship.loaded, std::span(&speed, 1), s.work, s.transfer));
  const CriteriaChannels channels = bind_criteria(*criteria, s.watch);
  GridInputs inputs{s.transfer, s.watch, *criteria, channels, s.sea};
  inputs.lpp = hull.lpp;
  inputs.quality = ship.quality;
  inputs.suppresses_low_encounter = ship.loaded->method.low_encounter == LowEncounterRule::kPaper;
  for (const double mu_deg : options.mus_deg) {
    // The ship heads north: mu = heading - from + 180 degrees.
    const WaveFrom from{wrap_two_pi(kPi - radians(mu_deg))};
    const std::span<const double> omega(s.transfer.omega.data(), s.transfer.num_frequencies);
    refuse("--hs-m, --t1-s", place_on_grid(options.spectrum.sea_from(from), omega, s.sea));
    refuse(ship.floating->file, respond(inputs, Heading{0.0}, speed, s.cell));
    for (const QuantityResponse& q : s.cell.quantities) {
      const QuantityName name = name_of(q.quantity);
      csv.add(speed_kn).add(mu_deg).add(name.name).add(place_of(q, hull)).add(name.unit);
      csv.add(q.rms).add(q.significant).add(q.t1).add(q.t2);
      csv.add(if_computed(q.probability)).add(if_computed(q.per_hour));
      csv.add(quality_text(s.cell.cell.quality));
      csv.end_row();
    }
  }
}

void run(const Options& options) {
  const StripShip ship = load_strip_ship(options.strip);
  const auto solved = std::make_unique<Solved>();
  refuse(ship.floating->file,
         list_channels(ship.floating->hull, ship.floating->loading, ship.floating->hydrostatics,
                       ship.loaded->method.swell_up, solved->watch));
  Csv csv("speed_kn,mu_deg,quantity,where,unit,rms,significant,t1_s,t2_s,probability,per_hour,quality");
  for (const double speed_kn : options.speeds_kn) {
    add_rows(options, ship, speed_kn, *solved, csv);
  }
  print_result(csv.text());
}

}  // namespace

void add_responses(CLI::App& app) {
  CLI::App* command = app.add_subcommand("responses", "Statistics of every watched quantity in one sea");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_spectrum_options(*command, options->spectrum, true);
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--mu-deg", options->mus_deg, kDirections_deg,
           "mean wave directions: 0 following, 90 from starboard, 180 head [deg]")
      ->required();
  command->footer(
      "rms and significant (single amplitude) of slamming and deck_wetness are those of the vertical "
      "relative "
      "motion; probability is per wave encounter.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --mu-deg", {options->speeds_kn.size(), options->mus_deg.size(), 70});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
