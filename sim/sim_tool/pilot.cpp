// quickstrip-sim pilot HULL [--storms N] [--seed N] [--sea FILE --from UTC --to UTC] [--csv FILE]
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/method_options.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/ship_files.hpp"
#include "sim/hull_tool/loaded_table.hpp"
#include "sim/pilot/regret.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

using pilot::StormResult;

struct Options {
  std::string hull;
  std::string limits;
  std::string sea;
  std::string from = "1970-01-01T00:00Z";
  std::string to = "2199-01-01T00:00Z";
  std::string csv;
  std::size_t num_storms = 19;
  std::uint64_t seed = 1;
  double course_deg = 0.0;
  double speed_kn = 16.0;
  double direction_std_deg = 10.0;
  pilot::Noise noise;
  int changes_inside = pilot::kChangesInside;
  MethodOptions method;
};

std::int64_t utime_of_option(const char* name, const std::string& text) {
  const auto utime = parse_utc(text);
  if (!utime) {
    throw CLI::ValidationError(name, text + ": 2019-09-04T12:40Z is right");
  }
  return *utime;
}

std::vector<pilot::Storm> storms_of(const Options& options, SeaSeries& series) {
  std::vector<pilot::Storm> storms;
  if (!options.sea.empty()) {
    require(load_sea(options.sea, series));
    const std::int64_t from = utime_of_option("--from", options.from);
    const std::int64_t first = series.records.empty() ? from : series.records.front().utime_us;
    storms.push_back(pilot::measured_storm(std::filesystem::path(options.sea).stem(), series,
                                           std::max(from, first), utime_of_option("--to", options.to),
                                           {radians(options.course_deg)}, from_knots(options.speed_kn)));
    if (storms.back().num_half_hours() == 0) {
      throw InputError{options.sea + ": no measurement between --from and --to"};
    }
  }
  for (std::size_t i = 0; i < options.num_storms; ++i) {
    storms.push_back(pilot::synthetic_storm(options.seed + i));
  }
  return storms;
}

std::string table_header() {
  return "storm,hours,hold_exceeded_h,hold_not_judged_h,follow_exceeded_h,follow_not_judged_h,follow_changes,"
         "follow_changes_a_watch,follow_most_in_a_watch,pilot_exceeded_h,pilot_not_judged_h,pilot_changes,"
         "removed_share\n";
}

std::string line_of(const StormResult& r) {
  return fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{:.9g},{},{:.9g},{:.9g},{},{:.9g}\n", r.name,
                     r.hours, r.hold.exceeded_h, r.hold.not_judged_h, r.follow.exceeded_h,
                     r.follow.not_judged_h, r.follow.num_changes, r.follow.num_changes * 4.0 / r.hours,
                     r.follow.most_changes_in_a_watch, r.all_knowing.exceeded_h, r.all_knowing.not_judged_h,
                     r.all_knowing.num_changes, pilot::removed_share(r.hold, r.follow, r.all_knowing));
}

void add(pilot::Tally& sum, const pilot::Tally& one) {
  sum.exceeded_h += one.exceeded_h;
  sum.not_judged_h += one.not_judged_h;
  sum.num_changes += one.num_changes;
  sum.most_changes_in_a_watch = std::max(sum.most_changes_in_a_watch, one.most_changes_in_a_watch);
}

void tell(const StormResult& sum, std::size_t num_storms) {
  const auto line = [&sum](const char* who, const pilot::Tally& t) {
    fmt::print("{:<22}{:9.1f} h above a limit {:8.1f} h not judged {:6} changes, {:.2f} a watch, most {}\n",
               who, t.exceeded_h, t.not_judged_h, t.num_changes, t.num_changes * 4.0 / sum.hours,
               t.most_changes_in_a_watch);
  };
  fmt::print("{} storms, {:.0f} h\n", num_storms, sum.hours);
  line("as intended", sum.hold);
  line("by the advice", sum.follow);
  line("all-knowing pilot", sum.all_knowing);
  fmt::print("the advice removes {:.1f} % of the time above a limit that can be removed\n",
             100.0 * pilot::removed_share(sum.hold, sum.follow, sum.all_knowing));
}

