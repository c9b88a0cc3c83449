// Two logs of one voyage, advised by two builds: how many messages are the same to the bit, how far the
// others are apart, and which verdicts differ.
//   compare_advice LOG OTHER [PREFIX]     exit 1 where a verdict differs or a number by more than a part in a
//   million
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "sim/replay/advice_log.hpp"

namespace quickstrip {
namespace {

// Of two mathematics libraries and orders of rounding, through some thousand sums: 1e-10 is expected. What a
// limit is compared with to 1e-6 is far below what a sea state is known to.
constexpr double kLargestDifference = 1e-6;

struct Differences {
  std::size_t num_advice = 0;
  std::size_t same_advice = 0;
  std::size_t same_grids = 0;
  std::size_t num_grids = 0;
  std::size_t verdicts = 0;
  std::size_t hazards = 0;
  std::size_t changes = 0;
  std::size_t cells = 0;
  std::size_t cell_verdicts = 0;
  std::size_t cell_margins = 0;  // by a step or more
  int largest_steps = 0;
  double margin = 0.0;
  double number = 0.0;  // of all, relative
};

template <typename Message>
bool same_bytes(const Message& a, const Message& b) {
  const auto bytes = [](const Message& message) {
    std::vector<std::uint8_t> encoded(static_cast<std::size_t>(message.getEncodedSize()));
    message.encode(encoded.data(), 0, static_cast<int>(encoded.size()));
    return encoded;
  };
  return bytes(a) == bytes(b);
}

/// NaN on one side alone is as far apart as can be.
double relative(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) {
    return 0.0;
  }
  const double difference = std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-9});
  return std::isnan(difference) ? HUGE_VAL : difference;
}

template <std::size_t N>
double largest_relative(const double (&a)[N], const double (&b)[N]) {
  double largest = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    largest = std::max(largest, relative(a[i], b[i]));
  }
  return largest;
}

bool same_changes(const advice_t& a, const advice_t& b) {
  return a.num_changes == b.num_changes && std::ranges::equal(a.change_verdict, b.change_verdict) &&
         std::ranges::equal(a.change_to_heading_deg, b.change_to_heading_deg) &&
         std::ranges::equal(a.change_to_speed_kn, b.change_to_speed_kn);
}

/// Of any number, relative; of the changes only where they are the same ones.
double largest_number(const advice_t& a, const advice_t& b) {
  double largest = largest_relative(a.criterion_value, b.criterion_value);
  for (const auto field :
       {&advice_t::margin, &advice_t::governing_value, &advice_t::roll_rms_deg,
        &advice_t::bridge_vertical_rms_m_s2, &advice_t::roll_exceedance, &advice_t::slam_probability,
        &advice_t::slams_per_hour, &advice_t::wetness_probability}) {
    largest = std::max(largest, relative(a.*field, b.*field));
  }
  if (!same_changes(a, b)) {
    return largest;
  }
  for (const auto field : {&advice_t::change_heading_deg, &advice_t::change_speed_kn,
                           &advice_t::change_effort, &advice_t::change_margin, &advice_t::change_roll_rms_deg,
                           &advice_t::change_bridge_vertical_rms_m_s2, &advice_t::change_roll_exceedance,
                           &advice_t::change_slam_probability, &advice_t::change_slams_per_hour,
                           &advice_t::change_wetness_probability, &advice_t::change_speed_loss_kn}) {
    largest = std::max(largest, largest_relative(a.*field, b.*field));
  }
  return largest;
}

void compare(const advice_t& a, const advice_t& b, Differences& found) {
  ++found.num_advice;
  found.same_advice += same_bytes(a, b) ? 1U : 0U;
  if (a.no_advice != b.no_advice || a.verdict != b.verdict || a.governing != b.governing) {
    ++found.verdicts;
    fmt::print("cycle {}: verdict {} and {}, governing {} and {}, margin {:.9g} and {:.9g}\n", a.seq,
               int{a.verdict}, int{b.verdict}, a.governing, b.governing, a.margin, b.margin);
  }
  found.hazards += a.hazards != b.hazards || a.quality != b.quality ? 1U : 0U;
  found.margin = std::max(found.margin, std::abs(a.margin - b.margin));
  found.changes += same_changes(a, b) ? 0U : 1U;
  found.number = std::max(found.number, largest_number(a, b));
}

void compare(const grid_t& a, const grid_t& b, Differences& found) {
  ++found.num_grids;
  found.same_grids += same_bytes(a, b) ? 1U : 0U;
  for (std::size_t s = 0; s < static_cast<std::size_t>(a.num_speeds); ++s) {
    for (std::size_t h = 0; h < static_cast<std::size_t>(a.num_headings); ++h) {
      const int steps = std::abs(a.margin[s][h] - b.margin[s][h]);
      ++found.cells;
      found.cell_verdicts += a.verdict[s][h] != b.verdict[s][h] ? 1U : 0U;
      found.cell_margins += steps > 0 ? 1U : 0U;
      found.largest_steps = std::max(found.largest_steps, steps);
    }
  }
}

std::vector<RecordedAdvice> read(const char* path, const char* prefix) {
  std::vector<RecordedAdvice> all;
  const auto status =
      read_advice_log(path, prefix, [&all](const RecordedAdvice& one) { all.push_back(one); });
  if (!status) {
    fmt::print(stderr, "compare_advice: {} holds no advice\n", path);
    std::exit(1);
  }
  return all;
}

int report(const Differences& found) {
  fmt::print("{} of {} advices and {} of {} grids are the same to the bit\n", found.same_advice,
             found.num_advice, found.same_grids, found.num_grids);
  fmt::print(
      "verdict or governing criterion differs in {} advices, hazard or quality bits in {}, changes in {}\n",
      found.verdicts, found.hazards, found.changes);
  fmt::print("largest difference of a margin {:.2g}, of any number {:.2g} of it\n", found.margin,
             found.number);
  fmt::print("of {} cells of the grids {} differ in verdict, {} in margin, by {} steps of 0.01 at most\n",
             found.cells, found.cell_verdicts, found.cell_margins, found.largest_steps);
  return found.verdicts == 0 && found.cell_verdicts == 0 && found.number < kLargestDifference ? 0 : 1;
}

}  // namespace
}  // namespace quickstrip

int main(int num_words, char** words) {
  if (num_words < 3) {
    fmt::print(stderr, "usage: compare_advice LOG OTHER [PREFIX]\n");
    return 2;
  }
  const char* prefix = num_words > 3 ? words[3] : "QS_";
  const auto one = quickstrip::read(words[1], prefix);
  const auto other = quickstrip::read(words[2], prefix);
  if (one.size() != other.size()) {
    fmt::print("{} advices and {}\n", one.size(), other.size());
    return 1;
  }
  quickstrip::Differences found;
  for (std::size_t i = 0; i < one.size(); ++i) {
    quickstrip::compare(one[i].advice, other[i].advice, found);
    quickstrip::compare(one[i].grid, other[i].grid, found);
  }
  return quickstrip::report(found);
}
