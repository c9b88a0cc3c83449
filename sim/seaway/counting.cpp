// The loop over the blocks: series, crossings, sums.
#include <algorithm>
#include <cmath>

#include "sim/seaway/crossings.hpp"
#include "sim/seaway/simulation.hpp"

namespace quickstrip::seaway {
namespace {

struct ChannelSums {
  std::vector<double> mean_square;  // by block
  double fourth = 0.0;
  double zeros = 0.0;
  double crests = 0.0;
  double largest = 0.0;
};

// Turns of a channel in one block, and its zero crossings upwards and downwards.
struct Passages {
  std::vector<Rise> rises;
  std::vector<Crossing> up;
  std::vector<Crossing> down;
};

void make_series(const Simulation& s, const Watch& watch, const BinAmplitudes& block, Fourier& fourier,
                 Series& out) {
  std::vector<Complex> first;
  std::vector<Complex> second;
  const std::size_t count = watch.channels.size();
  for (std::size_t c = 0; c < count; c += 2) {
    channel_amplitudes(s.answers, block, watch.channels[c], s.answers.wave_row[c], first);
    if (c + 1 == count) {
      fourier.series(first, {}, out[c], {});
      break;
    }
    channel_amplitudes(s.answers, block, watch.channels[c + 1], s.answers.wave_row[c + 1], second);
    fourier.series(first, second, out[c], out[c + 1]);
  }
}

void add_block(std::span<const double> x, const Passages& zeros, ChannelSums& out) {
  double square = 0.0;
  double fourth = 0.0;
  for (const double value : x) {
    const double v2 = value * value;
    square += v2;
    fourth += v2 * v2;
    out.largest = std::max(out.largest, std::fabs(value));
  }
  const auto n = static_cast<double>(x.size());
  out.mean_square.push_back(square / n);
  out.fourth += fourth / n;
  out.zeros += static_cast<double>(zeros.up.size());
  out.crests += static_cast<double>(zeros.rises.size());
}

// Events on one side, those too slow left out.
void count_side(std::span<const Crossing> zeros, std::vector<Crossing>& events, const Question& question,
                Answer& answer, BlockCount& block) {
  if (question.passing == Passing::kReentry) {
    std::erase_if(events, [&](const Crossing& c) { return c.speed < question.least_speed; });
  }
  block.events += static_cast<double>(events.size());
  block.exposure += static_cast<double>(zeros.size());
  answer.encounters_with_event += static_cast<double>(encounters_with_event(zeros, events));
}

void count(std::span<const double> x, double dt, double hours, const Question& question,
           const Passages& zeros, std::vector<Crossing>& events, Answer& answer) {
  BlockCount block;
  const bool both = question.passing == Passing::kBothSides;
  const double level = question.passing == Passing::kReentry ? -question.level : question.level;
  list_crossings(x, zeros.rises, dt, level, 1.0, events);
  count_side(zeros.up, events, question, answer, block);
  if (both) {
    list_crossings(x, zeros.rises, dt, level, -1.0, events);
    count_side(zeros.down, events, question, answer, block);
  }
  answer.events += block.events;
  answer.encounters += block.exposure;
  answer.per_encounter.push_back(block);
  answer.per_hour.push_back({block.events, both ? 2.0 * hours : hours});
}

ChannelOutcome outcome_of(const ChannelSums& sums, double block_s) {
  const auto n = static_cast<double>(sums.mean_square.size());
  double mean = 0.0;
  for (const double square : sums.mean_square) {
    mean += square / n;
  }
  double scatter = 0.0;
  for (const double square : sums.mean_square) {
    scatter += (square - mean) * (square - mean);
  }
  ChannelOutcome out;
  out.rms = std::sqrt(mean);
  if (mean > 0.0) {
    out.rms_error = n > 1.0 ? 0.5 * std::sqrt(scatter / (n * (n - 1.0))) / out.rms : 0.0;
    out.kurtosis = sums.fourth / n / (mean * mean);
  }
  out.t2 = sums.zeros > 0.0 ? n * block_s / sums.zeros : 0.0;
  if (sums.crests > 0.0) {
    out.bandwidth = std::sqrt(std::max(0.0, 1.0 - std::pow(sums.zeros / sums.crests, 2)));
  }
  out.largest = sums.largest;
  return out;
}

}  // namespace

Outcome run(Simulation& simulation, const Watch& watch, std::span<const Question> questions,
            std::uint64_t seed, const OnBlock& on_block) {
  Fourier fourier(simulation.num_samples);
  BinAmplitudes block;
  Series series(watch.channels.size(), std::vector<double>(simulation.num_samples));
  std::vector<ChannelSums> sums(watch.channels.size());
  std::vector<Passages> zeros(watch.channels.size());
  std::vector<Crossing> events;
  Outcome out;
  out.answers.resize(questions.size());
  for (std::size_t b = 0; b < simulation.num_blocks; ++b) {
    make_block(simulation, seed, b, block);
    make_series(simulation, watch, block, fourier, series);
    for (std::size_t c = 0; c < series.size(); ++c) {
      list_rises(series[c], zeros[c].rises);
      list_crossings(series[c], zeros[c].rises, simulation.dt(), 0.0, 1.0, zeros[c].up);
      list_crossings(series[c], zeros[c].rises, simulation.dt(), 0.0, -1.0, zeros[c].down);
      add_block(series[c], zeros[c], sums[c]);
    }
    for (std::size_t q = 0; q < questions.size(); ++q) {
      const std::size_t c = questions[q].channel;
      count(series[c], simulation.dt(), simulation.block_s / 3600.0, questions[q], zeros[c], events,
            out.answers[q]);
    }
    if (on_block) {
      on_block(b, series);
    }
  }
  for (const ChannelSums& s : sums) {
    out.channels.push_back(outcome_of(s, simulation.block_s));
  }
  return out;
}

}  // namespace quickstrip::seaway
