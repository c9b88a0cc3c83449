#include "sim/seaway/repeated_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/seaway/report_words.hpp"

namespace quickstrip::seaway {
namespace {

double share_of(const RepeatedCount& r) {
  return r.intervals > 0 ? static_cast<double>(r.holding) / static_cast<double>(r.intervals) : 0.0;
}

double ratio_of(const StatedCount& said, const RepeatedCount& r) {
  return said.probability > 0.0 ? r.probability() / said.probability : 0.0;
}

}  // namespace

std::vector<RepeatedCount> repeat_runs(Simulation& simulation, const Watch& watch,
                                       const std::vector<StatedCount>& counts, std::uint64_t first_seed,
                                       std::size_t runs, const std::function<void(std::size_t)>& on_run) {
  std::vector<RepeatedCount> out(counts.size());
  const std::vector<Question> questions = only_questions(counts);
  for (std::size_t r = 0; r < runs; ++r) {
    const Outcome outcome = run(simulation, watch, questions, first_seed + r);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const Answer& answer = outcome.answers[i];
      out[i].events += answer.events;
      out[i].encounters += answer.encounters;
      if (const auto interval = ratio_interval(answer.per_encounter)) {
        ++out[i].intervals;
        const double p = counts[i].probability;
        out[i].holding += p >= interval->low && p <= interval->high ? 1U : 0U;
      }
    }
    if (on_run) {
      on_run(r + 1);
    }
  }
  return out;
}

Coverage coverage_of(const std::vector<StatedCount>& counts, const std::vector<RepeatedCount>& repeated) {
  Coverage out;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!(counts[i].probability >= kLeastJudged && counts[i].probability <= kMostJudged)) {
      continue;
    }
    const double ratio = ratio_of(counts[i], repeated[i]);
    out.least_ratio = out.intervals == 0 ? ratio : std::min(out.least_ratio, ratio);
    out.most_ratio = std::max(out.most_ratio, ratio);
    out.intervals += repeated[i].intervals;
    out.holding += repeated[i].holding;
  }
  return out;
}

std::string csv_of(const Report& report, const std::vector<RepeatedCount>& repeated) {
  std::string out =
      "quantity,where,unit,level,least_speed,stated_probability,encounters,events,probability,ratio,"
      "intervals,holding\n";
  for (std::size_t i = 0; i < repeated.size(); ++i) {
    const StatedCount& said = report.counts[i];
    const Channel& channel = report.watch->channels[said.question.channel];
    const RepeatedCount& r = repeated[i];
    out += fmt::format("{},{},{},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{},{}\n",
                       quantity_word(channel.quantity), quoted(place_words(channel, *report.hull)),
                       unit_word(channel.quantity), said.question.level, said.question.least_speed,
                       said.probability, r.encounters, r.events, r.probability(), ratio_of(said, r),
                       r.intervals, r.holding);
  }
  return out;
}

std::string text_of(const Report& report, const std::vector<RepeatedCount>& repeated) {
  std::string out = report.circumstances;
  out += fmt::format("\n{:<26}{:<22}{:>10}{:>11}{:>11}{:>8}{:>10}\n", "counted", "where", "events",
                     "counted P", "stated", "ratio", "holding");
  for (std::size_t i = 0; i < repeated.size(); ++i) {
    const StatedCount& said = report.counts[i];
    const Channel& channel = report.watch->channels[said.question.channel];
    out += fmt::format("{:<26}{:<22}{:>10.0f}{:>11.5f}{:>11.5f}{:>8.3f}{:>8.1f} %\n",
                       quantity_word(channel.quantity), place_words(channel, *report.hull),
                       repeated[i].events, repeated[i].probability(), said.probability,
                       ratio_of(said, repeated[i]), 100.0 * share_of(repeated[i]));
  }
  const Coverage all = coverage_of(report.counts, repeated);
  out += fmt::format(
      "stated between 0.001 and 0.3: counted {:.3f} to {:.3f} times as often; {} of {} nominal 90 % "
      "intervals "
      "hold the\nstatement: {:.1f} %\n",
      all.least_ratio, all.most_ratio, all.holding, all.intervals, 100.0 * all.share());
  return out;
}

}  // namespace quickstrip::seaway
