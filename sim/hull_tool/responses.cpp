// quickstrip-hull responses: statistics of every watched quantity, of the local motions of every point and of
// the relative motions in one sea, by speed and relative wave direction.
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/advice/cell_response.hpp"
#include "core/advice/people_channels.hpp"
#include "core/response/local_watch.hpp"
#include "core/response/moments.hpp"
#include "core/response/short_term.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/limits_option.hpp"
#include "sim/hull_tool/local_options.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/quantity_name.hpp"
#include "sim/hull_tool/spectrum_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  std::string limits;
  SpectrumOptions spectrum;
  std::vector<double> speeds_kn;
  std::vector<double> mus_deg;
  LocalOptions local;
  double hours = 1.0;
};

constexpr const char* kHeader =
    "speed_kn,mu_deg,quantity,where,unit,rms,significant,t1_s,t2_s,probability,per_hour,quality,t4_s,"
    "bandwidth,"
    "most_probable_max,level,exceedance,exceedances_per_hour,mean";

/// Of the largest watches: a point has up to nine channels.
constexpr std::size_t kPointsAWatch = 4;
static_assert(1 + 9 * kPointsAWatch <= kMaxChannels && 1 + 2 * kMaxRelativeChannels <= kMaxChannels);

std::optional<double> if_computed(double value) {
  return value < 0.0 ? std::nullopt : std::optional<double>(value);
}

/// Channels that are not watched on board, and the name of the place of each.
struct LocalWatch {
  Watch watch;
  std::vector<std::string> where;
};

// All that one speed needs; some MB, on the heap.
struct Solved {
  LimitsProfile limits;
  TransferWorkspace work;
  TransferFunctions transfer;
  Watch watch;
  IncidentWaves waves;
  std::vector<LocalWatch> local;
  SeaEnergy sea;
  CellResponse cell;
};

void refuse(const std::string& file, Status status) {
  if (!status) {
    throw InputError{file + ": " + message(status.error())};
  }
}

/// Where a row belongs.
struct Circumstance {
  double speed_kn = 0.0;
  double mu_deg = 0.0;
  std::uint32_t quality = 0;
};

/// What is said of the cell for the sake of other rows.
std::uint32_t of_others(Quantity quantity) {
  const bool is_relative =
      is_event(quantity) || quantity == Quantity::kRelativeMotion || quantity == Quantity::kRelativeVelocity;
  return kQualityWideBand | (is_relative ? 0u : kQualitySwellUpRange);
}

void add_row(const Options& options, const Circumstance& at, const QuantityResponse& q,
             const std::string& where, Csv& csv) {
  const QuantityName name = name_of(q.quantity);
  const double m0 = q.rms * q.rms;
  const double m2 = q.t2 > 0.0 ? m0 * (kTwoPi / q.t2) * (kTwoPi / q.t2) : 0.0;
  const bool is_wide = q.bandwidth > kWideBandwidth;
  csv.add(at.speed_kn).add(at.mu_deg).add(name.name).add(where).add(name.unit);
  csv.add(q.rms).add(q.significant).add(q.t1).add(q.t2);
  csv.add(if_computed(q.probability)).add(if_computed(q.per_hour));
  csv.add(quality_text((at.quality & ~of_others(q.quantity)) | (is_wide ? kQualityWideBand : 0u)));
  csv.add(if_computed(q.t4)).add(if_computed(q.bandwidth));
  csv.add(most_probable_maximum(m0, m2, 3600.0 * options.hours));
  const std::optional<double> level = options.local.level_of(q.quantity);
  const double exceedance = level ? rayleigh_exceedance(*level, m0) : 0.0;
  csv.add(level);
  csv.add(level ? std::optional<double>(exceedance) : std::nullopt);
  csv.add(level ? std::optional<double>(exceedance * oscillations_per_hour(m0, m2)) : std::nullopt);
  csv.add(std::optional<double>());  // motions swing about zero
  csv.end_row();
}

/// A mean force: no amplitude, no period.
void add_resistance_row(const Circumstance& at, const char* name, float mean, Csv& csv) {
  constexpr int kBeforeQuality = 6;
  constexpr int kAfterQuality = 6;
  csv.add(at.speed_kn).add(at.mu_deg).add(name).add("G").add("N");
  for (int i = 0; i < kBeforeQuality; ++i) {
    csv.add(std::optional<double>());
  }
  csv.add(quality_text(at.quality & ~(kQualityWideBand | kQualitySwellUpRange)));
  for (int i = 0; i < kAfterQuality; ++i) {
    csv.add(std::optional<double>());
  }
  csv.add(mean > kNoResistance ? std::optional<double>(mean) : std::nullopt);
  csv.end_row();
}

void add_local_rows(const Options& options, const Circumstance& at, double speed, const Solved& s, Csv& csv) {
  std::vector<ResponseMoments> moments;
  for (const LocalWatch& local : s.local) {
    moments.resize(local.watch.channels.size());
    const Result<RollDampingInUse> found =
        response_moments(s.transfer, local.watch, s.sea, Heading{0.0}, speed, moments);
    refuse("--point", found ? Status() : Status(found.error()));
    for (std::size_t c = 1; c < moments.size(); ++c) {  // after roll
      add_row(options, at, quantity_response(local.watch.channels[c], speed, moments[c]), local.where[c],
              csv);
    }
  }
}

