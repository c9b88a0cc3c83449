// Each incoming message through decode, convert and a cycle of the session; the advisor's own ones through
// their readers and the picture.
#include <algorithm>
#include <memory>
#include <string>

#include "msgs/convert/own_messages.hpp"
#include "sim/picture/polar_picture.hpp"
#include "sim/replay/log_feed.hpp"
#include "tests/bad_input/good_messages.hpp"
#include "tests/fuzz/good_bytes.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

/// Configured once: what a message leaves behind is as old as any other input.
struct Sailing {
  Session session;
  LogFeed feed{"QS_"};
  CheckingOutbox outbox;
  Sailing() { configure(session); }
};

Sailing& sailing() {
  static const auto kSailing = std::make_unique<Sailing>();
  return *kSailing;
}

/// A cycle at `now` with fresh inputs of every other kind, and the one after a rebuild.
void cycle(Sailing& ship, std::int64_t now) {
  ship.session.cycle(now, ship.outbox);
  if (ship.session.is_rebuild_due()) {
    ship.session.rebuild();
    ship.session.cycle(now, ship.outbox);
  }
}

void feed_and_cycle(std::string_view channel, std::span<const std::uint8_t> bytes) {
  Sailing& ship = sailing();
  const Bytes laid = laid_over(good_bytes(channel), bytes);
  // Every type begins with its time: the clock shows that, so that the message is fresh.
  std::uint64_t utime = 0;
  for (std::size_t i = 8; i < 16; ++i) {
    utime = (utime << 8) | laid[i];
  }
  const auto now =
      is_time(static_cast<std::int64_t>(utime)) ? static_cast<std::int64_t>(utime) : test::kStart;
  static_cast<void>(ship.session.accept(test::swell(now, 3.0, 90.0), now));
  static_cast<void>(ship.session.accept(test::ship(now, 0.0, 10.0), now));
  const std::string name = "QS_" + std::string(channel);
  static_cast<void>(ship.feed.feed({0, now, name, {bytes.begin(), bytes.end()}}, now, ship.session));
  if (ship.feed.feed({0, now, name, laid}, now, ship.session) != Fed::kRefused) {
    cycle(ship, now);
  }
}

}  // namespace

void run_sea_state(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("SEA_STATE", bytes);
}
void run_wave_spectrum(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("WAVE_SPECTRUM", bytes);
}
void run_sea_forecast(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("SEA_FORECAST", bytes);
}
void run_own_ship(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("OWN_SHIP", bytes);
}
void run_loading(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("LOADING", bytes);
}
void run_motion(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("MOTION", bytes);
}
void run_query(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("QUERY", bytes);
}
void run_alert_ack(std::span<const std::uint8_t> bytes) {
  feed_and_cycle("ALERT_ACK", bytes);
}

void run_time(std::span<const std::uint8_t> bytes) {
  quickstrip::clock_t time{};
  if (decode(laid_over(good_bytes("TIME"), bytes), time) && sailing().session.accept(time).ok()) {
    cycle(sailing(), time.utime);
  }
}

void run_picture(std::span<const std::uint8_t> bytes) {
  static const OwnMessages kGood = own_messages();
  static const auto picture = std::make_unique<PolarPicture>();
  const std::size_t share = bytes.size() / 3;
  const bool is_read = decode(laid_over(kGood.advice, bytes.first(share)), picture->advice) &&
                       decode(laid_over(kGood.limits, bytes.subspan(share, share)), picture->limits) &&
                       decode(laid_over(kGood.grid, bytes.subspan(2 * share)), picture->grid);
  if (is_read && check_advice(picture->advice).ok() && check_grid(picture->grid).ok() &&
      check_limits(picture->limits).ok()) {
    require(!polar_script(*picture, "a.png").empty(), "there is a picture of what the readers take");
  }
}

}  // namespace quickstrip::fuzz
