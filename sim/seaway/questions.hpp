// What is counted, and what the advisor states for it.
//
// Roll and accelerations: outward crossings of a level on either side; unless levels are given, those that
// the advisor's Rayleigh law reaches with the probabilities asked for. Slams and wet decks: at the level and
// threshold of the watch, as [Ochi1964] and deck_wetness.hpp mean them; the propeller's tip by its
// re-entries. Of a Gaussian process the crossings of a level per zero crossing are exp(-level^2 / 2 m0)
// whatever the bandwidth, and at one instant motion and velocity are independent: Ochi's product is exact for
// re-entries. What Rayleigh's law assumes beyond that is that a cycle has one crossing: the count of cycles
// with an event shows it.
#pragma once

#include <optional>
#include <vector>

#include "core/response/watch.hpp"
#include "sim/seaway/simulation.hpp"
#include "sim/seaway/stated.hpp"

namespace quickstrip::seaway {

struct Levels {
  std::vector<double> roll;           // rad; empty: by probability
  std::vector<double> accelerations;  // m/s2; empty: by probability
  std::vector<double> probabilities = {0.3, 0.1, 0.01, 0.001};
};

struct StatedCount {
  Question question;
  double probability = 0.0;  // per encounter
  double per_hour = 0.0;
};

/// Quantities that do not move are left out.
std::vector<StatedCount> questions_of(const Watch& watch, double speed, const Stated& stated,
                                      const Levels& levels);

std::vector<Question> only_questions(const std::vector<StatedCount>& counts);

}  // namespace quickstrip::seaway
