#include "firmware/cortex-m7/serial/serial_session.hpp"

#include <algorithm>
#include <limits>

#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

constexpr double kSecondsPerMicrosecond = 1e-6;

double seconds(std::uint64_t us) {
  return static_cast<double>(us) * kSecondsPerMicrosecond;
}

std::uint32_t saturated(std::uint64_t us) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(us, kMost));
}

}  // namespace

Status SerialSession::configure(const Hull& hull, const Criteria& criteria, const SessionOptions& options) {
  const std::uint64_t start = board_.timer_us();
  const Status status = session_.configure(hull, criteria, options);
  report_.rebuild_us = saturated(board_.timer_us() - start);
  figures_.rebuild_last_s = seconds(report_.rebuild_us);
  return status;
}

void SerialSession::take(std::uint8_t byte) {
  if (decoder_.take(byte) == FrameDecoder::Event::kFrame) {
    take(decoder_.frame());
  }
}

void SerialSession::take(const Frame& frame) {
  switch (SerialChannel{frame.channel}) {
    case SerialChannel::kSeaState:
      return take_input(frame, Input::kSeaState, sea_state_);
    case SerialChannel::kOwnShip:
      return take_input(frame, Input::kOwnShip, own_ship_);
    case SerialChannel::kLoading:
      return take_input(frame, Input::kLoading, loading_);
    case SerialChannel::kTime:
      return take_time(frame);
    default:
      ++report_.unknown_channels;
  }
}

/// The newest is used, as on the bus: an older one that waits is dropped and counted.
template <typename Message>
void SerialSession::take_input(const Frame& frame, Input input, Newest<Message>& newest) {
  if (!decode(frame.data, newest.arriving)) {
    session_.count(input, {Refusal::kMalformed, "", -1});
    return;
  }
  if (newest.has_come) {
    ++figures_.dropped_before[static_cast<std::size_t>(input)];
  }
  newest.message = newest.arriving;
  newest.has_come = true;
}

void SerialSession::take_time(const Frame& frame) {
  if (!decode(frame.data, clock_)) {
    session_.count(Input::kTime, {Refusal::kMalformed, "", -1});
    return;
  }
  if (session_.accept(clock_).ok()) {
    cycle(clock_.utime);
  }
}

template <typename Message>
void SerialSession::accept(std::int64_t now, Newest<Message>& newest) {
  if (newest.has_come) {
    newest.has_come = false;
    static_cast<void>(session_.accept(newest.message, now));  // a refusal is counted and told
  }
}

void SerialSession::cycle(std::int64_t now) {
  const std::uint64_t start = board_.timer_us();
  if (figures_.started_utime == 0) {
    figures_.started_utime = now;
  }
  accept(now, sea_state_);
  accept(now, own_ship_);
  accept(now, loading_);
  session_.set_run_figures(figures_);
  session_.cycle(now, *this);
  note_cycle(board_.timer_us() - start);
  if (session_.is_rebuild_due()) {
    rebuild();
  }
  send_report();
}

void SerialSession::rebuild() {
  const std::uint64_t start = board_.timer_us();
  session_.rebuild();
  report_.rebuild_us = saturated(board_.timer_us() - start);
  figures_.rebuild_last_s = seconds(report_.rebuild_us);
}

void SerialSession::note_cycle(std::uint64_t us) {
  report_.cycle_us = saturated(us);
  all_cycles_us_ += us;
  ++num_cycles_;
  figures_.cycle_last_s = seconds(us);
  figures_.cycle_mean_s = seconds(all_cycles_us_) / num_cycles_;
  figures_.cycle_max_s = std::max(figures_.cycle_max_s, figures_.cycle_last_s);
}

bool SerialSession::send(OutChannel channel, std::span<const std::uint8_t> bytes) {
  const auto id = static_cast<std::uint8_t>(SerialChannel::kFirstOut) + static_cast<std::uint8_t>(channel);
  return send_frame(static_cast<std::uint8_t>(id), bytes, board_);
}

void SerialSession::send_report() {
  report_.good_frames = decoder_.counters().good;
  report_.corrupted_frames = decoder_.counters().corrupted;
  report_.too_long_frames = decoder_.counters().too_long;
  report_.lost_bytes = board_.lost_bytes();
  report_.stack_bytes = board_.stack_high_water();
  std::array<std::uint8_t, LineReport::kBytes> bytes{};
  std::size_t at = 0;
  for (const std::uint32_t number :
       {report_.good_frames, report_.corrupted_frames, report_.too_long_frames, report_.unknown_channels,
        report_.lost_bytes, report_.cycle_us, report_.rebuild_us, report_.stack_bytes}) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      bytes[at++] = static_cast<std::uint8_t>((number >> shift) & 0xFFu);
    }
  }
  static_cast<void>(send_frame(static_cast<std::uint8_t>(SerialChannel::kLineReport), bytes, board_));
}

}  // namespace quickstrip