void add_rows(const Options& options, const StripShip& ship, double speed_kn, Solved& s, Csv& csv) {
  const Hull& hull = ship.floating->hull;
  const Criteria& criteria = s.limits.criteria;
  const double speed = from_knots(speed_kn);
  refuse(ship.floating->file,
         solve_transfer_functions(*ship.loaded, std::span(&speed, 1), s.work, s.transfer));
  const CriteriaChannels channels = bind_criteria(criteria, s.watch);
  list_incident_waves(s.transfer, s.watch, s.waves);
  GridInputs inputs{s.transfer, s.watch, s.waves, criteria, channels, s.sea};
  inputs.lpp = hull.lpp;
  inputs.quality = ship.quality;
  inputs.wants_all_bandwidths = true;
  for (const double mu_deg : options.mus_deg) {
    // The ship heads north: mu = heading - from + 180 degrees.
    const WaveFrom from{wrap_two_pi(kPi - radians(mu_deg))};
    const std::span<const double> omega(s.transfer.omega.data(), s.transfer.num_frequencies);
    refuse("--hs-m, --t1-s", place_on_grid(options.spectrum.sea_from(from), omega, s.sea));
    refuse(ship.floating->file, respond(inputs, Heading{0.0}, speed, s.cell));
    const Circumstance at{speed_kn, mu_deg, s.cell.cell.quality};
    for (const QuantityResponse& q : s.cell.quantities) {
      const char* const side = q.quantity != Quantity::kMotionInterruptions ? ""
                               : q.to_starboard                             ? " to starboard"
                                                                            : " to port";
      add_row(options, at, q, place_of(q.quantity, q.place, hull) + side, csv);
    }
    add_resistance_row(at, "added_resistance", s.cell.cell.added_resistance, csv);
    add_resistance_row(at, "added_resistance_empirical", s.cell.cell.added_resistance_empirical, csv);
    add_local_rows(options, at, speed, s, csv);
  }
}

LocalWatch& new_local_watch(Solved& s) {
  LocalWatch& local = s.local.emplace_back();
  refuse("roll", begin_local_watch(s.watch, local.watch));
  local.where.emplace_back("G");
  return local;
}

void list_points(const Options& options, const StripShip& ship, Solved& s) {
  const Hydrostatics& hydrostatics = ship.floating->hydrostatics;
  const auto add = [&](const std::string& name, double x, double y, double z, bool with_accelerations) {
    const bool has_room = !s.local.empty() && s.local.back().watch.channels.size() <= 9 * (kPointsAWatch - 1);
    LocalWatch& local = has_room ? s.local.back() : new_local_watch(s);
    const Position position{x - hydrostatics.lcb, y, z - hydrostatics.kg};
    refuse("--point", add_local_motions(position, 0, with_accelerations, s.watch.gravity, local.watch));
    local.where.resize(local.watch.channels.size(), name);
  };
  for (const PointOfInterest& point : ship.floating->hull.points) {
    add(std::string(point.name.view()), point.x, point.y, point.z, false);
  }
  for (const GivenPoint& point : options.local.points) {
    add(point.name, point.x, point.y, point.z, true);
  }
}

void list_relative_motions(const StripShip& ship, Solved& s) {
  LocalWatch& local = new_local_watch(s);
  for (const Channel& channel : s.watch.channels) {
    if (is_event(channel.quantity)) {
      refuse(ship.floating->file, add_relative_motion(channel, channel.place, s.watch.gravity, local.watch));
      const std::string event = name_of(channel.quantity).name;
      const std::string place = place_of(channel.quantity, channel.place, ship.floating->hull);
      local.where.resize(local.watch.channels.size(),
                         channel.quantity == Quantity::kPropellerEmergence ? place : event + " at " + place);
    }
  }
}

void run(const Options& options) {
  const StripShip ship = load_strip_ship(options.strip);
  check_points(options.local, ship.floating->hull);
  const auto solved = std::make_unique<Solved>();
  const FloatingHull& floating = *ship.floating;
  if (const Status listed = list_channels(floating.hull, floating.loading, floating.hydrostatics,
                                          ship.loaded->method.swell_up, solved->watch);
      !listed) {
    throw InputError{explain(listed.error(), floating, options.strip.loading)};
  }
  solved->limits = limits_of(options.limits, floating);
  refuse(options.limits, list_people_channels(solved->limits.criteria, solved->watch));
  list_points(options, ship, *solved);
  list_relative_motions(ship, *solved);
  Csv csv(kHeader);
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
  add_limits_option(*command, options->limits);
  add_spectrum_options(*command, options->spectrum, true);
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--mu-deg", options->mus_deg, kDirections_deg,
           "mean wave directions: 0 following, 90 from starboard, 180 head [deg]")
      ->required();
  add_local_options(*command, options->local);
  add_number(*command, "--hours", options->hours, {0.01, 100'000.0},
             "duration of which most_probable_max is the largest amplitude [h]; default 1");
  command->footer(
      "rms and significant (single amplitude) of slamming, deck_wetness and propeller_emergence are those of "
      "the vertical relative motion; probability is per wave encounter, exceedance per oscillation. "
      "motion_sickness and motion_interruptions are there where --limits asks for them: those of the "
      "vertical "
      "acceleration, with the share of people in two hours, and of what tips, by side. "
      "bandwidth: "
      "epsilon, 0 narrow ... 1 wide; quality says wide_band where the maxima are no longer Rayleigh's; of "
      "relative motions it rests on the highest wave frequency. mean: of added_resistance, + aft; empty "
      "outside "
      "the range of the semi-empirical method.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --mu-deg", {options->speeds_kn.size(), options->mus_deg.size(), 400});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
