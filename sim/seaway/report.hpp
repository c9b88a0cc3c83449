// What was counted beside what the advisor says: CSV in SI, and a text to read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/hull/hull.hpp"
#include "sim/seaway/equivalent_roll.hpp"
#include "sim/seaway/questions.hpp"

namespace quickstrip::seaway {

/// All of a run that is told.
struct Report {
  const Hull* hull = nullptr;
  const Watch* watch = nullptr;
  const Simulation* simulation = nullptr;
  const Stated* stated = nullptr;
  const Outcome* outcome = nullptr;
  std::vector<StatedCount> counts;  // in the order of the outcome's answers
  double hours = 0.0;
  std::uint64_t seed = 0;
  std::string circumstances;           // ship, sea, course and speed, in words
  std::string quality;                 // of the advisor's cell, in words
  std::optional<EquivalentRoll> roll;  // with roll stepped in time: what the advisor is given
  double damping_unit = 1.0;           // N m s of a damping ratio of 1
};

/// A row for every count, and one for every channel without.
std::string csv_of(const Report& report);

std::string text_of(const Report& report);

}  // namespace quickstrip::seaway
