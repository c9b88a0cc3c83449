// The emulated board beside the same session on this machine, fed the same bytes over an hour of Dorian: the
// same verdicts. And beside the bridge computer's profile, which is only printed. QEMU is not cycle accurate:
// times are instructions, one nanosecond each.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

#include "core/sea/partition.hpp"
#include "firmware/cortex-m7/serial/channels.hpp"
#include "firmware/session/session.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/hull_table_file.hpp"
#include "msgs/files/ship_files.hpp"
#include "sim/sea_files/sea_series.hpp"
#include "tests/cortex_m7/serial_process.hpp"

namespace quickstrip::test {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kStart = 1'567'339'800 * kSecond;  // 2019-09-01, 12:10
constexpr int kMinutes = 60;
constexpr double kMostPerCycle_s = 60.0;
constexpr double kNear = 1e-3;  // of a limit: there rounding may decide

/// Bytes into a list.
class Bytes final : public ByteSink {
 public:
  void put(std::span<const std::uint8_t> bytes) override {
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::uint8_t> all;
};

template <typename Message>
void add_frame(SerialChannel channel, const Message& message, Bytes& out) {
  std::vector<std::uint8_t> data(kMaxFrameData);
  const auto encoded = encode(message, data);
  ASSERT_TRUE(send_frame(static_cast<std::uint8_t>(channel), encoded, out));
}

sea_state_t sea_of(const SeaRecord& record) {
  static PartitionWorkspace work;
  static WavePartition partition;
  QS_CHECK(divide_into_systems(record.spectrum, work, partition));
  auto& systems = partition.system;
  const auto end = systems.begin() + static_cast<std::ptrdiff_t>(partition.num_systems);
  std::sort(systems.begin(), end, [](const WaveSystem& a, const WaveSystem& b) { return a.hs > b.hs; });
  SeaState sea;
  for (std::size_t i = 0; i < std::min<std::size_t>(partition.num_systems, 3); ++i) {  // three: the board's
    QS_CHECK(sea.systems.push_back(systems[i]));
  }
  sea_state_t message{};
  to_message(sea, message);
  message.utime = record.utime_us;
  message.source_id = 7;
  return message;
}

/// Round the compass once in half an hour, 8 to 18 knots.
own_ship_t ship_at(int minute) {
  own_ship_t ship{};
  ship.utime = kStart + minute * 60 * kSecond;
  ship.seq = minute;
  ship.source_id = 2;
  ship.valid = int{own_ship_t::VALID_HEADING} | int{own_ship_t::VALID_SPEED_THROUGH_WATER};
  ship.heading_deg = std::fmod(12.0 * minute + 3.0, 360.0);
  ship.speed_through_water_kn = 8.0 + static_cast<double>(minute % 11);
  return ship;
}

/// Water taken on and pumped out: a rebuild each.
loading_t loading_at(int minute) {
  loading_t loading{};
  loading.utime = kStart + minute * 60 * kSecond;
  loading.source_id = 3;
  loading.valid = int{loading_t::VALID_DRAUGHTS} | int{loading_t::VALID_KG};
  loading.draught_aft_m = minute < 40 ? 9.7 : 9.4;
  loading.draught_fwd_m = 9.4;
  loading.kg_m = minute < 40 ? 9.4 : 9.6;
  return loading;
}

/// What is wrong on the line in some minutes, and how often it is to be counted.
struct Damage {
  int corrupted = 0;
  int unknown = 0;
};
constexpr int kCorruptedShip = 10;
constexpr int kCutShip = 30;

void add_own_ship(int minute, Bytes& out, Damage& expected) {
  Bytes frame;
  add_frame(SerialChannel::kOwnShip, ship_at(minute), frame);
  if (minute == kCorruptedShip) {
    frame.all[40] ^= 0x10;
    ++expected.corrupted;
  }
  if (minute == kCutShip) {
    frame.all.resize(frame.all.size() / 2);
    ++expected.corrupted;
  }
  if (minute == 15) {  // noise between frames: no zero in it
    out.all.insert(out.all.end(), {0x12, 0x34, 0xFF, 0x01, 0x77});
    ++expected.corrupted;
  }
  if (minute == 16) {
    QS_CHECK(send_frame(99, frame.all, out));
    ++expected.unknown;
  }
  out.all.insert(out.all.end(), frame.all.begin(), frame.all.end());
}

struct Voyage {
  SeaSeries sea;
  Damage expected;

