#include "sim/seaway/report_words.hpp"

#include <cmath>

#include "sim/hull_tool/quantity_name.hpp"

namespace quickstrip::seaway {
namespace {

constexpr double kFactor = 1.25;       // that counts and statements should agree within
constexpr double kFewEvents = 10.0;    // the interval is wider than the factor
constexpr double kSameCycle = 0.95;    // of the events have a cycle of their own
constexpr double kKurtosisOff = 0.15;  // of 3: beyond the scatter of some hundred hours

}  // namespace

const char* quantity_word(Quantity quantity) {
  return hull_tool::name_of(quantity).name;
}

const char* unit_word(Quantity quantity) {
  return hull_tool::name_of(quantity).unit;
}

std::string place_words(const Channel& channel, const Hull& hull) {
  return hull_tool::place_of(channel.quantity, channel.place, hull);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string out = "\"";
  for (const char c : text) {
    out.append(c == '"' ? "\"\"" : std::string(1, c));
  }
  return out.append("\"");
}

std::vector<std::string> remarks_on(const Report& report, std::size_t count) {
  const Answer& answer = report.outcome->answers[count];
  const StatedCount& said = report.counts[count];
  const ChannelOutcome& channel = report.outcome->channels[said.question.channel];
  std::vector<std::string> out;
  if (answer.events < kFewEvents) {
    out.emplace_back("few_events");
  }
  if (const auto interval = ratio_interval(answer.per_encounter)) {
    const bool is_outside = said.probability < interval->low || said.probability > interval->high;
    const double most = kFactor * said.probability;
    if (is_outside) {
      out.emplace_back("outside_interval");
    }
    if (is_outside && (interval->ratio > most || interval->ratio * kFactor < said.probability)) {
      out.emplace_back("beyond_factor_1.25");
    }
  }
  if (answer.encounters_with_event < kSameCycle * answer.events) {
    out.emplace_back(kSeveralCrossings);
  }
  if (report.roll && std::fabs(channel.kurtosis - 3.0) > kKurtosisOff) {
    out.emplace_back(kNotGaussian);
  }
  return out;
}

}  // namespace quickstrip::seaway
