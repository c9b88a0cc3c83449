// Hull, limits, sea and voyage files, and logs. What is accepted goes on to where it is used.
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file.hpp"
#include "msgs/files/lcm_log.hpp"
#include "msgs/files/limits_file.hpp"
#include "msgs/files/voyage_file.hpp"
#include "sim/replay/event_stream.hpp"
#include "sim/replay/inspect.hpp"
#include "sim/sea_files/sea_file.hpp"
#include "sim/sea_files/sea_series.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

Bytes file_bytes(const std::string& path) {
  std::ifstream file(std::string(QUICKSTRIP_SOURCE_DIR) + "/" + path, std::ios::binary);
  require(file.good(), path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The advisor on a coarse grid: it takes the hull or says why not, and never advises in numbers that are
/// none.
void advise_with(Hull& hull) {
  static const auto advisor = std::make_unique<Advisor>();
  hull.grid = tiny_grid();
  const Result<Criteria> criteria = nordforsk_merchant(hull);
  if (!criteria || !advisor->configure(hull, *criteria, StripMethod{})) {
    return;
  }
  SeaState sea;
  static_cast<void>(sea.systems.push_back({}));
  sea.systems[0].hs = 3.0;
  sea.systems[0].period = 9.0;
  const OwnShip ship{Heading{1.0}, 5.0, false};
  StepInputs inputs;
  inputs.own_ship = &ship;
  inputs.sea_state = &sea;
  const StepOutput& output = advisor->step(inputs);
  if (output.advice.no_advice != NoAdvice::kNone) {
    return;
  }
  for (std::size_t s = 0; s < output.grid.num_speeds; ++s) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      require(std::isfinite(output.grid.cells[s][h].margin), "a margin is a number");
    }
  }
}

}  // namespace

void run_hull(std::span<const std::uint8_t> bytes) {
  static const auto hull = std::make_unique<Hull>();
  if (const FileStatus status = parse_hull(text_of(bytes), "hull.toml", *hull); !status) {
    require_one_line(status.line(), "hull.toml: ");
    return;
  }
  require(hull->stations.size() >= 3 && !hull->name.view().empty(), "a hull has stations and a name");
  if (hull->stations.size() <= 16) {  // larger ones only take longer
    advise_with(*hull);
  }
}

void run_limits(std::span<const std::uint8_t> bytes) {
  LimitsProfile profile;
  if (const FileStatus status = parse_limits(text_of(bytes), "limits.toml", tiny_ship(), profile); !status) {
    require_one_line(status.line(), "limits.toml: ");
    return;
  }
  require(check_criteria(profile.criteria, tiny_ship()).ok(),
          "core takes the limits of a file that is accepted");
}

void run_sea(std::span<const std::uint8_t> bytes) {
  BuoyRecord record;
  if (const FileStatus status = parse_sea_file(text_of(bytes), "a.sea", record); !status) {
    require_one_line(status.line(), "a.sea:");
    return;
  }
  if (record.hours.size() > 4) {
    return;
  }
  static const auto message = std::make_unique<wave_spectrum_t>();
  static const auto spectrum = std::make_unique<DirectionalSpectrum>();
  for (const SeaRecord& hour : sea_series(record).records) {
    *message = {};
    to_message(hour.spectrum, *message);
    message->utime = hour.utime_us;
    const Conversion taken = to_directional_spectrum(*message, *spectrum);
    const bool is_rounding = taken.refusal == Refusal::kEmpty ||  // below a float's smallest
                             taken.refusal == Refusal::kHeight;   // 30 m and a last digit
    require(taken.ok() || is_rounding || !is_time(hour.utime_us), "the advisor takes what a sea file holds");
  }
}

void run_voyage(std::span<const std::uint8_t> bytes) {
  Voyage voyage;
  if (const FileStatus status = parse_voyage(text_of(bytes), "voyage.toml", voyage); !status) {
    require_one_line(status.line(), "voyage.toml: ");
    return;
  }
  require(!voyage.legs.empty() && leg_at(voyage, voyage.end_utime) == nullptr &&
              leg_at(voyage, voyage.end_utime - 1) == &voyage.legs.back(),
          "the last leg holds until the end");
}

void run_log(std::span<const std::uint8_t> bytes) {
  static MemoryFile file;
  file.fill(bytes);
  LcmLogReader log;
  if (const FileStatus status = log.open(file.path()); !status) {
    require_one_line(status.line(), file.path());
    return;
  }
  LogEvent event;
  std::uint64_t read = 0;
  while (log.next(event)) {
    read += 28 + event.channel.size() + event.data.size();
  }
  require(read + log.bytes_passed_over() == bytes.size(), "every byte is read or passed over and counted");
  LogFigures figures;
  require(inspect_log(file.path(), "QS_", figures).ok(), "what can be read can be inspected");
  static_cast<void>(inspection_text(figures));
  LcmLogReader again;
  require(again.open(file.path()).ok(), "a log can be read twice");
  EventStream events(again);
  std::int64_t last = 0;
  while (events.next(event)) {
    require(is_time(event.utime) && event.utime >= last, "time never goes backwards");
    last = event.utime;
  }
}

