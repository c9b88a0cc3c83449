// quickstrip-hull zones: the IMO zones of each wave system at given courses and speeds, with what they follow
// from: the roll period and which end of its band decides, the encounter periods, GM in the effective wave
// and the damping of small roll.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/hazard/zones.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/hazard_text.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/sea_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr const char* kHeader =
    "heading_deg,speed_kn,system,hs_m,tp_s,from_deg,mu_deg,te_shortest_s,te_longest_s,roll_period_end,"
    "gm_variation,gm_least_m,roll_damping_ratio,zones";

struct Options {
  StripOptions strip;
  SeaOptions sea;
  std::vector<double> headings_deg;
  std::vector<double> speeds_kn;
};

/// Large, so on the heap.
struct Scratch {
  TransferFunctions transfer;
  SeaEnergy sea;
  ZoneShip ship;
  Zones zones;
};

const char* word(RollPeriodEnd end) {
  switch (end) {
    case RollPeriodEnd::kNone:
      return "";
    case RollPeriodEnd::kShortest:
      return "shortest";
    case RollPeriodEnd::kLongest:
      return "longest";
    case RollPeriodEnd::kEither:
      return "either";
  }
  return "";
}

void say_ship(const ZoneShip& ship) {
  const RollPeriodBand& roll = ship.roll;
  const bool is_measured = roll.source == RollPeriodSource::kMeasured;
  fmt::print(stderr, "roll period {:.2f} to {:.2f} s ({}); IS Code {:.2f} s{}\n", roll.shortest, roll.longest,
             is_measured ? "measured" : "computed, 10 % either way", roll.is_code,
             contradicts_is_code(roll) ? ": they contradict each other" : "");
  if (!ship.gm_in_waves.is_known) {
    fmt::print(stderr, "GM in waves is not known: the hull file gives no offsets, or she does not settle\n");
    return;
  }
  fmt::print(stderr, "GM {:.3f} m in still water; on waves of her length, least / mean / greatest:\n",
             ship.gm);
  for (std::size_t n = 1; n < GmInWaves::kNumHeights; ++n) {
    const double height = static_cast<double>(n) * GmInWaves::kStep * ship.lpp;
    const GmChange& change = ship.gm_in_waves.by_height[n];
    fmt::print(stderr, "  {:5.2f} m  {:.3f} / {:.3f} / {:.3f} m{}\n", height,
               ship.gm + static_cast<double>(change.least), ship.gm + static_cast<double>(change.mean),
               ship.gm + static_cast<double>(change.greatest),
               height > ship.gm_in_waves.covered_height ? "  (sections continued above their offsets)" : "");
  }
}

void prepare(const Options& options, const StripShip& ship, Scratch& s) {
  const FloatingHull& floating = *ship.floating;
  choose_frequencies(*ship.loaded, s.transfer);
  const std::span<const double> omega(s.transfer.omega.data(), s.transfer.num_frequencies);
  const auto sea = choose_sea(options.sea);
  const Status placed = sea->is_measured ? place_on_grid(sea->measured, omega, s.sea)
                                         : place_on_grid(sea->systems, omega, s.sea);
  if (!placed) {
    throw InputError{floating.file + ": " + message(placed.error())};
  }
  std::vector<double> speeds;
  for (const double knots : options.speeds_kn) {
    speeds.push_back(from_knots(knots));
  }
  list_zone_ship(floating.hull, floating.loading, *ship.loaded, speeds, s.ship);
  prepare_zones(s.ship, s.sea, omega, s.zones);
}

void add_row(const Options& options, const Scratch& s, std::size_t v, double heading_deg,
             const ZoneFinding& found, Csv& csv) {
  const WaveSystem& system = s.sea.system[found.system];
  const EffectiveStability stability = effective_stability_at(s.zones.system[found.system], found.mu);
  csv.add(heading_deg).add(options.speeds_kn[v]).add(static_cast<int>(found.system));
  csv.add(system.hs).add(system.period).add(degrees(system.from.radians)).add(degrees(found.mu.radians));
  csv.add(kTwoPi / found.met.high);
  csv.add(found.met.low > 0.0 ? std::optional<double>(kTwoPi / found.met.low) : std::nullopt);
  csv.add(word(found.end));
  csv.add(static_cast<double>(stability.variation)).add(static_cast<double>(stability.least));
  csv.add(static_cast<double>(s.ship.roll_damping_ratio[v])).add(hazard_tokens(found.bits));
  csv.end_row();
}

void run(const Options& options) {
  refuse_too_many("--heading-deg and --speed-kn", {options.headings_deg.size(), options.speeds_kn.size()});
  const bool is_increasing = std::is_sorted(options.speeds_kn.begin(), options.speeds_kn.end());
  if (options.speeds_kn.size() > kMaxSpeeds || !is_increasing) {
    throw CLI::ValidationError("--speed-kn", fmt::format("at most {} speeds, increasing", kMaxSpeeds));
  }
  const StripShip ship = load_strip_ship(options.strip);
  const auto s = std::make_unique<Scratch>();
  prepare(options, ship, *s);
  say_ship(s->ship);
  Csv csv(kHeader);
  for (const double heading_deg : options.headings_deg) {
    for (std::size_t v = 0; v < options.speeds_kn.size(); ++v) {
      StaticVector<ZoneFinding, kMaxWaveSystems> findings;
      list_zone_findings(s->ship, s->zones, {wrap_two_pi(radians(heading_deg))}, s->ship.speeds[v], findings);
      for (const ZoneFinding& found : findings) {
        add_row(options, *s, v, heading_deg, found, csv);
      }
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_zones(CLI::App& app) {
  CLI::App* command = app.add_subcommand("zones", "IMO zones by wave system, and what they follow from");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  const SeaOptionHandles handles = add_sea_options(*command, options->sea);
  add_list(*command, "--heading-deg", options->headings_deg, kDirections_deg, "LIST of headings, true [deg]")
      ->required();
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "LIST of speeds, increasing [kn]")
      ->required();
  command->callback([options, handles] {
    handles.require_one();
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
