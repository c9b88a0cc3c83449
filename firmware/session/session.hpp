// One session of the advisor: inputs come as messages, a cycle judges their ages, lets the core step, and
// hands the encoded answers to an outbox. The live process and the replay run this same code.
//
// Demands of its caller: one thread; time as an argument (microseconds since the epoch; the bridge's clock or
// a log's); after a cycle, `rebuild` when it is due. No heap after configure(), no bus, no clock, no file:
// the same messages in the same order at the same times give the same bytes. Memory about 8 MB: static.
// In the profile of capacities m7 it sends advice, limits, alerts, logbook and health only.
//
// A new loading: one cycle says "no advice, because the loading has changed", then the hull is rebuilt (well
// below a second), and the next cycle gives advice for it. A loading that the hull cannot float in gives no
// advice until a good one comes; the old one is not kept in its place.
// Cost of a cycle: the core's step plus some 0.3 ms of encoding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/advice/step.hpp"
#include "core/advisor.hpp"
#include "core/base/name.hpp"
#include "core/base/static_vector.hpp"
#include "core/strip/hull_table.hpp"
#include "core/strip/method.hpp"
#include "firmware/session/alerts.hpp"
#include "firmware/session/allow_list.hpp"
#include "firmware/session/inputs.hpp"
#include "firmware/session/large_messages.hpp"
#include "firmware/session/outbox.hpp"
#include "firmware/session/self_test.hpp"
#include "msgs/convert/encode.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/health_t.hpp"
#include "quickstrip/limits_t.hpp"
#include "quickstrip/logbook_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/sea_forecast_t.hpp"

namespace quickstrip {

struct SessionOptions {
  StaleAfter stale_after;
  AllowList allowed;
  StripMethod method;
  const HullTable* table = nullptr;  // compiled for the hull; must outlive the session; null: Lewis forms
  double cycle_period_s = 1.0;
  std::size_t ensemble_per_cycle = 0;  // members computed each cycle, 0 ... kEnsembleMembers
  std::int16_t source_id = 1;
  bool log_clock = false;  // said in health
  Name profile;            // of the criteria
  Name version;            // of the program
};

/// What only the process knows, for health; -1: not known. The session has no clock.
struct RunFigures {
  std::int64_t started_utime = 0;
  std::int64_t num_deadline_misses = 0;
  double cycle_last_s = -1.0;
  double cycle_mean_s = -1.0;
  double cycle_max_s = -1.0;
  double rebuild_last_s = -1.0;
  std::int64_t heap_calls_in_cycle = -1;
  std::int64_t page_faults = -1;
  std::int64_t resident_bytes = -1;
  std::int64_t num_refused_by_bus = 0;
  std::array<std::int64_t, kNumInputs> dropped_before{};  // by the receiver, by Input
  bool is_stopping = false;
};

class Session {
 public:
  /// Before configure(). `barge`: room for the ship of the known answer, the caller's own again afterwards.
  /// What fails stands in the way of advice for good: every cycle says so.
  SelfTestItem self_test(const HullTable* table, Hull& barge);
  void note_self_test(SelfTestItem failed) { self_test_failed_ = failed; }

  /// `hull` must outlive the session. Builds the transfer functions of the hull's default loading.
  Status configure(const Hull& hull, const Criteria& criteria, const SessionOptions& options);

