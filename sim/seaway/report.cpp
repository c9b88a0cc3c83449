#include "sim/seaway/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/angles.hpp"
#include "sim/seaway/report_words.hpp"

namespace quickstrip::seaway {
namespace {

constexpr const char* kFooter =
    "\nAn encounter is a cycle between zero up-crossings of the channel (of the relative motion for "
    "events);\n"
    "roll and accelerations count on both sides, a half cycle each, their rate is one side's. A slam is a\n"
    "re-entry faster than the threshold; a propeller's tip counts when it goes back in. Intervals: from the\n"
    "scatter between the blocks, which know nothing of each other (clusters included).\n";

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string out;
  for (const std::string& word : words) {
    out.append(out.empty() ? "" : between).append(word);
  }
  return out;
}

std::string number(double value) {
  return fmt::format("{:.10g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

// "value,low,high"; without an interval the last two are empty.
std::string with_interval(const std::vector<BlockCount>& blocks, double ratio) {
  const auto interval = ratio_interval(blocks);
  return interval ? fmt::format("{},{},{}", number(ratio), number(interval->low), number(interval->high))
                  : fmt::format("{},,", number(ratio));
}

double hours_of(const Answer& answer) {
  double sum = 0.0;
  for (const BlockCount& block : answer.per_hour) {
    sum += block.exposure;
  }
  return sum;
}

std::string channel_fields(const Report& r, std::size_t c) {
  const ChannelOutcome& got = r.outcome->channels[c];
  const QuantityResponse& said = r.stated->quantities[c];
  return fmt::format("{},{},{},{},{},{},{},{}", number(got.rms), number(got.rms_error), number(said.rms),
                     number(got.t2), number(said.t2), number(got.kurtosis), number(got.bandwidth),
                     number(got.largest));
}

bool is_counted(const Report& r, std::size_t channel) {
  return std::any_of(r.counts.begin(), r.counts.end(),
                     [&](const StatedCount& count) { return count.question.channel == channel; });
}

// In text angles are in degrees.
double shown(const Channel& channel) {
  return channel.quantity >= Quantity::kRoll && channel.quantity <= Quantity::kYaw ? degrees(1.0) : 1.0;
}

std::string heading_of(const Report& r) {
  std::string out = fmt::format("{}\n", r.circumstances);
  out += fmt::format("{:g} h in {} blocks of {:.1f} min, seed {}; {} waves a block; ", r.hours,
                     r.simulation->num_blocks, r.simulation->block_s / 60.0, r.seed,
                     r.simulation->answers.bin.size());
  if (r.roll) {
    const RollDampingLaw& law = r.simulation->law;
    out += fmt::format(
        "roll damping in time: ratio {:.4f} + {:.4f} per rad/s of roll rate; linearised: {:.4f}, roll RMS "
        "{:.3f} "
        "deg\n",
        law.linear / r.damping_unit, law.quadratic / r.damping_unit, r.roll->damping / r.damping_unit,
        degrees(r.roll->roll_rms));
  } else {
    out += "linear: exactly Gaussian\n";
  }
  if (!r.quality.empty()) {
    out += fmt::format("quality of the advisor's answer: {}\n", r.quality);
  }
  return out;
}

std::string channel_line(const Report& r, std::size_t c) {
  const Channel& channel = r.watch->channels[c];
  const ChannelOutcome& got = r.outcome->channels[c];
  const QuantityResponse& said = r.stated->quantities[c];
  const double unit = shown(channel);
  return fmt::format(
      "{:<26}{:<22}{:<6}{:>9.4g} ±{:<8.2g} {:>9.4g} {:>7.3f}{:>8.2f}{:>8.2f}{:>8.2f}{:>7.2f} {:>9.4g}\n",
      quantity_word(channel.quantity), place_words(channel, *r.hull),
      unit != 1.0 ? "deg" : unit_word(channel.quantity), unit * got.rms, unit * got.rms_error,
      unit * said.rms, said.rms > 0.0 ? got.rms / said.rms : 0.0, got.t2, said.t2, got.kurtosis,
      got.bandwidth, unit * got.largest);
}

std::string count_line(const Report& r, std::size_t i) {
  const StatedCount& said = r.counts[i];
  const Answer& answer = r.outcome->answers[i];
  const Channel& channel = r.watch->channels[said.question.channel];
  const double unit = shown(channel);
  const double ratio = answer.encounters > 0.0 ? answer.events / answer.encounters : 0.0;
  const auto interval = ratio_interval(answer.per_encounter);
  const double hours = hours_of(answer);
  return fmt::format(
      "{:<26}{:<22}{:>8.4g} {:<5}{:>9.0f}{:>8.0f}{:>10.5f} {:<21}{:>10.5f}{:>7}{:>10.3f}{:>10.3f}  {}\n",
      quantity_word(channel.quantity), place_words(channel, *r.hull), unit * said.question.level,
      unit != 1.0 ? "deg" : unit_word(channel.quantity), answer.encounters, answer.events, ratio,
      interval ? fmt::format("[{:.5f}, {:.5f}]", interval->low, interval->high) : std::string("[-]"),
      said.probability, said.probability > 0.0 ? fmt::format("{:.3f}", ratio / said.probability) : "-",
      hours > 0.0 ? answer.events / hours : 0.0, said.per_hour, joined(remarks_on(r, i), ", "));
}

// Where Rayleigh's law does not do, if it happened.
std::string explained(const Report& r) {
  bool shares_cycles = false;
  bool is_not_gaussian = false;
  for (std::size_t i = 0; i < r.counts.size(); ++i) {
    for (const std::string& remark : remarks_on(r, i)) {
      shares_cycles = shares_cycles || remark == kSeveralCrossings;
      is_not_gaussian = is_not_gaussian || remark == kNotGaussian;
    }
  }
  std::string out;
  if (shares_cycles) {
    out +=
        "several_crossings_a_cycle: the band is wide, crossings are as many as stated (Rice), but fewer"
        " cycles have one.\n";
  }
  if (is_not_gaussian) {
    out +=
        "not_gaussian: quadratic damping holds the largest rolls down (kurtosis below 3); Rayleigh's law"
        " with the right RMS\nstates too many of them, the more the rarer: on the safe side.\n";
  }
  return out;
}

}  // namespace

std::string csv_of(const Report& r) {
  std::string out =
      "quantity,where,unit,level,least_speed,encounters,events,probability,probability_low,probability_high,"
      "stated_probability,probability_of_cycles,per_hour,per_hour_low,per_hour_high,stated_per_hour,rms,"
      "rms_error,stated_rms,t2_s,stated_t2_s,kurtosis,bandwidth,largest,remarks\n";
  const auto begin = [&](std::size_t c) {
    const Channel& channel = r.watch->channels[c];
    return fmt::format("{},{},{},", quantity_word(channel.quantity), quoted(place_words(channel, *r.hull)),
                       unit_word(channel.quantity));
  };
  for (std::size_t c = 0; c < r.watch->channels.size(); ++c) {
    if (!is_counted(r, c)) {
      out += begin(c) + ",,,,,,,,,,,,," + channel_fields(r, c) + ",\n";
    }
  }
  for (std::size_t i = 0; i < r.counts.size(); ++i) {
    const StatedCount& said = r.counts[i];
    const Answer& a = r.outcome->answers[i];
    const double encounters = a.encounters;
    const double hours = hours_of(a);
    out += begin(said.question.channel) + number(said.question.level) + ",";
    out += said.question.passing == Passing::kReentry ? number(said.question.least_speed) + "," : ",";
    out += fmt::format("{},{},", number(encounters), number(a.events));
    out += with_interval(a.per_encounter, encounters > 0.0 ? a.events / encounters : 0.0) + ",";
    out += fmt::format("{},{},", number(said.probability),
                       number(encounters > 0.0 ? a.encounters_with_event / encounters : 0.0));
    out += with_interval(a.per_hour, hours > 0.0 ? a.events / hours : 0.0) + ",";
    out += fmt::format("{},{},{}\n", number(said.per_hour), channel_fields(r, said.question.channel),
                       joined(remarks_on(r, i), "+"));
  }
  return out;
}

std::string text_of(const Report& r) {
  std::string out = heading_of(r);
  out += fmt::format("\n{:<26}{:<22}{:<6}{:>9} {:<9} {:>9} {:>7}{:>8}{:>8}{:>8}{:>7} {:>9}\n", "quantity",
                     "where", "unit", "rms", "", "stated", "ratio", "T2 s", "stated", "kurt.", "width",
                     "largest");
  for (std::size_t c = 0; c < r.watch->channels.size(); ++c) {
    out += channel_line(r, c);
  }
  out += fmt::format("\n{:<26}{:<22}{:>14}{:>9}{:>8}{:>10} {:<21}{:>10}{:>7}{:>10}{:>10}  {}\n", "counted",
                     "where", "level", "encount.", "events", "P", "90 % interval", "stated", "ratio",
                     "per hour", "stated", "remarks");
  for (std::size_t i = 0; i < r.counts.size(); ++i) {
    out += count_line(r, i);
  }
  out += kFooter;
  out += explained(r);
  return out;
}

}  // namespace quickstrip::seaway
