#include "firmware/advisor/journal.hpp"

#include <cstdio>
#include <ctime>

#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

/// "2019-09-04T12:40:00Z"
struct UtcText {
  char text[32] = {};
  explicit UtcText(std::int64_t utime) {
    const std::time_t seconds = utime / 1'000'000;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts);
  }
};

/// By Input.
constexpr const char* kInputNames[kNumInputs] = {"SEA_STATE", "WAVE_SPECTRUM", "SEA_FORECAST",
                                                 "OWN_SHIP",  "LOADING",       "MOTION",
                                                 "TIME",      "QUERY",         "ALERT_ACK"};

const char* word(int verdict) {
  switch (verdict) {
    case 1:
      return "good";
    case 2:
      return "caution";
    case 3:
      return "limits exceeded";
    default:
      return "not known";
  }
}

}  // namespace

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
  const UtcText time(advice.utime);
  if (advice.no_advice != 0) {
    const std::string_view text = get_text(advice.no_advice_text);
    std::fprintf(stderr, "%s %.*s\n", time.text, static_cast<int>(text.size()), text.data());
    return;
  }
  const std::string_view text = get_text(advice.reasons_text);
  std::fprintf(stderr, "%s %s at %03.0f, %.1f kn (%s): %.*s\n", time.text, word(advice.verdict),
               advice.heading_deg, advice.speed_kn, sea_input == 1 ? "wave spectrum" : "sea state",
               static_cast<int>(text.size()), text.data());
}

void Journal::follow(const Inputs& inputs, std::int64_t utime) {
  std::int64_t num_refused = 0;
  const Conversion* last = nullptr;
  const char* channel = "";
  for (std::size_t i = 0; i < kNumInputs; ++i) {
    const InputCounters& counters = inputs.counters(static_cast<Input>(i));
    num_refused += counters.refused;
    if (counters.refused > 0) {
      last = &counters.last_refusal;
      channel = kInputNames[i];
    }
  }
  const bool is_first_of_many = num_refused_ == 0 && num_refused > 0;
  if (is_first_of_many) {  // the rest is counted in QS_HEALTH
    const UtcText time(utime);
    std::fprintf(stderr, "%s a message was refused: %s: %s%s%s; from here on counted in QS_HEALTH\n",
                 time.text, channel, last->field, last->field[0] != '\0' ? ": " : "", message(last->refusal));
  }
  num_refused_ = num_refused;
}

}  // namespace quickstrip
