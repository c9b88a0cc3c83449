#include "firmware/nmea/gateway.hpp"

#include "firmware/nmea/record_time.hpp"
#include "msgs/convert/units.hpp"
#include "quickstrip/clock_t.hpp"

namespace quickstrip::nmea {
namespace {

/// True when `period_s` have gone by since `last`, or the clock was set back behind it.
bool is_due(std::int64_t last, std::int64_t now, double period_s) {
  return now < last || seconds_between(last, now) >= period_s;
}

}  // namespace

Gateway::Gateway(const GatewayOptions& options, std::size_t num_sources, Sink& sink)
    : options_(options),
      sink_(sink),
      readers_(num_sources, Reader(options.reader)),
      state_(options.stale_after_s),
      window_(std::make_unique<MotionWindow>(options.window_s)) {}

void Gateway::take_datagram(std::size_t source, std::string_view datagram, std::int64_t arrival) {
  std::string_view rest = without_datagram_header(datagram);
  while (!rest.empty()) {  // each turn takes a line off the rest
    const std::size_t end = rest.find_first_of("\r\n");
    if (end != 0) {
      take(source, rest.substr(0, end), arrival);
    }
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
}

void Gateway::take(std::size_t source, std::string_view line, std::int64_t arrival) {
  counts_.lines.count(read(source, line, arrival));
}

Fate Gateway::read(std::size_t source, std::string_view line, std::int64_t arrival) {
  const auto stamp = take_stamp(line);
  if (options_.record_clock) {
    if (stamp) {
      if (has_time_) {
        turn(*stamp);  // what fell due before this line
      }
      record_time_ = *stamp;
      has_time_ = true;
    }
    if (!has_time_) {
      return Fate::kBadTime;
    }
  }
  Readings readings;
  std::size_t talker_rank = kMaxTalkers;
  const Fate fate = readers_[source].read(line, readings, talker_rank);
  if (fate == Fate::kTaken) {
    keep(readings, rank_of(source, talker_rank), options_.record_clock ? record_time_ : arrival);
  }
  return fate;
}

void Gateway::keep(const Readings& readings, Rank rank, std::int64_t utime) {
  for (const Reading& reading : readings) {
    const bool is_believed = state_.take(reading, rank, utime);
    switch (reading.quantity) {
      case Quantity::kRoll:
        is_believed ? window_->take_roll(reading.value, utime) : void();
        break;
      case Quantity::kPitch:
        is_believed ? window_->take_pitch(reading.value, utime) : void();
        break;
      case Quantity::kHeave:
        is_believed ? window_->take_heave(reading.value, utime) : void();
        break;
      default:
        has_news_ = true;
        break;
    }
  }
}

void Gateway::turn(std::int64_t now) {
  if (has_news_ && is_due(own_ship_sent_, now, 1.0 / options_.rate_hz)) {
    send_own_ship(now);
  }
  if (is_due(motion_sent_, now, options_.motion_every_s)) {
    send_motion(now);
  }
  if (options_.record_clock && is_due(time_sent_, now, 1.0)) {
    send_time(now);
  }
}

void Gateway::finish() {
  if (has_time_) {
    turn(record_time_);
    send_motion(record_time_);
  }
}

void Gateway::send_own_ship(std::int64_t now) {
  auto message = state_.own_ship(now);
  if (!message) {
    return;
  }
  has_news_ = false;
  own_ship_sent_ = now;
  const bool is_over_ground = (message->valid & own_ship_t::VALID_SPEED_THROUGH_WATER) == 0;
  send(Channel::kOwnShip, *message);
  ++counts_.own_ships;
  counts_.own_ships_over_ground += is_over_ground ? 1 : 0;
}

void Gateway::send_motion(std::int64_t now) {
  motion_sent_ = now;
  auto message = window_->motion(now);
  if (!message || message->utime == motion_utime_) {
    return;
  }
  motion_utime_ = message->utime;
  send(Channel::kMotion, *message);
  ++counts_.motions;
}

void Gateway::send_time(std::int64_t now) {
  time_sent_ = now;
  clock_t message{};
  message.utime = now;
  message.rate = options_.record_speed;
  send(Channel::kTime, message);
}

template <typename Message>
void Gateway::send(Channel channel, Message& message) {
  message.seq = seq_[static_cast<std::size_t>(channel)]++;
  message.source_id = options_.source_id;
  sink_.send(channel, message.utime, encode(message, bytes_));
}

}  // namespace quickstrip::nmea
