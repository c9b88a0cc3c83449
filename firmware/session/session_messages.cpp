// What a session sends: each message filled, stamped, encoded into the one static buffer, handed over.
#include <algorithm>
#include <span>

#include "firmware/session/repeat.hpp"
#include "firmware/session/session.hpp"
#include "msgs/convert/advice_message.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kLimitsEvery_s = 10.0;  // contract §5
constexpr double kHealthEvery_s = 1.0;   // contract §5
constexpr double kSlack_s = 0.05;        // a cycle that comes a little early still counts as due
constexpr double kValidForCycles = 3.0;  // an advice is not shown after two cycles have been missed

std::int64_t after(std::int64_t now, double seconds) {
  return now + static_cast<std::int64_t>(seconds * kMicrosecondsPerSecond);
}

/// Why the core gave no advice although the session found its inputs fit.
NoAdviceDetail core_detail(const StepOutput& output, const OwnShip& ship) {
  NoAdviceDetail detail;
  if (output.advice.no_advice == NoAdvice::kSpeedOutsideGrid && output.grid.num_speeds > 0) {
    detail.speed = ship.speed;
    detail.grid_from = output.grid.speeds[0];
    detail.grid_to = output.grid.speeds[output.grid.num_speeds - 1];
  }
  return detail;
}

}  // namespace

void Session::fill_advice(std::int64_t now, const StepOutput& output, const Fitness& fitness,
                          Input sea_in_force) {
  AdviceContext context;
  context.utime = now;
  context.seq = cycle_;
  context.source_id = options_.source_id;
  context.valid_until_utime = after(now, kValidForCycles * options_.cycle_period_s);
  context.limits_digest = limits_.digest;
  context.hull_digest = hull_digest_;
  context.hull_name = hull_->name.view();
  context.profile_name = options_.profile.view();
  for (const Input input : {sea_in_force, Input::kOwnShip, Input::kLoading}) {
    context.inputs[static_cast<std::size_t>(input)] = inputs_.used(input);
  }
  if (inputs_.motion(now) != nullptr) {
    context.inputs[static_cast<std::size_t>(Input::kMotion)] = inputs_.used(Input::kMotion);
  }
  context.sea_assumptions = sea_in_force == Input::kSeaState ? inputs_.sea_state().assumed : 0;
  context.systems = std::span(output.systems).first(output.num_systems);
  Advice advice = output.advice;
  if (inputs_.own_ship(now).ok()) {  // where the ship goes is known even when there is no advice on it
    context.speed_kind = speed_kind(inputs_.ship().ship);
    advice.heading = inputs_.ship().ship.heading;
    advice.speed = inputs_.ship().ship.speed;
  }
  const bool is_ours = fitness.reason == output.advice.no_advice;
  context.no_advice = is_ours ? fitness.detail : core_detail(output, inputs_.ship().ship);
  to_message(advice, output.grid, criteria_, context, advice_);
  if (!seal(advice_, bytes_)) {
    ++publish_failures_;
  }
}

void Session::send_limits(std::int64_t now, Outbox& outbox) {
  if (!is_due_again(limits_sent_, now, kLimitsEvery_s - kSlack_s)) {
    return;
  }
  limits_.utime = limits_.utime == 0 ? now : limits_.utime;  // since when they are in force
  limits_sent_ = now;
  send(OutChannel::kLimits, limits_, outbox);
}

void Session::send_limits_change(std::int64_t now, Outbox& outbox) {
  if (!is_limits_change_due_) {
    return;
  }
  is_limits_change_due_ = false;
  limits_change_.utime = now;
  ++limits_change_.seq;
  limits_change_.source_id = options_.source_id;
  send(OutChannel::kLogbook, limits_change_, outbox);
}

void Session::send_alerts(std::int64_t now, Outbox& outbox) {
  alerts_.follow(advice_);
  alerts_.follow_misses(figures_.num_deadline_misses, now);
  for (std::size_t i = 0; i < Alerts::kNumAlerts; ++i) {
    const alert_t* const alert = alerts_.next_to_send(now);
    if (alert == nullptr) {
      return;
    }
    send(OutChannel::kAlert, *alert, outbox);
  }
}

void Session::send_health_when_due(std::int64_t now, Outbox& outbox) {
  if (is_due_again(health_sent_, now, kHealthEvery_s - kSlack_s)) {
    send_health(now, outbox);
  }
}

void Session::announce(std::int64_t now, Outbox& outbox) {
  if (now != 0) {
    send_health(now, outbox);
  }
}

std::int8_t Session::state() const {
  if (self_test_failed_ != SelfTestItem::kNone) {
    return health_t::STATE_FAULT;
  }
  if (figures_.is_stopping) {
    return health_t::STATE_STOPPING;
  }
  if (cycle_ == 0) {
    return health_t::STATE_STARTING;
  }
  if (advisor_.is_rebuild_due()) {
    return health_t::STATE_REBUILDING;
  }
  return advice_.no_advice == 0 ? health_t::STATE_RUNNING : health_t::STATE_NO_ADVICE;
}

// One column of fields: longer than other functions for that reason alone.
void Session::send_health(std::int64_t now, Outbox& outbox) {
  health_sent_ = now;
  health_.utime = now;
  ++health_.seq;
  health_.source_id = options_.source_id;
  health_.state = state();
  health_.clock = options_.log_clock ? 1 : 0;
  health_.no_advice = advice_.no_advice;
  health_.started_utime = figures_.started_utime;
  health_.num_cycles = cycle_;
  health_.num_deadline_misses = figures_.num_deadline_misses;
  health_.cycle_period_s = options_.cycle_period_s;
  health_.cycle_last_s = figures_.cycle_last_s;
  health_.cycle_mean_s = figures_.cycle_mean_s;
  health_.cycle_max_s = figures_.cycle_max_s;
  health_.rebuild_last_s = figures_.rebuild_last_s;
  for (std::size_t i = 0; i < kNumInputs; ++i) {
    const auto input = static_cast<Input>(i);
    const InputCounters& counters = inputs_.counters(input);
    health_.input_age_s[i] = inputs_.age_s(input, now);
    health_.input_stale_after_s[i] = inputs_.stale_after_s(input);
    health_.input_received[i] = counters.received;
    health_.input_refused[i] = counters.refused;
    health_.input_last_refusal[i] = static_cast<std::int16_t>(counters.last_refusal.refusal);
    health_.input_dropped[i] = counters.dropped + figures_.dropped_before[i];
  }
  health_.publish_failures = publish_failures_ + figures_.num_refused_by_bus;
  health_.heap_calls_in_cycle = figures_.heap_calls_in_cycle;
  health_.page_faults = figures_.page_faults;
  health_.resident_bytes = figures_.resident_bytes;
  put_text(options_.version.view(), health_.version);
  put_text(hull_->name.view(), health_.hull_name);
  health_.hull_digest = hull_digest_;
  health_.table_checksum = table_checksum_;
  health_.limits_digest = limits_.digest;
  send(OutChannel::kHealth, health_, outbox);
}

}  // namespace quickstrip
