// quickstrip-hull grid: the advisor's verdict on every heading and speed, in a sea given by height and period
// or taken from a sea file. One step of the same core that runs on board.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "core/advisor.hpp"
#include "msgs/cli/method_options.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/floating_hull.hpp"
#include "sim/hull_tool/limits_option.hpp"
#include "sim/hull_tool/loaded_table.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/sea_options.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string file;
  std::string limits;
  MethodOptions method;
  SeaOptions sea;
  int repeat = 1;
};

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kCaution:
      return "caution";
    case Verdict::kExceeded:
      return "exceeded";
    case Verdict::kUnknown:
      break;
  }
  return "unknown";
}

// "vertical acceleration bridge" judged by RMS becomes vertical_acceleration_bridge_rms_m_s2.
std::string column_name(const Criterion& criterion) {
  std::string name(criterion.name.view());
  std::replace(name.begin(), name.end(), ' ', '_');
  switch (criterion.statistic) {
    case Statistic::kProbability:
      return name + "_probability";
    case Statistic::kPerHour:
      return name + "_per_hour";
    case Statistic::kShareOfPeople:
      return name + "_share_of_people";
    case Statistic::kPerMinute:
      return name + "_per_minute";
    case Statistic::kRms:
      name += "_rms";
      break;
    case Statistic::kSignificant:
      name += "_significant";
      break;
  }
  const bool angle = criterion.quantity == Quantity::kRoll || criterion.quantity == Quantity::kPitch ||
                     criterion.quantity == Quantity::kYaw;
  const bool length = criterion.quantity < Quantity::kRoll;
  return name + (angle ? "_rad" : length ? "_m" : "_m_s2");
}

std::string header(const Criteria& criteria) {
  std::string line = "heading_deg,speed_kn,verdict,governing,margin,quality";
  for (const Criterion& criterion : criteria) {
    line += "," + column_name(criterion);
  }
  return line +
         ",added_resistance_n,added_resistance_empirical_n,roll_damping_ratio,roll_damping_residual,hazards";
}

std::optional<double> resistance(float mean) {
  return mean > kNoResistance ? std::optional<double>(mean) : std::nullopt;
}

void add_rows(const StepOutput& output, const Criteria& criteria, Csv& csv) {
  const Grid& grid = output.grid;
  for (std::size_t h = 0; h < grid.num_headings; ++h) {
    for (std::size_t s = 0; s < grid.num_speeds; ++s) {
      const Cell& cell = grid.cells[s][h];
      csv.add(360.0 * static_cast<double>(h) / static_cast<double>(grid.num_headings));
      csv.add(to_knots(grid.speeds[s])).add(word(cell.verdict));
      csv.add(cell.governing == kNoCriterion ? std::string_view() : criteria[cell.governing].name.view());
      csv.add(static_cast<double>(cell.margin)).add(quality_text(cell.quality));
      for (std::size_t c = 0; c < criteria.size(); ++c) {
        const bool known = criteria[c].is_watched() && cell.values[c] >= 0.0F;
        csv.add(known ? std::optional<double>(cell.values[c]) : std::nullopt);
      }
      csv.add(resistance(cell.added_resistance)).add(resistance(cell.added_resistance_empirical));
      csv.add(static_cast<double>(cell.roll_damping_ratio))
          .add(static_cast<double>(cell.roll_damping_residual))
          .add(hazard_tokens(cell.hazards));
      csv.end_row();
    }
  }
}

void run(const Options& options) {
  const auto ship = float_hull(options.file);
  const Criteria criteria = limits_of(options.limits, *ship).criteria;
  const auto advisor = std::make_unique<Advisor>();
  const auto table = load_table(options.method.table, ship->hull);
  const Status configured =
      advisor->configure(ship->hull, criteria, options.method.method(), {}, view_of(table));
  if (!configured) {
    throw InputError{explain(configured.error(), *ship, {})};
  }
  const OwnShip own_ship{Heading{0.0}, advisor->transfer_functions().speeds[0], false};
  StepInputs inputs;
  inputs.own_ship = &own_ship;
  const auto sea = choose_sea(options.sea);
  if (sea->is_measured) {
    inputs.spectrum = &sea->measured;
  } else {
    inputs.sea_state = &sea->systems;
  }
  Csv csv(header(criteria));
  for (int i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const StepOutput& output = advisor->step(inputs);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (output.advice.no_advice != NoAdvice::kNone) {
      throw InputError{fmt::format("{}: the sea gives no advice (reason {})", options.file,
                                   static_cast<int>(output.advice.no_advice))};
    }
    if (options.repeat > 1) {
      fmt::print(stderr, "cycle {}: {:.2f} ms\n", i + 1, took.count());
    }
    if (i + 1 == options.repeat) {
      add_rows(output, criteria, csv);
      fmt::print(stderr, "unknown: {:.1f} % of the cells at steerage speed and above\n",
                 100.0 * output.unknown_share);
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_grid(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("grid", "The advisor's verdict on every heading and speed in one sea");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  add_limits_option(*command, options->limits);
  add_method_options(*command, options->method);
  const SeaOptionHandles handles = add_sea_options(*command, options->sea);
  command->add_option("--repeat", options->repeat, "steps to run; their times on standard error")
      ->check(CLI::Range(1, 1'000'000));
  command->callback([options, handles] {
    handles.require_one();
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
