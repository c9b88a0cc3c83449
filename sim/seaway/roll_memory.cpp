#include "sim/seaway/roll_memory.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"

namespace quickstrip::seaway {
namespace {

// One degree of freedom: (c + i omega b - omega^2 I) phi = M.
struct Oscillator {
  double inertia = 0.0;
  double damping = 0.0;
  double stiffness = 0.0;

  [[nodiscard]] double natural() const { return std::sqrt(stiffness / inertia); }
  [[nodiscard]] double decay() const { return 0.5 * damping / inertia; }
  [[nodiscard]] Complex answer(double omega) const {
    return 1.0 / Complex(stiffness - omega * omega * inertia, omega * damping);
  }
  // Of the velocity to a unit impulse, t >= 0; underdamped.
  [[nodiscard]] double velocity(double t) const {
    const double turning = std::sqrt(natural() * natural() - decay() * decay());
    return std::exp(-decay() * t) * (std::cos(turning * t) - decay() / turning * std::sin(turning * t)) /
           inertia;
  }
};

Oscillator reference_of(std::span<const Complex> answer, double step) {
  const double highest = step * static_cast<double>(answer.size() - 1);
  Oscillator out;
  out.stiffness = (1.0 / answer[1]).real();
  out.inertia = (out.stiffness - (1.0 / answer.back()).real()) / (highest * highest);
  QS_CHECK(out.stiffness > 0.0 && out.inertia > 0.0);
  const auto bin = static_cast<std::size_t>(std::lround(out.natural() / step));
  QS_CHECK(bin > 0 && bin < answer.size());
  const double damping = (1.0 / answer[bin]).imag() / (step * static_cast<double>(bin));
  // Between 2 % and half of critical: anything will do, only the rest must be smooth.
  const double critical = 2.0 * out.inertia * out.natural();
  out.damping = std::clamp(damping, 0.02 * critical, 0.5 * critical);
  return out;
}

}  // namespace

RollMemory::RollMemory(std::span<const Complex> roll_answer, double step, double base_damping)
    : fourier_(2 * roll_answer.size()),
      step_(step),
      dt_(kTwoPi / step / static_cast<double>(2 * roll_answer.size())),
      base_damping_(base_damping) {
  const Oscillator reference = reference_of(roll_answer, step);
  const std::size_t n = fourier_.num_samples();
  std::vector<Complex> rest(n / 2);
  for (std::size_t k = 1; k < rest.size(); ++k) {
    const double omega = step * static_cast<double>(k);
    rest[k] = step / kPi * Complex(0.0, omega) * (roll_answer[k] - reference.answer(omega));
  }
  std::vector<double> in_time(n);
  fourier_.series(rest, {}, in_time, {});
  constexpr double kForgotten = 10.0;  // e^-10 = 5e-5 of an impulse is left
  const double length = kForgotten / reference.decay() / dt_;
  kernel_.resize(std::min(n / 2, static_cast<std::size_t>(std::ceil(length))));
  for (std::size_t j = 0; j < kernel_.size(); ++j) {
    kernel_[j] = in_time[j] + (j == 0 ? 0.5 : 1.0) * reference.velocity(static_cast<double>(j) * dt_);
  }
  memory_.resize(n + 2 * kernel_.size());
}

void RollMemory::step_through(std::span<const double> velocity, const RollDampingLaw& law,
                              std::span<double> moment) {
  const std::size_t n = num_samples();
  const std::size_t taps = kernel_.size();
  QS_CHECK(velocity.size() == n && moment.size() == n);
  std::fill(memory_.begin(), memory_.end(), 0.0);
  const double beyond = law.linear - base_damping_;
  const double present = dt_ * kernel_[0];
  const double p = 1.0 + present * beyond;
  const double q = present * law.quadratic;
  QS_CHECK(p > 0.0 && q >= 0.0);
  for (std::size_t j = 0; j < n + taps; ++j) {
    const std::size_t i = (j + n - taps) % n;  // the start-up is the end of the block
    // p v + q |v| v = r: v has the sign of r.
    const double r = velocity[i] + dt_ * memory_[j];
    const double v = 2.0 * r / (p + std::sqrt(p * p + 4.0 * q * std::fabs(r)));
    const double m = -beyond * v - law.quadratic * std::fabs(v) * v;
    moment[i] = m;
    double* const later = memory_.data() + j;
    for (std::size_t k = 1; k < taps; ++k) {
      later[k] += kernel_[k] * m;
    }
  }
}

void RollMemory::solve(std::span<const Complex> roll_amplitudes, const RollDampingLaw& law,
                       std::span<Complex> moment) {
  const std::size_t n = num_samples();
  std::vector<Complex> rate(std::min(n / 2, roll_amplitudes.size()));
  for (std::size_t k = 0; k < rate.size(); ++k) {
    rate[k] = Complex(0.0, step_ * static_cast<double>(k)) * roll_amplitudes[k];
  }
  std::vector<double> velocity(n);
  std::vector<double> moment_in_time(n);
  fourier_.series(rate, {}, velocity, {});
  step_through(velocity, law, moment_in_time);
  fourier_.amplitudes(moment_in_time, moment.first(std::min(moment.size(), n / 2)));
}

}  // namespace quickstrip::seaway
