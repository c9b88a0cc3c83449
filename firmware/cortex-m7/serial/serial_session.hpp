// A session at the end of a serial line: bytes in, bytes out. The board and the host build of the same
// profile run this same code. No heap, no clock: a cycle runs at the time of each QS_TIME (FRAMING.md).
//
// Frames that are corrupted or of an unknown channel are counted and told in a line report; bytes that do not
// decode as the channel's type are counted as refused by the session, as on the bus. Static: 10 kB and the
// session.
#pragma once

#include <cstdint>

#include "firmware/cortex-m7/serial/channels.hpp"
#include "firmware/cortex-m7/serial/framing.hpp"
#include "firmware/session/session.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/sea_state_t.hpp"

namespace quickstrip {

/// The machine under the session.
class Board : public ByteSink {
 public:
  /// A timer of any origin [us].
  virtual std::uint64_t timer_us() = 0;
  virtual std::uint32_t stack_high_water() { return 0; }
  virtual std::uint32_t lost_bytes() { return 0; }
};

class SerialSession final : public Outbox {
 public:
  explicit SerialSession(Board& board) : board_(board) {}

  /// As Session's, before configure(); a table in flash is checked when it is opened.
  SelfTestItem self_test(Hull& barge) { return session_.self_test(nullptr, barge); }

  /// As Session's; the cycle period is what valid_until is counted in.
  Status configure(const Hull& hull, const Criteria& criteria, const SessionOptions& options);

  /// May run a cycle, and a rebuild behind it.
  void take(std::uint8_t byte);

  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override;

  [[nodiscard]] const LineReport& report() const { return report_; }
  [[nodiscard]] const Session& session() const { return session_; }

 private:
  /// The newest message of a kind that came since the last cycle.
  template <typename Message>
  struct Newest {
    Message message{};
    Message arriving{};  // one that does not decode leaves the other as it was
    bool has_come = false;
  };
  void take(const Frame& frame);
  template <typename Message>
  void take_input(const Frame& frame, Input input, Newest<Message>& newest);
  void take_time(const Frame& frame);
  template <typename Message>
  void accept(std::int64_t now, Newest<Message>& newest);
  void cycle(std::int64_t now);
  void rebuild();
  void note_cycle(std::uint64_t us);
  void send_report();

  Board& board_;
  FrameDecoder decoder_;
  Session session_;
  RunFigures figures_;
  LineReport report_;
  std::uint64_t all_cycles_us_ = 0;
  std::uint32_t num_cycles_ = 0;
  Newest<sea_state_t> sea_state_;
  Newest<own_ship_t> own_ship_;
  Newest<loading_t> loading_;
  clock_t clock_{};
};

}  // namespace quickstrip