  std::vector<std::uint8_t> bytes_of(int minute) {
    Bytes out;
    const std::int64_t now = kStart + minute * 60 * kSecond;
    if (minute % 10 == 0) {
      add_frame(SerialChannel::kSeaState, sea_of(*record_at(sea, now)), out);
    }
    add_own_ship(minute, out, expected);
    if (minute == 20 || minute == 40) {
      add_frame(SerialChannel::kLoading, loading_at(minute), out);
    }
    clock_t time{};
    time.utime = now;
    time.seq = minute;
    time.rate = -1.0;
    add_frame(SerialChannel::kTime, time, out);
    return out.all;
  }
};

template <typename Message>
std::optional<Message> message_of(const Answer& answer, OutChannel channel) {
  const auto id = static_cast<std::uint8_t>(SerialChannel::kFirstOut) + static_cast<std::uint8_t>(channel);
  const auto at = answer.find(static_cast<std::uint8_t>(id));
  Message message{};
  if (at == answer.end() || !decode(at->second, message)) {
    return std::nullopt;
  }
  return message;
}

std::uint32_t report_number(const Answer& answer, std::size_t index) {
  const auto& bytes = answer.at(static_cast<std::uint8_t>(SerialChannel::kLineReport));
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8u | bytes.at(4 * index + i);
  }
  return number;
}

/// How near to a limit or to its caution the nearest criterion is, as a share of it.
double nearness(const advice_t& advice, const Criteria& criteria) {
  double nearest = 1.0;
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    // advice carries the criterion's unit: of the ratio only its distance from 1 matters
    const double limit = criteria[i].quantity == Quantity::kRoll || criteria[i].quantity == Quantity::kPitch
                             ? degrees(criteria[i].limit)
                             : criteria[i].limit;
    const double ratio = advice.criterion_value[i] / limit;
    nearest =
        std::min({nearest, std::abs(ratio - 1.0), std::abs(ratio / criteria[i].caution_fraction - 1.0)});
  }
  return nearest;
}

struct Comparison {
  int num_verdicts = 0;
  int num_other = 0;
  int num_other_far = 0;
  double margin = 0.0;  // largest relative difference
  std::map<int, int> verdicts;
};

void compare(int minute, const advice_t& board, const advice_t& other, const Criteria& criteria,
             const char* who, Comparison& out) {
  if (board.no_advice != 0 || other.no_advice != 0) {
    return;
  }
  ++out.num_verdicts;
  ++out.verdicts[board.verdict];
  out.margin = std::max(out.margin, std::abs(board.margin - other.margin) / std::max(0.1, other.margin));
  if (board.verdict != other.verdict) {
    ++out.num_other;
    const double near = nearness(other, criteria);
    out.num_other_far += near > kNear ? 1 : 0;
    fmt::print(
        "  minute {}: verdict {} on the board, {} {}; {} {:.5g}, limit {:.5g}; margin {:.5g} and {:.5g}\n",
        minute, board.verdict, other.verdict, who,
        get_text({other.governing_name, sizeof other.governing_name}), other.governing_value,
        other.governing_limit, board.margin, other.margin);
  }
}