void write_csv(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::ofstream file(part);
  file << text;
  file.close();
  std::error_code error;
  if (file) {
    std::filesystem::rename(part, path, error);
  }
  if (!file || error) {
    std::filesystem::remove(part, error);
    throw InputError{path + ": cannot be written"};
  }
}

void run(Options options) {
  options.noise.direction = radians(options.direction_std_deg);
  const auto files = std::make_unique<ShipFiles>();
  require(read_ship_files(options.hull, options.limits, *files));
  const auto series = std::make_unique<SeaSeries>();
  const std::vector<pilot::Storm> storms = storms_of(options, *series);
  const auto table = hull_tool::load_table(options.method.table, files->hull);
  pilot::Sailing sailing;
  if (const Status status =
          sailing.configure(files->hull, files->criteria, options.method.method(), hull_tool::view_of(table));
      !status) {
    throw InputError{refused_by_core(options.hull, status.error())};
  }
  StormResult sum;
  std::string csv = table_header();
  for (std::size_t i = 0; i < storms.size(); ++i) {
    if (isatty(STDERR_FILENO) != 0) {
      fmt::print(stderr, "\r{} of {} storms", i + 1, storms.size());
    }
    StormResult result;
    if (const Status status =
            sailing.sail(storms[i], options.noise, options.changes_inside, options.seed + i, result);
        !status) {
      throw InputError{storms[i].name + ": " + message(status.error())};
    }
    csv += line_of(result);
    sum.hours += result.hours;
    add(sum.hold, result.hold);
    add(sum.follow, result.follow);
    add(sum.all_knowing, result.all_knowing);
  }
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\n");
  }
  if (options.csv == "-") {
    fmt::print("{}", csv);
  } else if (!options.csv.empty()) {
    write_csv(options.csv, csv);
  }
  tell(sum, storms.size());
}

}  // namespace

void add_pilot(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "pilot", "Advice regret: storms sailed as intended, by the advice, and by a pilot who knows all");
  const auto options = std::make_shared<Options>();
  command->add_option("HULL", options->hull, "Hull file")->required();
  command->add_option("--limits", options->limits, "Limits file; default NORDFORSK 1987 for merchant ships");
  command->add_option("--storms", options->num_storms, "Synthetic ones")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the first of them, and of the errors of measurement")
      ->capture_default_str();
  command->add_option("--sea", options->sea, "A measured storm too: sea file, or ndbc:PREFIX");
  command->add_option("--from", options->from, "Of it, UTC")->capture_default_str();
  command->add_option("--to", options->to, "Until then, or the first gap")->capture_default_str();
  add_number(*command, "--course-deg", options->course_deg, {0.0, 359.999}, "Intended in it")
      ->default_str("0");
  add_number(*command, "--speed-kn", options->speed_kn, {0.0, 40.0}, "Intended in it")->default_str("16");
  add_number(*command, "--height-std", options->noise.height_part, {0.0, 0.5},
             "Errors of measurement, standard deviation, part of the height")
      ->default_str("0.1");
  add_number(*command, "--period-std", options->noise.period_part, {0.0, 0.5}, "Part of the period")
      ->default_str("0.05");
  add_number(*command, "--direction-std-deg", options->direction_std_deg, {0.0, 90.0}, "Of the direction")
      ->default_str("10");
  command
      ->add_option("--changes-inside", options->changes_inside,
                   "Of four changes a watch, how many while the shown verdict is inside the limits")
      ->check(CLI::Range(0, pilot::kChangesPerWatch))
      ->capture_default_str();
  command->add_option("--csv", options->csv, "A line a storm; - for standard output");
  add_method_options(*command, options->method);
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::sim_tool
