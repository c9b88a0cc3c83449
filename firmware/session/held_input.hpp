// The last valid message of one kind, and whether it may still be used.
//
// Rules: a message that its converter refuses, or from the future (by more than a tolerance), is refused and
// counted, and what is held stays. A message measured before the one held is overtaken: counted as dropped.
// A message may be repeated unchanged. Ages are taken from the time of measurement. What is held and lies in
// the future (the clock was set back, a log was started again) counts as missing and gives way to whatever
// comes. No heap, no clock: the time is an argument, microseconds since the epoch.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "msgs/convert/advice_message.hpp"
#include "msgs/convert/refusal.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {

/// What health tells of one input.
struct InputCounters {
  std::int64_t received = 0;
  std::int64_t refused = 0;
  std::int64_t dropped = 0;  // overtaken by a newer one before use
  Conversion last_refusal;

  void count(const Conversion& conversion, std::int64_t num = 1) {
    received += num;
    if (!conversion.ok() && num > 0) {
      refused += num;
      last_refusal = conversion;
    }
  }
};

/// May an input be used now? reason kNone: yes; else why not, for the sentence.
struct Fitness {
  NoAdvice reason = NoAdvice::kNone;
  NoAdviceDetail detail{};
  [[nodiscard]] bool ok() const { return reason == NoAdvice::kNone; }
};

/// How an input fails, in the words of the advice.
struct FitnessReasons {
  NoAdvice missing = NoAdvice::kInternal;
  NoAdvice stale = NoAdvice::kInternal;
  NoAdvice implausible = NoAdvice::kInternal;  // nothing valid is held, and something came and was refused
};

template <typename Message, typename Value>
class HeldInput {
 public:
  void forget() {
    use_ = InputUse::kNone;
    counters_ = {};
  }
  void hold_default(const Value& value) {
    value_ = value;
    use_ = InputUse::kDefault;
  }

  /// `convert(message, out)` returns a Conversion; `out` is a scratch value, so that a refused message does
  /// not touch the held one.
  template <typename Convert>
  Conversion accept(const Message& message, std::int64_t now, InputUse use, double future_tolerance_s,
                    const Convert& convert) {
    Conversion conversion = convert(message, scratch_);
    if (conversion.ok() && !(seconds_between(message.utime, now) >= -future_tolerance_s)) {
      conversion = {Refusal::kFromTheFuture, "utime", -1};
    }
    counters_.count(conversion);
    if (!conversion.ok()) {
      return conversion;
    }
    const bool is_held_usable = is_measured() && seconds_between(message_.utime, now) >= -future_tolerance_s;
    if (is_held_usable && message.utime < message_.utime) {
      ++counters_.dropped;
      return {};
    }
    message_ = message;
    value_ = scratch_;
    use_ = use;
    return {};
  }

  /// `limit_s`: the age above which it is stale.
  [[nodiscard]] Fitness fitness(std::int64_t now, double limit_s, double future_tolerance_s,
                                const FitnessReasons& reasons) const {
    if (use_ == InputUse::kDefault) {
      return {};  // holds until a message replaces it
    }
    Fitness unfit;
    const double age = seconds_between(message_.utime, now);
    if (use_ == InputUse::kNone || !(age >= -future_tolerance_s)) {
      unfit.reason = counters_.last_refusal.ok() ? reasons.missing : reasons.implausible;
      unfit.detail.refusal = counters_.last_refusal.refusal;
      unfit.detail.field = counters_.last_refusal.field;
      return unfit;
    }
    if (!(age <= limit_s)) {
      unfit.reason = reasons.stale;
      unfit.detail.age_s = age;
      unfit.detail.limit_s = limit_s;
      return unfit;
    }
    return {};
  }

  [[nodiscard]] bool is_measured() const { return use_ == InputUse::kLive || use_ == InputUse::kRestored; }
  [[nodiscard]] const Message& message() const { return message_; }
  [[nodiscard]] const Value& value() const { return value_; }
  [[nodiscard]] const InputCounters& counters() const { return counters_; }
  InputCounters& counters() { return counters_; }
  [[nodiscard]] UsedInput used() const {
    return is_measured() ? UsedInput{use_, message_.source_id, message_.seq, message_.utime}
                         : UsedInput{use_, 0, 0, 0};
  }
  /// -1: never received.
  [[nodiscard]] double age_s(std::int64_t now) const {
    return is_measured() ? std::max(0.0, seconds_between(message_.utime, now)) : -1.0;
  }

 private:
  Message message_{};
  Value value_{};
  Value scratch_{};
  InputUse use_ = InputUse::kNone;
  InputCounters counters_;
};

/// In the place of a HeldInput that a profile of capacities has no room for: nothing comes, nothing is held.
template <typename Message, typename Value>
class AbsentInput {
 public:
  void forget() { counters_ = {}; }
  template <typename Convert>
  Conversion accept(const Message& /*message*/, std::int64_t /*now*/, InputUse /*use*/,
                    double /*future_tolerance_s*/, const Convert& /*convert*/) {
    const Conversion conversion{Refusal::kNotReady, "", -1};
    counters_.count(conversion);
    return conversion;
  }
  [[nodiscard]] Fitness fitness(std::int64_t /*now*/, double /*limit_s*/, double /*future_tolerance_s*/,
                                const FitnessReasons& reasons) const {
    return {.reason = reasons.missing};
  }
  [[nodiscard]] bool is_measured() const { return false; }
  [[nodiscard]] const Message& message() const { return kNoMessage; }
  [[nodiscard]] const Value& value() const { return kNoValue; }
  [[nodiscard]] const InputCounters& counters() const { return counters_; }
  [[nodiscard]] UsedInput used() const { return {InputUse::kNone, 0, 0, 0}; }

 private:
  static constexpr Message kNoMessage{};  // constants: they cost flash, not RAM
  static constexpr Value kNoValue{};
  InputCounters counters_;
};

}  // namespace quickstrip
