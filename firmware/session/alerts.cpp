#include "firmware/session/alerts.hpp"

#include <algorithm>

#include "core/advice/advice.hpp"
#include "firmware/session/repeat.hpp"
#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr double kRepeat_s = 10.0;  // CHANNELS.md: an active alert is repeated
constexpr double kHour_s = 3600.0;
constexpr double kLateFor_s = 60.0;  // after the last cycle that took too long

std::size_t index(AlertId id) {
  return static_cast<std::size_t>(id) - 1;
}

}  // namespace

void Alerts::configure(std::int16_t source_id, double grace_s) {
  for (std::size_t i = 0; i < kNumAlerts; ++i) {
    alerts_[i] = alert_t{};
    alerts_[i].source_id = source_id;
    alerts_[i].alert_id = static_cast<std::int32_t>(i) + 1;
    alerts_[i].instance = 1;
    alerts_[i].criterion = -1;
  }
  put_text("Seakeeping limit", alerts_[index(AlertId::kLimit)].title);
  put_text("No seakeeping advice", alerts_[index(AlertId::kNoAdvice)].title);
  put_text("Motions not as predicted", alerts_[index(AlertId::kMotionGap)].title);
  put_text("Seakeeping advice is late", alerts_[index(AlertId::kLate)].title);
  sent_utime_.fill(0);
  sent_revision_.fill(0);
  first_utime_ = 0;
  num_misses_ = 0;
  last_miss_utime_ = 0;
  grace_s_ = grace_s;
  seq_ = 0;
}

void Alerts::change(alert_t& alert, std::int8_t state, std::int64_t now) {
  alert.state = state;
  alert.utime = now;
  ++alert.revision;
}

void Alerts::raise(alert_t& alert, std::int8_t priority, std::int64_t now) {
  const bool is_over = alert.state == alert_t::STATE_NORMAL || alert.state == alert_t::STATE_RECTIFIED;
  const bool is_worse = priority < alert.priority;  // the smaller number is the more urgent
  const bool is_other = priority != alert.priority;
  alert.priority = priority;
  if (is_over) {
    alert.raised_utime = now;
  }
  if (is_over || is_worse) {
    change(alert, alert_t::STATE_ACTIVE, now);
  } else if (is_other) {
    change(alert, alert.state, now);
  }
}

void Alerts::clear(alert_t& alert, std::int64_t now) {
  if (alert.state == alert_t::STATE_NORMAL || alert.state == alert_t::STATE_RECTIFIED) {
    return;
  }
  const bool must_be_seen =
      alert.priority == alert_t::PRIORITY_WARNING && alert.state != alert_t::STATE_ACKNOWLEDGED;
  change(alert, must_be_seen ? alert_t::STATE_RECTIFIED : alert_t::STATE_NORMAL, now);
}

void Alerts::follow(const advice_t& advice) {
  first_utime_ = first_utime_ == 0 ? advice.utime : first_utime_;
  alert_t& limit = alerts_[index(AlertId::kLimit)];
  alert_t& none = alerts_[index(AlertId::kNoAdvice)];
  if (advice.no_advice == static_cast<int>(NoAdvice::kLoadingChanged)) {
    return;  // the next cycle tells
  }
  if (advice.no_advice != 0) {
    const bool is_starting = !is_due_again(first_utime_, advice.utime, grace_s_);
    if (!is_starting) {
      put_text(get_text(advice.no_advice_text), none.text);
      raise(none, alert_t::PRIORITY_WARNING, advice.utime);
    }
    return;  // the alert on the limit stays as it is: nothing is known
  }
  clear(none, advice.utime);
  if (advice.verdict != advice_t::VERDICT_EXCEEDED && advice.verdict != advice_t::VERDICT_CAUTION) {
    clear(limit, advice.utime);
    return;
  }
  limit.criterion = advice.governing;
  limit.value = advice.governing < 0 ? 0.0 : advice.governing_value;
  limit.limit = advice.governing < 0 ? 0.0 : advice.governing_limit;
  put_text(get_text(advice.reasons_text), limit.text);
  const bool is_exceeded = advice.verdict == advice_t::VERDICT_EXCEEDED;
  raise(limit, is_exceeded ? alert_t::PRIORITY_WARNING : alert_t::PRIORITY_CAUTION, advice.utime);
}

void Alerts::follow(const comparison_t& comparison, std::int64_t now) {
  alert_t& gap = alerts_[index(AlertId::kMotionGap)];
  if (comparison.confidence != comparison_t::CONFIDENCE_LOWERED) {
    clear(gap, now);
    return;
  }
  int worst = 0;
  for (int i = 1; i < comparison.num_lines; ++i) {
    worst = comparison.gap_since_s[i] > comparison.gap_since_s[worst] ? i : worst;
  }
  Sentence text;
  text.add("For {:.0f} h {}. Less confidence in this advice", comparison.gap_since_s[worst] / kHour_s,
           get_text(comparison.text[worst]));
  put_text(text.view(), gap.text);
  raise(gap, alert_t::PRIORITY_CAUTION, now);
}

void Alerts::follow_misses(std::int64_t num_deadline_misses, std::int64_t now) {
  alert_t& late = alerts_[index(AlertId::kLate)];
  if (num_deadline_misses > num_misses_) {
    last_miss_utime_ = now;
    put_text("Cycles take longer than their period: advice comes late", late.text);
    raise(late, alert_t::PRIORITY_CAUTION, now);
  } else if (is_due_again(last_miss_utime_, now, kLateFor_s)) {
    clear(late, now);
  }
  num_misses_ = num_deadline_misses;
}

Conversion Alerts::accept(const alert_t& acknowledgement, std::int64_t now) {
  if (const Conversion checked = check_acknowledgement(acknowledgement); !checked) {
    return checked;
  }
  const bool is_known = acknowledgement.alert_id >= 1 &&
                        acknowledgement.alert_id <= static_cast<std::int32_t>(kNumAlerts) &&
                        acknowledgement.instance == 1;
  if (!is_known) {
    return {Refusal::kUnknownKind, "alert_id", -1};
  }
  const bool acknowledges = acknowledgement.state == alert_t::STATE_ACKNOWLEDGED;
  if (!acknowledges && acknowledgement.state != alert_t::STATE_SILENCED) {
    return {Refusal::kUnknownKind, "state", -1};
  }
  alert_t& alert = alerts_[static_cast<std::size_t>(acknowledgement.alert_id) - 1];
  if (acknowledgement.revision != alert.revision) {
    return {};  // of an alert that has changed since: the bridge must see the new one first
  }
  if (alert.state == alert_t::STATE_RECTIFIED && acknowledges) {
    change(alert, alert_t::STATE_NORMAL, now);
  } else if (alert.state == alert_t::STATE_ACTIVE ||
             (alert.state == alert_t::STATE_SILENCED && acknowledges)) {
    change(alert, acknowledges ? alert_t::STATE_ACKNOWLEDGED : alert_t::STATE_SILENCED, now);
  }
  return {};
}

const alert_t* Alerts::next_to_send(std::int64_t now) {
  for (std::size_t i = 0; i < kNumAlerts; ++i) {
    alert_t& alert = alerts_[i];
    const bool is_changed = alert.revision != sent_revision_[i];
    const bool is_due = alert.state != alert_t::STATE_NORMAL && is_due_again(sent_utime_[i], now, kRepeat_s);
    if (is_changed || is_due) {
      sent_revision_[i] = alert.revision;
      sent_utime_[i] = now;
      alert.seq = ++seq_;
      return &alert;
    }
  }
  return nullptr;
}

}  // namespace quickstrip