/// The bridge computer's session in the same hour.
class Bridge final : public Outbox {
 public:
  Bridge() {
    QS_CHECK(read_ship_files(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", "", files).ok());
    words_.resize(kMaxHullTableBytes / 4);
    QS_CHECK(read_hull_table(QUICKSTRIP_M7_TABLE, files.hull, words_, table_).ok());
    SessionOptions options;
    options.log_clock = true;
    options.table = &*table_;
    QS_CHECK(session->configure(files.hull, files.criteria, options));
  }
  bool send(OutChannel /*channel*/, std::span<const std::uint8_t> /*bytes*/) override { return true; }

  const advice_t& cycle(int minute, const SeaSeries& sea) {
    const std::int64_t now = kStart + minute * 60 * kSecond;
    if (minute % 10 == 0) {
      static_cast<void>(session->accept(sea_of(*record_at(sea, now)), now));
    }
    if (minute != kCorruptedShip && minute != kCutShip) {
      static_cast<void>(session->accept(ship_at(minute), now));
    }
    if (minute == 20 || minute == 40) {
      static_cast<void>(session->accept(loading_at(minute), now));
    }
    session->cycle(now, *this);
    if (session->is_rebuild_due()) {
      session->rebuild();
    }
    return session->advice();
  }

  ShipFiles files;
  std::unique_ptr<Session> session = std::make_unique<Session>();

 private:
  std::vector<std::uint32_t> words_;
  std::optional<HullTable> table_;
};

std::vector<std::string> emulator() {
  return {"qemu-system-arm",
          "-M",
          "mps2-an500",
          "-display",
          "none",
          "-monitor",
          "none",
          "-serial",
          "stdio",
          "-semihosting-config",
          "enable=on,target=native",
          "-icount",
          "shift=0,sleep=off",
          "-kernel",
          QUICKSTRIP_BOARD_PROGRAM};
}

struct Times {
  double most_cycle_s = 0.0;
  double sum_cycle_s = 0.0;
  double most_rebuild_s = 0.0;
};

TEST(CortexM7, GivesTheHostsVerdictsOverAnHourOfDorian) {
  Voyage voyage;
  ASSERT_TRUE(load_sea(QUICKSTRIP_SOURCE_DIR "/sim/storms/dorian_41010.sea", voyage.sea).ok());
  SerialProcess board(emulator());
  SerialProcess host({QUICKSTRIP_M7_ON_HOST});
  const auto bridge = std::make_unique<Bridge>();
  const Criteria& criteria = bridge->files.criteria;
  Comparison with_host;
  Comparison with_bridge;
  Times times;
  Answer last;
  int num_same_bytes = 0;
  for (int minute = 0; minute < kMinutes; ++minute) {
    const auto bytes = voyage.bytes_of(minute);
    board.write(bytes);
    host.write(bytes);
    const auto& on_bridge = bridge->cycle(minute, voyage.sea);
    last = board.read_answer(kMostPerCycle_s);
    const Answer on_host = host.read_answer(kMostPerCycle_s);
    const auto ours = message_of<advice_t>(last, OutChannel::kAdvice);
    const auto theirs = message_of<advice_t>(on_host, OutChannel::kAdvice);
    ASSERT_TRUE(ours && theirs) << "minute " << minute << ": no advice message";
    EXPECT_EQ(ours->utime, kStart + minute * 60 * kSecond);
    EXPECT_EQ(ours->no_advice, theirs->no_advice) << minute;
    EXPECT_EQ(get_text({ours->no_advice_text, sizeof ours->no_advice_text}),
              get_text({theirs->no_advice_text, sizeof theirs->no_advice_text}));
    const bool is_ship_lost = minute == kCorruptedShip || minute == kCutShip;
    EXPECT_EQ(ours->no_advice == static_cast<int>(NoAdvice::kOwnShipStale), is_ship_lost) << minute;
    EXPECT_EQ(ours->no_advice == static_cast<int>(NoAdvice::kLoadingChanged), minute == 20 || minute == 40);
    EXPECT_EQ(ours->no_advice, on_bridge.no_advice) << minute;
    num_same_bytes += std::memcmp(&*ours, &*theirs, sizeof *ours) == 0 ? 1 : 0;
    compare(minute, *ours, *theirs, criteria, "on this machine", with_host);
    compare(minute, *ours, on_bridge, criteria, "with the bridge's profile", with_bridge);
    const double cycle_s = report_number(last, 5) * 1e-6;
    times.most_cycle_s = std::max(times.most_cycle_s, cycle_s);
    times.sum_cycle_s += cycle_s;
    times.most_rebuild_s = std::max(times.most_rebuild_s, report_number(last, 6) * 1e-6);
  }
  fmt::print(
      "Cortex-M7 in QEMU, {} cycles: {} with a verdict, {} of them other than this machine's in the same "
      "profile; "
      "largest difference of the margin {:.2g}; {} messages the same to the bit\n",
      kMinutes, with_host.num_verdicts, with_host.num_other, with_host.margin, num_same_bytes);
  fmt::print(
      "beside the bridge's profile (36 directions for 72, 8 speeds for 25, 24 frequencies for 48): {} other "
      "verdicts, largest difference of the margin {:.2g}\n",
      with_bridge.num_other, with_bridge.margin);
  fmt::print(
      "instructions (QEMU is not cycle accurate): a cycle {:.0f} million in the mean, {:.0f} at most; a new "
      "loading {:.0f}; stack {} bytes deep\n",
      1e3 * times.sum_cycle_s / kMinutes, 1e3 * times.most_cycle_s, 1e3 * times.most_rebuild_s,
      report_number(last, 7));
  EXPECT_EQ(with_host.num_other_far, 0);
  EXPECT_GT(with_host.num_verdicts, 50);
  EXPECT_GE(with_host.verdicts.size(), 2U);  // the hour has something to tell
  EXPECT_EQ(report_number(last, 1), static_cast<std::uint32_t>(voyage.expected.corrupted));
  EXPECT_EQ(report_number(last, 2), 0U);
  EXPECT_EQ(report_number(last, 3), static_cast<std::uint32_t>(voyage.expected.unknown));
  EXPECT_EQ(report_number(last, 4), 0U);
  EXPECT_EQ(board.counters().corrupted, 0U);
}

}  // namespace
}  // namespace quickstrip::test
