#include "core/response/roll_linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quickstrip {
namespace {

constexpr int kMostSteps = 12;
constexpr double kConverged = 1e-7;  // of ln b
// Slope of ln(damping called for) - ln(damping). Less roll calls for less damping, never in more than
// proportion: -1 to -2, but for rolls of two kinds, where more damping leaves the quicker one, which calls
// for more.
constexpr double kFirst = -1.5;
constexpr double kSteepest = -2.0;
constexpr double kFlattest = -0.2;
constexpr double kLeastShare = 1e-6;  // of a level: a model that gives nothing keeps its logarithm finite

double blend(const ByLevel& weight, const ByLevel& values) {
  return std::max(0.0, std::inner_product(weight.begin(), weight.end(), values.begin(), 0.0));
}

/// The added damping that the roll at `damping` calls for.
double called_for(const RollDampers& dampers, const RollVariances& at, double damping) {
  const ByLevel weight = level_weights(dampers.levels, damping);
  const double roll = blend(weight, at.roll);
  const double velocity = blend(weight, at.velocity);
  const double more = dampers.is_stabilised ? dampers.levels.stabiliser : 0.0;
  if (!(roll > 0.0) || !(velocity > 0.0)) {
    return more + dampers.factor * small_roll_damping(dampers.model, dampers.speed);
  }
  return more + dampers.factor * added_roll_damping_gaussian(dampers.model, dampers.speed, std::sqrt(roll),
                                                             std::sqrt(velocity / roll));
}

}  // namespace

ByLevel level_weights(const RollDampingLevels& levels, double damping) {
  ByLevel weight{};
  if (levels.count == 1) {
    weight[0] = 1.0;
    return weight;
  }
  ByLevel node{};
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    node[l] = 1.0 / (levels.own + levels.added[l]);
  }
  const double y = 1.0 / (levels.own + damping);
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    weight[l] = 1.0;
    for (std::size_t k = 0; k < kRollDampingLevels; ++k) {
      weight[l] *= k == l ? 1.0 : (y - node[k]) / (node[l] - node[k]);
    }
  }
  return weight;
}

LinearisedRoll linearise_roll(const RollDampers& dampers, const RollVariances& at,
                              const LinearisedRoll* near) {
  const RollDampingLevels& levels = dampers.levels;
  LinearisedRoll out{.damping = levels.added[0], .residual = 0.0, .slope = kFirst, .weight = {}};
  out.weight = level_weights(levels, out.damping);
  if (levels.count == 1) {
    out.damping = dampers.factor * levels.added[0];
    return out;
  }
  const auto excess = [&](double log_damping) {
    const double called = called_for(dampers, at, std::exp(log_damping));
    return std::log(std::max(called, kLeastShare * levels.added[1])) - log_damping;
  };
  // Not from one that was not found, nor from what is no number.
  const bool is_near = near != nullptr && near->damping > 0.0 && near->residual < kRollResidualLimit;
  double x = std::log(is_near ? near->damping : levels.added[1]);
  double f = excess(x);
  double slope = is_near ? near->slope : kFirst;
  for (int step = 0; step < kMostSteps && std::fabs(f) > kConverged; ++step) {
    const double next = x - f / slope;
    const double f_next = excess(next);
    if (next != x) {
      slope = std::clamp((f_next - f) / (next - x), kSteepest, kFlattest);
    }
    x = next;
    f = f_next;
  }
  out.damping = std::exp(x);
  out.residual = std::fabs(std::expm1(f));
  out.slope = slope;
  out.weight = level_weights(levels, out.damping);
  return out;
}

}  // namespace quickstrip
