#include "firmware/advisor/journal.hpp"

#include <algorithm>

#include "msgs/convert/text.hpp"

namespace quickstrip {

void Journal::follow(const advice_t& advice) {
  const int sea_input = advice.input_use[1] != 0 ? 1 : 0;
  const bool is_same =
      has_line_ && advice.no_advice == no_advice_ && advice.verdict == verdict_ && sea_input == sea_input_;
  if (is_same) {
    return;
  }
  has_line_ = true;
  no_advice_ = advice.no_advice;
  verdict_ = advice.verdict;
  sea_input_ = sea_input;
  JournalRecord record;
  record.kind = advice.no_advice != 0 ? JournalRecord::Kind::kNoAdvice : JournalRecord::Kind::kAdvice;
  record.is_spectrum = sea_input == 1;
  record.utime = advice.utime;
  record.verdict = advice.verdict;
  record.heading_deg = advice.heading_deg;
  record.speed_kn = advice.speed_kn;
  const std::string_view text =
      advice.no_advice != 0 ? get_text(advice.no_advice_text) : get_text(advice.reasons_text);
  std::copy_n(text.begin(), std::min(text.size(), record.text.size() - 1), record.text.begin());
  ring_.push(record);
}

void Journal::follow(const Inputs& inputs, std::int64_t utime) {
  if (has_refused_) {
    return;  // the rest is counted in QS_HEALTH
  }
  for (std::size_t i = 0; i < kNumInputs; ++i) {
    const InputCounters& counters = inputs.counters(static_cast<Input>(i));
    if (counters.refused > 0) {
      has_refused_ = true;
      JournalRecord record;
      record.kind = JournalRecord::Kind::kRefusal;
      record.utime = utime;
      record.input = i;
      record.refusal = counters.last_refusal;
      ring_.push(record);
      return;
    }
  }
}

void Journal::follow(MissedDeadlines& missed, double steady_s) {
  if (missed.is_due(steady_s)) {
    note(missed);
    missed.note_told(steady_s);
  }
}

void Journal::note(const MissedDeadlines& missed) {
  if (missed.num() == 0) {
    return;
  }
  JournalRecord record;
  record.kind = JournalRecord::Kind::kMissed;
  record.utime = missed.worst().utime;
  record.missed = missed.worst();
  record.num_missed = missed.num();
  ring_.push(record);
}

}  // namespace quickstrip