  Conversion accept(const sea_state_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const wave_spectrum_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const own_ship_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const loading_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  /// Answered in the next cycle.
  Conversion accept(const query_t& message, std::int64_t now);
  Conversion accept(const alert_t& acknowledgement, std::int64_t now);
  /// Compared with what was predicted, in the next cycle.
  Conversion accept(const motion_t& message, std::int64_t now);
  /// Checked and counted; not used yet.
  Conversion accept(const sea_forecast_t& message, std::int64_t now);
  /// The caller's clock with log time: a cycle may run at its utime only if this is ok.
  Conversion accept(const clock_t& message);
  /// For what the session does not see: bytes that do not decode, messages of senders who are not allowed.
  void count(Input input, const Conversion& conversion, std::int64_t num = 1);
  void set_run_figures(const RunFigures& figures) { figures_ = figures; }

  /// The limits are others than before the start: told on QS_LOGBOOK in the next cycle, once. `author` may be
  /// empty. The session knows neither files nor what was before: text is the caller's.
  void note_limits_change(std::string_view author, std::string_view text);

  /// Health at once, outside of a cycle: that the session is about to start, or to stop. Nothing when `now`
  /// is 0.
  void announce(std::int64_t now, Outbox& outbox);

  /// `now` between 1970 and 2200 (is_time); may be before that of the last cycle.
  void cycle(std::int64_t now, Outbox& outbox);
  /// For a replay that follows a recorded run from its middle: the next cycle is number `seq`.
  void number_next_cycle(std::int32_t seq) { cycle_ = seq - 1; }

  [[nodiscard]] bool is_rebuild_due() const { return advisor_.is_rebuild_due(); }
  /// Call after the cycle that said so. A refusal is told by the next cycles.
  void rebuild();

  [[nodiscard]] const advice_t& advice() const { return advice_; }
  [[nodiscard]] const grid_t& grid() const;  // not in the profile m7
  [[nodiscard]] const limits_t& limits() const { return limits_; }
  /// What the core gave in the last cycle; nullptr before the first and after a rebuild.
  [[nodiscard]] const StepOutput* output() const { return output_; }
  [[nodiscard]] const Inputs& inputs() const { return inputs_; }
  /// Of the hull, the loading in force and the hull table, as advice carries it.
  [[nodiscard]] std::int64_t digest_of_hull() const { return hull_digest_; }

 private:
  void set_digest_of_hull(const Loading& loading);
  bool admits(Input input, std::int16_t source_id);
  Conversion count_measured(Input input, const Conversion& conversion, std::int64_t utime, std::int64_t now);
  Fitness judge(std::int64_t now, Input& sea_in_force) const;
  const StepOutput& step(std::int64_t now, const Fitness& fitness, Input sea_in_force);
  void fill_advice(std::int64_t now, const StepOutput& output, const Fitness& fitness, Input sea_in_force);
  void send_limits(std::int64_t now, Outbox& outbox);
  void send_limits_change(std::int64_t now, Outbox& outbox);
  // session_large.cpp; in the profile m7 they do nothing, session_small.cpp
  void forget_predicted();
  void send_grid(std::int64_t now, Outbox& outbox);
  void send_responses(std::int64_t now, Outbox& outbox);
  void answer(const Query& query, std::int64_t now, Outbox& outbox);
  void send_outlook(std::int64_t now, Outbox& outbox);
  void send_comparison(std::int64_t now, Outbox& outbox);
  void send_alerts(std::int64_t now, Outbox& outbox);
  void send_health(std::int64_t now, Outbox& outbox);
  void send_health_when_due(std::int64_t now, Outbox& outbox);
  [[nodiscard]] std::int8_t state() const;
  template <typename Message>
  void send(OutChannel channel, const Message& message, Outbox& outbox);
  template <typename Message>
  void stamp(Message& message, std::int64_t now) const;

  Advisor advisor_;
  const Hull* hull_ = nullptr;
  Criteria criteria_;
  SessionOptions options_;
  Inputs inputs_;
  Alerts alerts_;
  StaticVector<Query, 8> queries_;
  StatedUncertainty uncertainty_;       // of the last cycle
  const StepOutput* output_ = nullptr;  // the advisor's
  std::int64_t hull_digest_ = 0;
  std::int64_t table_checksum_ = 0;

  advice_t advice_{};
  limits_t limits_{};
  logbook_t limits_change_{};
  health_t health_{};
  LargeMessages large_;
  std::array<std::uint8_t, kSessionBufferBytes> bytes_{};

  bool is_limits_change_due_ = false;
  bool is_comparison_due_ = false;
  SelfTestItem self_test_failed_ = SelfTestItem::kNone;
  std::int32_t cycle_ = 0;
  std::int32_t response_seq_ = 0;
  std::int64_t limits_sent_ = 0;
  std::int64_t health_sent_ = 0;
  std::int64_t publish_failures_ = 0;
  RunFigures figures_;
};

template <typename Message>
void Session::stamp(Message& message, std::int64_t now) const {
  message.utime = now;
  message.seq = cycle_;
  message.source_id = options_.source_id;
}

template <typename Message>
void Session::send(OutChannel channel, const Message& message, Outbox& outbox) {
  const std::span<const std::uint8_t> bytes = encode(message, bytes_);
  if (bytes.empty() || !outbox.send(channel, bytes)) {
    ++publish_failures_;
  }
}

}  // namespace quickstrip
