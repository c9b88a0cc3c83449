#include "sim/replay/voyage_log.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>

#include "core/base/angles.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/printable.hpp"
#include "quickstrip/own_ship_t.hpp"

namespace quickstrip {
namespace {

constexpr std::int16_t kSimulatorId = 100;
constexpr std::int64_t kMaxOwnShipMessages = 20'000'000;  // 4 GB; a wrong year does not fill the disk

own_ship_t own_ship_message(const VoyageLeg& leg, std::int64_t utime, std::int32_t seq) {
  own_ship_t message{};
  message.utime = utime;
  message.seq = seq;
  message.source_id = kSimulatorId;
  message.valid =
      std::int32_t{own_ship_t::VALID_HEADING} | std::int32_t{own_ship_t::VALID_SPEED_THROUGH_WATER};
  message.heading_deg = degrees(wrap_two_pi(leg.heading.radians));
  message.speed_through_water_kn = to_knots(leg.speed);
  return message;
}

/// Encodes and appends; owns its buffer.
class Appender {
 public:
  Appender(LcmLogWriter& log, std::string prefix) : log_(log), prefix_(std::move(prefix)) {}
  template <typename Message>
  FileStatus append(std::string_view channel, const Message& message) {
    return log_.append(message.utime, prefix_ + std::string(channel), encode(message, bytes_));
  }

 private:
  LcmLogWriter& log_;
  std::string prefix_;
  std::array<std::uint8_t, kMaxMessageBytes> bytes_{};
};

}  // namespace

FileStatus write_voyage_log(const SeaSeries& sea, const Voyage& voyage, const VoyageLogOptions& options,
                            LcmLogWriter& log, VoyageLogFigures& figures) {
  const auto out = std::make_unique<Appender>(log, options.prefix);
  const auto spectrum = std::make_unique<wave_spectrum_t>();
  const auto period = static_cast<std::int64_t>(options.own_ship_period_s * 1e6);
  std::size_t next_sea = 0;
  const std::int64_t start = voyage.legs.front().from_utime;
  if ((voyage.end_utime - start) / period > kMaxOwnShipMessages) {
    return FileError{fmt::format(
        "{}: {:.0f} days with own ship every {:g} s: at most {} messages, or {:.0f} days, are wanted",
        printable(voyage.name), seconds_between(start, voyage.end_utime) / 86400.0, options.own_ship_period_s,
        kMaxOwnShipMessages, static_cast<double>(kMaxOwnShipMessages) * options.own_ship_period_s / 86400.0)};
  }
  while (next_sea < sea.records.size() && sea.records[next_sea].utime_us < start) {
    ++next_sea;
  }
  figures = {};
  for (std::int64_t now = start; now < voyage.end_utime; now += period) {
    const VoyageLeg* const leg = leg_at(voyage, now);
    ++figures.num_own_ship;
    const own_ship_t ship = own_ship_message(*leg, now, static_cast<std::int32_t>(figures.num_own_ship));
    if (FileStatus status = out->append("OWN_SHIP", ship); !status) {
      return status;
    }
    for (; next_sea < sea.records.size() && sea.records[next_sea].utime_us < now + period; ++next_sea) {
      const SeaRecord& record = sea.records[next_sea];
      *spectrum = wave_spectrum_t{};
      to_message(record.spectrum, *spectrum);
      spectrum->utime = record.utime_us;
      spectrum->seq = static_cast<std::int32_t>(++figures.num_spectra);
      spectrum->source_id = kSimulatorId;
      spectrum->source_kind = wave_spectrum_t::SOURCE_BUOY;
      if (FileStatus status = out->append("WAVE_SPECTRUM", *spectrum); !status) {
        return status;
      }
    }
  }
  if (figures.num_spectra == 0) {
    return FileError{sea.source + ": no wave spectrum between the voyage's start and end"};
  }
  return {};
}

}  // namespace quickstrip
