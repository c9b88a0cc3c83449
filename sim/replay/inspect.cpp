#include "sim/replay/inspect.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "msgs/convert/encode.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/lcm_log.hpp"
#include "msgs/files/printable.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/comparison_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/health_t.hpp"
#include "quickstrip/limits_t.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/logbook_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/outlook_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/response_t.hpp"
#include "quickstrip/sea_forecast_t.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"
#include "sim/replay/log_feed.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip {
namespace {

using Decodes = std::function<bool(std::span<const std::uint8_t>)>;

template <typename Message>
Decodes as() {
  const auto message = std::make_shared<Message>();
  return [message](std::span<const std::uint8_t> bytes) { return decode(bytes, *message); };
}

const std::map<std::string, Decodes, std::less<>>& types() {
  static const std::map<std::string, Decodes, std::less<>> kTypes{{"SEA_STATE", as<sea_state_t>()},
                                                                  {"WAVE_SPECTRUM", as<wave_spectrum_t>()},
                                                                  {"SEA_FORECAST", as<sea_forecast_t>()},
                                                                  {"OWN_SHIP", as<own_ship_t>()},
                                                                  {"LOADING", as<loading_t>()},
                                                                  {"MOTION", as<motion_t>()},
                                                                  {"TIME", as<quickstrip::clock_t>()},
                                                                  {"QUERY", as<query_t>()},
                                                                  {"ALERT_ACK", as<alert_t>()},
                                                                  {"ADVICE", as<advice_t>()},
                                                                  {"GRID", as<grid_t>()},
                                                                  {"RESPONSE", as<response_t>()},
                                                                  {"ALERT", as<alert_t>()},
                                                                  {"LIMITS", as<limits_t>()},
                                                                  {"HEALTH", as<health_t>()},
                                                                  {"OUTLOOK", as<outlook_t>()},
                                                                  {"COMPARISON", as<comparison_t>()},
                                                                  {"LOGBOOK", as<logbook_t>()}};
  return kTypes;
}

void note_time(std::int64_t utime, ChannelFigures& channel) {
  const bool is_first = channel.first_utime == 0;
  if (!is_first && utime - channel.last_utime > channel.longest_gap_us) {
    channel.longest_gap_us = utime - channel.last_utime;
    channel.longest_gap_from = channel.last_utime;
  }
  channel.first_utime = is_first ? utime : channel.first_utime;
  channel.last_utime = utime;
}

std::string utc_or_none(std::int64_t utime) {
  return utime == 0 ? std::string("-") : format_utc(utime);
}

}  // namespace

FileStatus inspect_log(const std::string& path, const std::string& prefix, LogFigures& out) {
  LcmLogReader log;
  if (FileStatus status = log.open(path); !status) {
    return status;
  }
  out = {};
  LogEvent event;
  while (log.next(event)) {
    ChannelFigures& channel = out.channels[event.channel];
    const std::string_view name = name_without_prefix(event.channel, prefix);
    if (const auto type = types().find(name); type != types().end()) {
      channel.is_ours = true;
      channel.num_malformed += type->second(event.data) ? 0u : 1u;
    }
    channel.num_bytes += event.data.size();
    ++channel.num_events;
    if (is_time(event.utime)) {
      note_time(event.utime, channel);
    } else {
      ++out.num_out_of_time;
    }
  }
  out.num_events = log.num_events();
  out.num_faults = log.num_faults();
  out.bytes_passed_over = log.bytes_passed_over();
  out.first_fault = log.faults().empty() ? std::string() : log.faults().front().line;
  return {};
}

std::string inspection_text(const LogFigures& figures) {
  std::string out = fmt::format("{:<20}{:>10}{:>12}{:>10}  {:<20}  {:<20}  {}\n", "channel", "events",
                                "bytes", "malformed", "first", "last", "longest gap");
  for (const auto& [name, channel] : figures.channels) {
    const std::string gap =
        channel.longest_gap_from == 0
            ? std::string("-")
            : fmt::format("{:.1f} s from {}", static_cast<double>(channel.longest_gap_us) * 1e-6,
                          format_utc(channel.longest_gap_from));
    const std::string malformed = channel.is_ours ? fmt::format("{}", channel.num_malformed) : "unknown";
    out += fmt::format("{:<20}{:>10}{:>12}{:>10}  {:<20}  {:<20}  {}\n", printable(name), channel.num_events,
                       channel.num_bytes, malformed, utc_or_none(channel.first_utime),
                       utc_or_none(channel.last_utime), gap);
  }
  out += fmt::format("{} events", figures.num_events);
  if (figures.num_out_of_time > 0) {
    out += fmt::format("; {} with a time not between 1970 and 2200", figures.num_out_of_time);
  }
  if (figures.num_faults > 0) {
    out += fmt::format("; {} damaged places, {} bytes passed over; the first: {}", figures.num_faults,
                       figures.bytes_passed_over, figures.first_fault);
  }
  return out + "\n";
}

}  // namespace quickstrip