std::vector<Bytes> hull_seeds() {
  return {file_bytes("sim/hulls/shortest.hull.toml"), file_bytes("sim/hulls/s175_minimal.hull.toml"),
          bytes_of(R"(schema = 1
name = "barge"
particulars = { lpp_m = 60.0, breadth_m = 12.0 }
[[station]]
x_m = 0.0
offsets_m = [[6.0, 0.0], [6.0, 5.0]]
[[station]]
x_m = 30.0
offsets_m = [[0.0, 0.0], [6.0, 0.0], [6.0, 5.0]]
[[station]]
x_m = 60.0
offsets_m = [[0.0, 0.0], [5.0, 2.0], [6.0, 5.0]]
[loading]
draught_aft_m = 2.0
draught_fwd_m = 2.0
kg_m = 3.0
gm_m = 4.0
roll_gyradius_m = 4.0
pitch_gyradius_m = 15.0
yaw_gyradius_m = 15.0
water_density_kg_m3 = 1000.0
[roll_damping]
method = "ratio"
ratio = 0.05
bilge_keel = { x_aft_m = 20.0, x_fwd_m = 40.0, breadth_m = 0.2 }
[[point]]
name = "bridge"
role = "bridge"
x_m = 5.0
z_m = 12.0
[[slamming]]
name = "bow"
x_m = 50.0
[[freeboard]]
name = "bow"
x_m = 60.0
height_m = 5.0
[propeller]
x_m = 1.0
tip_z_m = 1.5
[grid]
speeds_kn = { from = 0.0, to = 10.0, step = 5.0 }
heading_step_deg = 90.0
)")};
}

std::vector<Bytes> limits_seeds() {
  return {bytes_of(R"(schema = 1
name = "people"
[[criterion]]
name = "sick at {place}"
quantity = "motion_sickness"
role = "bridge"
statistic = "share_of_people"
limit_percent = 20
exposure_min = 240
[[criterion]]
name = "tips"
quantity = "motion_interruptions"
role = "bridge"
statistic = "per_minute"
limit_per_minute_by_length = [[100, 1.0], [300, 0.5]]
stance_height_m = 1.1
stance_half_width_ratio = 0.17
)"),
          bytes_of(R"(schema = 1
name = "heavy work on deck"
[[criterion]]
name = "vertical acc."
quantity = "vertical_acceleration"
role = "bridge"
statistic = "rms"
limit_g = 0.15
caution_fraction = 0.5
[[criterion]]
name = "roll"
quantity = "roll"
statistic = "significant"
limit_deg = 4.0
[[criterion]]
name = "slams"
quantity = "slamming"
place = "bow"
statistic = "per_hour"
limit_per_hour = 20
)")};
}

std::vector<Bytes> sea_seeds() {
  return {bytes_of(R"(quickstrip-sea 1
source buoy
frequencies_hz 0.05 0.1 0.15 0.3
hour 2019-08-30T00:40:00Z
density_m2_hz 0 12.5 3 0.1
alpha1_deg 51 218 220 0
alpha2_deg 50 231 360 5
r1_percent 20 35 90 0
r2_percent 99 93 80 0
# a comment
hour 2019-08-30T01:40Z
density_m2_hz 0 1 3 1e-3
alpha1_deg 51 218 220 0
alpha2_deg 50 231 360 5
r1_percent 20 35 90 100
r2_percent 9 3 80 100
)")};
}

std::vector<Bytes> voyage_seeds() {
  return {bytes_of(R"(schema = 1
name = "six hours"
end_utc = 2019-09-02T06:00:00Z
[[leg]]
from_utc = 2019-09-02T00:00:00Z
heading_deg = 75.0
speed_kn = 16.0
[[leg]]
from_utc = 2019-09-02T05:00:00+02:00
heading_deg = 0
speed_kn = 0
)")};
}

std::vector<Bytes> log_seeds() {
  Bytes log;
  const auto put = [&log](std::uint64_t value, int num_bytes) {
    for (int i = num_bytes - 1; i >= 0; --i) {
      log.push_back(static_cast<std::uint8_t>((value >> (8 * i)) & 0xFFu));
    }
  };
  for (std::uint64_t i = 0; i < 5; ++i) {
    const std::string channel = i % 2 == 0 ? "QS_OWN_SHIP" : "OTHER";
    put(0xEDA1DA01u, 4);
    put(i, 8);
    put(1'567'600'800'000'000u + i * 1'000'000u, 8);
    put(channel.size(), 4);
    put(10 * i, 4);
    log.insert(log.end(), channel.begin(), channel.end());
    log.insert(log.end(), 10 * i, static_cast<std::uint8_t>(i));
  }
  return {log};
}

}  // namespace quickstrip::fuzz
