#include "sim/seaway/questions.hpp"

#include <cmath>

#include "core/response/short_term.hpp"

namespace quickstrip::seaway {
namespace {

bool is_acceleration(Quantity quantity) {
  return quantity == Quantity::kLongitudinalAcceleration || quantity == Quantity::kLateralAcceleration ||
         quantity == Quantity::kVerticalAcceleration;
}

std::vector<double> levels_for(const std::vector<double>& given, const Levels& levels, double rms) {
  if (!given.empty()) {
    return given;
  }
  std::vector<double> out;
  for (const double p : levels.probabilities) {
    out.push_back(rms * std::sqrt(-2.0 * std::log(p)));
  }
  return out;
}

void add_both_sides(std::size_t c, const QuantityResponse& said, const std::vector<double>& at,
                    std::vector<StatedCount>& out) {
  for (const double level : at) {
    const double p = rayleigh_exceedance(level, said.rms * said.rms);
    out.push_back({{c, Passing::kBothSides, level, 0.0}, p, said.t2 > 0.0 ? 3600.0 / said.t2 * p : 0.0});
  }
}

}  // namespace

std::vector<StatedCount> questions_of(const Watch& watch, double speed, const Stated& stated,
                                      const Levels& levels) {
  std::vector<StatedCount> out;
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    const Channel& channel = watch.channels[c];
    const QuantityResponse& said = stated.quantities[c];
    const double level = level_at(channel, speed);
    constexpr double kStill = 1e-9;  // rad or m/s2
    if (channel.quantity == Quantity::kRoll && said.rms > kStill) {
      add_both_sides(c, said, levels_for(levels.roll, levels, said.rms), out);
    } else if (is_acceleration(channel.quantity) && said.rms > kStill) {
      add_both_sides(c, said, levels_for(levels.accelerations, levels, said.rms), out);
    } else if (channel.quantity == Quantity::kSlamming) {
      out.push_back(
          {{c, Passing::kReentry, level, channel.threshold_velocity}, said.probability, said.per_hour});
    } else if (channel.quantity == Quantity::kDeckWetness) {
      out.push_back({{c, Passing::kAbove, level, 0.0}, said.probability, said.per_hour});
    } else if (channel.quantity == Quantity::kPropellerEmergence) {
      out.push_back({{c, Passing::kReentry, level, 0.0}, said.probability, said.per_hour});
    }
  }
  return out;
}

std::vector<Question> only_questions(const std::vector<StatedCount>& counts) {
  std::vector<Question> out;
  for (const StatedCount& count : counts) {
    out.push_back(count.question);
  }
  return out;
}

}  // namespace quickstrip::seaway
