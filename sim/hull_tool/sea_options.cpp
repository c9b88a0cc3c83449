#include "sim/hull_tool/sea_options.hpp"

#include <fmt/format.h>

#include <optional>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/sea_files/sea_series.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip::hull_tool {
namespace {

const SeaRecord& chosen_record(const SeaOptions& options, const SeaSeries& series) {
  if (options.at.empty()) {
    const SeaRecord* highest = &series.records.front();
    for (const SeaRecord& record : series.records) {
      highest = record.hs > highest->hs ? &record : highest;
    }
    return *highest;
  }
  const std::optional<std::int64_t> at = parse_utc(options.at);
  if (!at) {
    throw CLI::ValidationError("--at", options.at + ": a time such as 2019-09-04T12:40:00Z is wanted");
  }
  const SeaRecord* record = record_at(series, *at);
  if (record == nullptr) {
    throw InputError{fmt::format("{}: --at = {}: no measurement within 90 minutes before it",
                                 options.sea_file, options.at)};
  }
  return *record;
}

}  // namespace

void SeaOptionHandles::require_one() const {
  if (shape->empty() && sea->empty()) {
    throw CLI::RequiredError("--spectrum or --sea");
  }
}

SeaOptionHandles add_sea_options(CLI::App& command, SeaOptions& options) {
  SeaOptionHandles out;
  add_spectrum_options(command, options.spectrum, false);
  out.shape = command.get_option("--spectrum");
  out.dir_from = add_number(command, "--dir-from-deg", options.dir_from_deg, kDirections_deg,
                            "where the waves come from, true [deg]")
                     ->needs(out.shape);
  out.sea = command.add_option("--sea", options.sea_file, "sea file, or ndbc:PREFIX");
  out.sea->excludes(out.shape);
  command.add_option("--at", options.at, "UTC time in the sea file; default: its highest sea")
      ->needs(out.sea);
  return out;
}

std::unique_ptr<ChosenSea> choose_sea(const SeaOptions& options) {
  auto out = std::make_unique<ChosenSea>();  // 37 kB
  if (options.spectrum.given()) {
    out->systems = options.spectrum.sea_from(WaveFrom{wrap_two_pi(radians(options.dir_from_deg))});
    out->hs = options.spectrum.hs;
    return out;
  }
  SeaSeries series;
  if (const FileStatus read = load_sea(options.sea_file, series); !read.ok()) {
    throw InputError{read.line()};
  }
  const SeaRecord& record = chosen_record(options, series);
  out->is_measured = true;
  out->measured = record.spectrum;
  out->utime_us = record.utime_us;
  out->hs = record.hs;
  return out;
}

}  // namespace quickstrip::hull_tool
