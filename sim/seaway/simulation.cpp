#include "sim/seaway/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/check.hpp"
#include "core/strip/roll_admittance.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip::seaway {
namespace {

constexpr double kBlocksOfShortRun = 16.0;
constexpr double kShortestBlock_h = 0.25;
constexpr double kFinestSampling = 0.3;  // omega dt of the quickest channel, omega of its zeros
constexpr double kRollSampling = 0.16;   // omega dt of roll in the stepping
constexpr double kBaseRatio = 0.15;      // of critical: a short kernel; the law takes it back
constexpr double kRollBand = 8.0;        // of the natural frequency: harmonics of quadratic damping
constexpr std::size_t kMostSamples = 1U << 20U;
constexpr std::size_t kMostCellValues = 200'000'000;  // 1.6 GB

std::size_t power_of_two_from(double least) {
  std::size_t n = 64;
  while (static_cast<double>(n) < least) {
    n *= 2;
  }
  return n;
}

void cut_into_blocks(double hours, Simulation& out) {
  const double short_run = std::min(kBlocksOfShortRun, std::max(1.0, std::floor(hours / kShortestBlock_h)));
  const double blocks = std::max(std::ceil(hours), short_run);
  out.num_blocks = static_cast<std::size_t>(blocks);
  out.block_s = 3600.0 * hours / blocks;
}

// What the ship answers to a roll moment at the bins. Near zero frequency the ratios of sway and yaw are
// those of the lowest frequency at which coefficients are known.
void list_roll_answers(const LoadedHull& hull, double speed, std::size_t num_bins, Simulation& out) {
  const double step = out.answers.step;
  const double lowest = 0.05 * std::sqrt(hull.gravity / hull.lpp);
  out.roll_answer.resize(num_bins);
  out.sway_per_roll.resize(num_bins);
  out.yaw_per_roll.resize(num_bins);
  for (std::size_t n = 0; n < num_bins; ++n) {
    const double omega = std::max(lowest, step * static_cast<double>(n));
    const RollAdmittance answer = roll_admittance(hull, omega, speed);
    out.roll_answer[n] = answer.roll();
    out.sway_per_roll[n] = answer.sway_per_roll;
    out.yaw_per_roll[n] = answer.yaw_per_roll;
  }
}

void prepare_roll(const LoadedHull& hull, const Plan& plan, Simulation& out) {
  const double natural = hull.roll_natural_frequency;
  const std::size_t samples =
      std::min(out.num_samples, power_of_two_from(out.block_s * natural / kRollSampling));
  list_roll_answers(hull, plan.speed, samples / 2, out);
  out.base_damping = reference_roll_damping(hull.roll_damping, plan.speed);
  out.law = {.linear = out.base_damping};
  out.memory.emplace(out.roll_answer, out.answers.step, out.base_damping);
  const auto band = static_cast<std::size_t>(std::ceil(kRollBand * natural / out.answers.step));
  out.answers.num_bins = std::max(out.answers.num_bins, std::min(band, samples / 2));
}

double quickest(const WaveAnswers& answers, const Watch& watch) {
  double out = 0.0;
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    const SpectralMoments m = channel_moments(answers, watch.channels[c], answers.wave_row[c]);
    out = m.m0 > 0.0 ? std::max(out, std::sqrt(m.m2 / m.m0)) : out;
  }
  return out;
}

// Roll, sway and yaw of the moment that the damping law adds.
void add_roll_moment(Simulation& s, BinAmplitudes& block) {
  constexpr std::size_t kSway = 1;
  constexpr std::size_t kRoll = 3;
  constexpr std::size_t kYaw = 5;
  const std::size_t bins = std::min(block.num_bins(), s.roll_answer.size());
  std::vector<Complex> roll(bins);
  for (std::size_t n = 0; n < bins; ++n) {
    roll[n] = block.value(n, kRoll);
  }
  std::vector<Complex> moment(bins);
  s.memory->solve(roll, s.law, moment);
  for (std::size_t n = 0; n < bins; ++n) {
    const Complex answer = s.roll_answer[n] * moment[n];
    block.add(n, kRoll, answer);
    block.add(n, kSway, s.sway_per_roll[n] * answer);
    block.add(n, kYaw, s.yaw_per_roll[n] * answer);
  }
}

}  // namespace

Result<Simulation> prepare(const LoadedHull& hull, const Watch& watch, const Beams& sea, const Plan& plan) {
  if (!(plan.hours > 0.0 && plan.hours <= kMostHours)) {
    return Error::kOutOfRange;
  }
  Simulation out;
  cut_into_blocks(plan.hours, out);
  CellGrid grid{.heading = plan.heading, .speed = plan.speed, .gravity = hull.gravity};
  grid.step = kTwoPi / out.block_s;
  grid.widest_cell = 0.04 * std::sqrt(hull.gravity / hull.lpp);
  const double bins = highest_encounter(sea, grid) / grid.step;
  const double values = 10.0 * bins * static_cast<double>(sea.beams.size());
  if (!(2.2 * bins < static_cast<double>(kMostSamples) && values < static_cast<double>(kMostCellValues))) {
    return Error::kTooMany;
  }
  const auto ship = std::make_unique<LoadedHull>(hull);
  if (plan.steps_roll) {
    ship->roll_damping =
        constant_roll_damping(ratio_roll_damping(hull, kBaseRatio), hull.roll_natural_frequency);
  }
  const std::vector<WaveCell> cells = wave_cells(sea, grid);
  Result<WaveAnswers> answers = wave_answers(*ship, watch, sea, grid, cells);
  if (!answers) {
    return answers.error();
  }
  out.answers = std::move(*answers);
  const double samples = std::max(2.1 * bins, out.block_s * quickest(out.answers, watch) / kFinestSampling);
  out.num_samples = power_of_two_from(samples);
  if (out.num_samples > kMostSamples) {
    return Error::kTooMany;
  }
  if (plan.steps_roll) {
    prepare_roll(*ship, plan, out);
  }
  return out;
}

void make_block(Simulation& simulation, std::uint64_t seed, std::size_t block, BinAmplitudes& out) {
  Gaussian random(seed, block);
  draw_block(simulation.answers, random, out);
  if (simulation.memory) {
    add_roll_moment(simulation, out);
  }
}

}  // namespace quickstrip::seaway
