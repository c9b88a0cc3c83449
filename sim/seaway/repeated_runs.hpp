// The same run with one seed after the other: how often the intervals hold what the advisor states, and the
// count of all runs together. A nominal 90 % interval that holds the true value in 85 to 95 % of the cases is
// a good one; runs long enough show every error of the statement as well.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/seaway/report.hpp"

namespace quickstrip::seaway {

/// Of one count.
struct RepeatedCount {
  double events = 0.0;
  double encounters = 0.0;
  std::size_t intervals = 0;  // runs with an interval
  std::size_t holding = 0;    // of them, hold the stated probability

  [[nodiscard]] double probability() const { return encounters > 0.0 ? events / encounters : 0.0; }
};

/// By count; seeds first_seed, first_seed + 1, ... `on_run`: after each, how many are done.
std::vector<RepeatedCount> repeat_runs(Simulation& simulation, const Watch& watch,
                                       const std::vector<StatedCount>& counts, std::uint64_t first_seed,
                                       std::size_t runs, const std::function<void(std::size_t)>& on_run = {});

/// Where probabilities and intervals are judged.
inline constexpr double kLeastJudged = 0.0009;
inline constexpr double kMostJudged = 0.31;

/// Of all counts stated within the range above.
struct Coverage {
  std::size_t intervals = 0;
  std::size_t holding = 0;
  double least_ratio = 0.0;  // counted over stated, all runs together
  double most_ratio = 0.0;

  [[nodiscard]] double share() const {
    return intervals > 0 ? static_cast<double>(holding) / static_cast<double>(intervals) : 0.0;
  }
};
Coverage coverage_of(const std::vector<StatedCount>& counts, const std::vector<RepeatedCount>& repeated);

/// CSV or text; of `report` the ship, the watch, the counts and the circumstances are read.
std::string csv_of(const Report& report, const std::vector<RepeatedCount>& repeated);
std::string text_of(const Report& report, const std::vector<RepeatedCount>& repeated);

}  // namespace quickstrip::seaway
