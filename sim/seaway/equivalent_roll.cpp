#include "sim/seaway/equivalent_roll.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"

namespace quickstrip::seaway {
namespace {

constexpr std::size_t kRollRow = 3;

// Variance of roll by bin, base damping included.
std::vector<double> roll_spectrum(const WaveAnswers& answers, std::size_t num_bins) {
  std::vector<double> out(num_bins);
  for (std::size_t i = 0; i < answers.bin.size(); ++i) {
    const auto re = static_cast<double>(answers.re[i * answers.num_rows + kRollRow]);
    const auto im = static_cast<double>(answers.im[i * answers.num_rows + kRollRow]);
    if (answers.bin[i] < num_bins) {
      out[answers.bin[i]] += re * re + im * im;
    }
  }
  return out;
}

EquivalentRoll roll_at(const Simulation& s, const std::vector<double>& spectrum, double damping) {
  EquivalentRoll out{.damping = damping};
  for (std::size_t n = 0; n < spectrum.size(); ++n) {
    const double omega = s.answers.step * static_cast<double>(n);
    const Complex update = 1.0 + Complex(0.0, omega * (damping - s.base_damping)) * s.roll_answer[n];
    const double variance = spectrum[n] / std::norm(update);
    out.roll_rms += variance;
    out.rate_rms += omega * omega * variance;
  }
  out.roll_rms = std::sqrt(out.roll_rms);
  out.rate_rms = std::sqrt(out.rate_rms);
  return out;
}

}  // namespace

namespace {

// Least squares of b(a) = b1 + (8 / 3 pi) omega a b2, amplitudes weighted as a Gaussian roll's are by energy:
// a^3 exp(-a^2 / 2 rms^2).
RollDampingLaw fitted_law(const RollDampingModel& model, double speed, double rms, double omega) {
  constexpr int kAmplitudes = 30;
  constexpr double kLargest = 3.0;  // RMS
  double sum = 0.0;
  double sum_a = 0.0;
  double sum_aa = 0.0;
  double sum_b = 0.0;
  double sum_ab = 0.0;
  for (int i = 1; i <= kAmplitudes; ++i) {
    const double of_rms = kLargest * i / kAmplitudes;
    const double a = of_rms * rms;
    const double weight = std::pow(of_rms, 3) * std::exp(-0.5 * of_rms * of_rms);
    const double b = added_roll_damping(model, speed, a, omega);
    sum += weight;
    sum_a += weight * a;
    sum_aa += weight * a * a;
    sum_b += weight * b;
    sum_ab += weight * a * b;
  }
  const double slope = (sum * sum_ab - sum_a * sum_b) / (sum * sum_aa - sum_a * sum_a);
  RollDampingLaw law;
  law.quadratic = std::max(0.0, slope * 3.0 * kPi / (8.0 * omega));
  law.linear = (sum_b - law.quadratic * 8.0 * omega / (3.0 * kPi) * sum_a) / sum;
  return law;
}

}  // namespace

EquivalentRoll equivalent_roll(const Simulation& simulation) {
  QS_CHECK(simulation.memory.has_value());
  const std::vector<double> spectrum = roll_spectrum(simulation.answers, simulation.roll_answer.size());
  const RollDampingLaw& law = simulation.law;
  const double factor = std::sqrt(8.0 / kPi) * law.quadratic;
  double low = law.linear;
  double high = law.linear + factor * roll_at(simulation, spectrum, law.linear).rate_rms;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double wanted = law.linear + factor * roll_at(simulation, spectrum, middle).rate_rms;
    (middle < wanted ? low : high) = middle;
  }
  return roll_at(simulation, spectrum, 0.5 * (low + high));
}

RollDampingModel law_model(const RollDampingLaw& law, double natural_frequency) {
  RollDampingModel out = constant_roll_damping(law.linear, natural_frequency);
  if (law.quadratic > 0.0) {
    constexpr double kNothing = 1e-30;  // N m s^1.5; above zero: damping goes with the amplitude
    out.friction = kNothing;
    out.keel_normal_1 = 8.0 / (3.0 * kPi) * law.quadratic;  // per omega and amplitude
  }
  return out;
}

EquivalentRoll fit_roll_law(const RollDampingModel& model, double speed, Simulation& simulation) {
  simulation.law = {.linear = small_roll_damping(model, speed)};
  EquivalentRoll roll = equivalent_roll(simulation);
  constexpr int kRounds = 12;      // a contraction: damping grows by less than roll falls
  constexpr double kStill = 1e-6;  // rad: less is rounding, to which nothing can be fitted
  for (int i = 0; i < kRounds && roll.roll_rms > kStill; ++i) {
    simulation.law = fitted_law(model, speed, roll.roll_rms, roll.rate_rms / roll.roll_rms);
    roll = equivalent_roll(simulation);
  }
  return roll;
}

}  // namespace quickstrip::seaway
