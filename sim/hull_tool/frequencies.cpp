// quickstrip-hull frequencies: what the choice of wave frequencies costs and what it gets wrong.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/frequency_sets.hpp"
#include "sim/hull_tool/quantity_name.hpp"
#include "sim/hull_tool/spectrum_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  SpectrumOptions spectrum;
  double speed_kn = 0.0;
  double mu_deg = 0.0;
  std::string format = "table";
};

struct Label {
  const char* name = "";
  const char* unit = "";
  std::string where;
};

Label label_of(const Channel& channel, const Hull& hull) {
  const QuantityName words = name_of(channel.quantity);
  return {words.name, words.unit, place_of(channel.quantity, channel.place, hull)};
}

double error_percent(double value, double reference) {
  return reference != 0.0 ? 100.0 * (value - reference) / std::fabs(reference) : 0.0;
}

std::string as_csv(const std::vector<FrequencySet>& sets, const Watch& watch, const Hull& hull) {
  Csv csv("set,solutions,time_ms,quantity,where,unit,significant,error_percent");
  const auto add = [&](const FrequencySet& set, const char* quantity, const std::string& where,
                       const char* unit, double value, double reference) {
    csv.add(set.name).add(static_cast<int>(set.solutions)).add(1000.0 * set.seconds);
    csv.add(quantity).add(std::string_view(where)).add(unit).add(value);
    csv.add(error_percent(value, reference)).end_row();
  };
  for (const FrequencySet& set : sets) {
    add(set, "wave_height", "", "m", set.wave_height, sets.front().wave_height);
    add(set, "added_resistance", "", "N", set.added_resistance, sets.front().added_resistance);
    for (std::size_t i = 0; i < watch.channels.size(); ++i) {
      const Label label = label_of(watch.channels[i], hull);
      add(set, label.name, label.where, label.unit, set.significant[i], sets.front().significant[i]);
    }
  }
  return csv.text();
}

std::string as_table(const std::vector<FrequencySet>& sets, const Watch& watch, const Hull& hull) {
  std::string out = fmt::format("{:<48}", "significant amplitude");
  const auto add_line = [&](const std::string& label, auto text) {
    out += fmt::format("\n{:<48}", label);
    for (const FrequencySet& set : sets) {
      out += fmt::format("{:>16}", text(set));
    }
  };
  for (const FrequencySet& set : sets) {
    out += fmt::format("{:>16}", set.name);
  }
  add_line("solutions", [](const FrequencySet& set) { return std::to_string(set.solutions); });
  add_line("time, ms", [](const FrequencySet& set) { return fmt::format("{:.3f}", 1000.0 * set.seconds); });
  const auto value_line = [&](const std::string& label, auto value) {
    add_line(label, [&](const FrequencySet& set) {
      return &set == &sets.front() ? fmt::format("{:.4g}", value(set))
                                   : fmt::format("{:+.2f} %", error_percent(value(set), value(sets.front())));
    });
  };
  value_line("wave height, m", [](const FrequencySet& set) { return set.wave_height; });
  value_line("mean added resistance, N", [](const FrequencySet& set) { return set.added_resistance; });
  double largest_roll = 0.0;
  for (std::size_t i = 0; i < watch.channels.size(); ++i) {
    const Label label = label_of(watch.channels[i], hull);
    largest_roll = std::max(largest_roll, sets.front().significant[i]);
    if (sets.front().significant[i] < 1e-9 * largest_roll) {
      continue;  // does not move in these waves
    }
    value_line(fmt::format("{}, {}, {}", label.name, label.where, label.unit),
               [i](const FrequencySet& set) { return set.significant[i]; });
  }
  return out + "\n";
}

void run(const Options& options) {
  if (options.spectrum.spreading_deg != 0.0) {
    throw CLI::ValidationError("--spreading-deg", "a long-crested sea is compared: 0 is wanted");
  }
  if (std::fmod(options.mu_deg, 5.0) != 0.0) {
    throw CLI::ValidationError(
        "--mu-deg",
        fmt::format("{:g}: a multiple of 5 is wanted, which the default set solves", options.mu_deg));
  }
  const StripShip ship = load_strip_ship(options.strip);
  const Hull& hull = ship.floating->hull;
  if (depends_on_amplitude(ship.loaded->roll_damping)) {
    throw InputError{fmt::format(
        "{}: roll_damping.method = ikeda: grows with the roll, so no transfer function is exact; give "
        "--roll-damping-ratio",
        options.strip.file)};
  }
  const auto watch = std::make_unique<Watch>();
  const Status listed = list_channels(hull, ship.floating->loading, ship.floating->hydrostatics,
                                      SwellUp::kOff, *watch);  // integration is compared
  if (!listed) {
    throw InputError{options.strip.file + ": " + message(listed.error())};
  }
  const SeaState sea = options.spectrum.sea_from(WaveFrom{0.0});
  const auto sets =
      compare_frequency_sets(*ship.loaded, *watch, sea.systems[0],
                             EncounterAngle{wrap_pi(radians(options.mu_deg))}, from_knots(options.speed_kn));
  print_result(options.format == "csv" ? as_csv(sets, *watch, hull) : as_table(sets, *watch, hull));
}

}  // namespace

void add_frequencies(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "frequencies", "Error and time of the paper's quick set of wave frequencies, beside the default one");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_spectrum_options(*command, options->spectrum, true);
  add_number(*command, "--speed-kn", options->speed_kn, {0.0, 60.0}, "speed [kn]")->required();
  add_number(*command, "--mu-deg", options->mu_deg, kDirections_deg,
             "wave direction: 0 following, 90 from starboard, 180 head; a multiple of 5 [deg]")
      ->required();
  command->add_option("--format", options->format, "table or csv")
      ->check(CLI::IsMember({"table", "csv"}))
      ->capture_default_str()
      ->type_name("");
  command->footer(
      "reference: 2,000 frequencies; default: the advisor's, roll peak included; paper: motions at 0.1 ... "
      "1.8\n"
      "rad/s, two more frequencies in each interval by Theilheimer polynomials (not-a-knot cubic splines) of "
      "the\n"
      "complex motions, or of amplitude and phase; 18-alone: without the polynomials. Errors against "
      "reference;\n"
      "a long-crested sea; time for one speed and direction.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
