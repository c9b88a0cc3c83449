// A session led by bytes: which message comes, what is wrong in it, how the time goes, when a cycle runs.
#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "sim/replay/log_feed.hpp"
#include "tests/bad_input/good_messages.hpp"
#include "tests/fuzz/good_bytes.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr std::array<std::string_view, 8> kChannels{
    "SEA_STATE", "WAVE_SPECTRUM", "SEA_FORECAST", "OWN_SHIP", "LOADING", "MOTION", "QUERY", "ALERT_ACK"};
constexpr int kMaxCycles = 12;
constexpr int kMaxRebuilds = 4;  // 10 ms each

/// The bytes one after another; zeros at the end.
class Script {
 public:
  explicit Script(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool is_over() const { return at_ >= bytes_.size(); }
  std::uint8_t next() { return is_over() ? std::uint8_t{0} : bytes_[at_++]; }
  std::span<const std::uint8_t> take(std::size_t count) {
    const std::size_t n = std::min(count, bytes_.size() - at_);
    at_ += n;
    return bytes_.subspan(at_ - n, n);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

struct Voyage {
  Session session;
  LogFeed feed{"QS_"};
  CheckingOutbox outbox;
  std::int64_t now = test::kStart;
  int num_cycles = 0;
  int num_rebuilds = 0;
};

/// A good message, measured `age` ago, with some bytes at some place of it replaced.
void send_message(Script& script, std::string_view channel, Voyage& voyage) {
  Bytes bytes = good_bytes(channel);
  const std::int64_t utime = voyage.now - std::int64_t{script.next()} * test::kSecond;
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[8 + i] = static_cast<std::uint8_t>((static_cast<std::uint64_t>(utime) >> (56 - 8 * i)) & 0xFFu);
  }
  const std::size_t place = std::size_t{script.next()} * 256 + script.next();
  const auto wrong = script.take(script.next() % 16u);
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    bytes[8 + (place + i) % (bytes.size() - 8)] = wrong[i];
  }
  static_cast<void>(
      voyage.feed.feed({0, voyage.now, "QS_" + std::string(channel), bytes}, voyage.now, voyage.session));
}

/// By up to 127 seconds, minutes, hours, days or years, either way; refused as QS_TIME would be.
void move_time(Script& script, Voyage& voyage) {
  constexpr std::array<std::int64_t, 6> kUnits_s{1, 60, 3600, 86'400, 31'536'000, 0};
  const auto steps = static_cast<std::int8_t>(script.next());
  quickstrip::clock_t time{};
  time.utime = voyage.now + kUnits_s[script.next() % kUnits_s.size()] * steps * test::kSecond;
  if (voyage.session.accept(time).ok()) {
    voyage.now = time.utime;
  }
}

void run_cycle(Voyage& voyage) {
  if (voyage.num_cycles++ >= kMaxCycles) {
    return;
  }
  voyage.session.cycle(voyage.now, voyage.outbox);
  const advice_t& advice = voyage.session.advice();
  require((advice.no_advice == 0) != (advice.no_advice_text[0] != 0), "no advice comes with its reason");
  if (voyage.session.is_rebuild_due() && voyage.num_rebuilds++ < kMaxRebuilds) {
    voyage.session.rebuild();
  }
}

}  // namespace

void run_session(std::span<const std::uint8_t> bytes) {
  static const auto voyage = std::make_unique<Voyage>();
  static const auto kFresh = [] {  // to configure takes 70 ms, to copy 3
    auto session = std::make_unique<Session>();
    configure(*session);
    return session;
  }();
  voyage->session = *kFresh;
  voyage->now = test::kStart;
  voyage->num_cycles = 0;
  voyage->num_rebuilds = 0;
  Script script(bytes);
  while (!script.is_over()) {
    const std::uint8_t what = script.next() % 12u;
    if (what < kChannels.size()) {
      send_message(script, kChannels[what], *voyage);
    } else if (what == 8) {
      move_time(script, *voyage);
    } else if (what == 9) {
      const std::size_t channel = script.next() % kChannels.size();
      const auto raw = script.take(script.next());
      static_cast<void>(voyage->feed.feed(
          {0, voyage->now, "QS_" + std::string(kChannels[channel]), {raw.begin(), raw.end()}}, voyage->now,
          voyage->session));
    } else {
      run_cycle(*voyage);
    }
  }
  run_cycle(*voyage);
}

std::vector<Bytes> session_seeds() {
  // own ship, sea state, cycle, a minute, cycle, spectrum, loading, two cycles, query, cycle
  return {Bytes{3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 10, 8,  1,  1, 10, 1, 0, 0, 0,
                0, 4, 0, 0, 0, 0, 3, 0, 0, 0, 0,  10, 10, 6, 0,  0, 0, 0, 10},
          Bytes{0,  5, 0,   64, 4,  1, 2, 3, 4,  3, 1, 0, 8, 2, 9, 9,
                10, 8, 255, 4,  10, 8, 1, 4, 10, 9, 0, 3, 1, 2, 3, 10}};
}

}  // namespace quickstrip::fuzz
