// Roll damping in time, against the linear equations, harmonic balance and the decay of free roll.
#include "sim/seaway/roll_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/base/constants.hpp"
#include "core/strip/roll_admittance.hpp"
#include "sim/seaway/gaussian.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::seaway {
namespace {

constexpr std::size_t kSamples = 8192;
constexpr double kDuration = 3600.0;
constexpr double kStep = kTwoPi / kDuration;

// One degree of freedom: period 2 pi / 0.4 = 15.7 s.
struct Pendulum {
  double inertia = 2.0;
  double natural = 0.4;
  double ratio = 0.15;
  [[nodiscard]] double damping() const { return 2.0 * ratio * inertia * natural; }
  [[nodiscard]] std::vector<Complex> answers() const {
    std::vector<Complex> out(kSamples / 2);
    for (std::size_t n = 0; n < out.size(); ++n) {
      const double w = kStep * static_cast<double>(n);
      out[n] = 1.0 / Complex(inertia * (natural * natural - w * w), w * damping());
    }
    return out;
  }
};

// The S-175 at 15 kn with 0.15 of critical added: memory, sway and yaw included.
std::vector<Complex> ship_answers(double& natural, double& base) {
  const auto hull = std::make_unique<Hull>(test::s175());
  const auto loaded = std::make_unique<LoadedHull>();
  EXPECT_TRUE(load(*hull, hull->loading, {}, *loaded).ok());
  set_roll_damping_ratio(*loaded, 0.15);
  natural = loaded->roll_natural_frequency;
  base = ratio_roll_damping(*loaded, 0.15);
  std::vector<Complex> out(kSamples / 2);
  for (std::size_t n = 0; n < out.size(); ++n) {
    out[n] = roll_admittance(*loaded, std::max(0.01, kStep * static_cast<double>(n)), 7.7).roll();
  }
  return out;
}

// Roll of one frequency with so much linear damping in time, against the rank-one update.
Complex updated(Complex roll, Complex answer, double omega, double added) {
  return roll / (1.0 + Complex(0.0, omega * added) * answer);
}

Complex stepped(RollMemory& memory, std::size_t bin, Complex roll, Complex answer,
                const RollDampingLaw& law) {
  std::vector<Complex> linear(kSamples / 2);
  linear[bin] = roll;
  std::vector<Complex> moment(kSamples / 2);
  memory.solve(linear, law, moment);
  return roll + answer * moment[bin];
}

TEST(RollMemory, KernelIsTheImpulseResponse) {
  const Pendulum pendulum;
  const RollMemory memory(pendulum.answers(), kStep, pendulum.damping());
  const double turning = pendulum.natural * std::sqrt(1.0 - pendulum.ratio * pendulum.ratio);
  for (std::size_t j = 1; j < memory.kernel_length(); ++j) {
    const double t = memory.dt() * static_cast<double>(j);
    const double decay = pendulum.ratio * pendulum.natural;
    const double exact = std::exp(-decay * t) *
                         (std::cos(turning * t) - decay / turning * std::sin(turning * t)) / pendulum.inertia;
    EXPECT_NEAR(memory.kernel()[j], exact, 1e-4 / pendulum.inertia);
  }
}

TEST(RollMemory, LinearDampingInTimeIsTheRankOneUpdate) {
  double natural = 0.0;
  double base = 0.0;
  const std::vector<Complex> answers = ship_answers(natural, base);
  RollMemory memory(answers, kStep, base);
  for (const double ratio : {0.02, 0.05, 0.3}) {
    const double damping = base * ratio / 0.15;
    for (const double frequency : {0.5, 0.9, 1.0, 1.1, 2.0}) {
      const auto bin = static_cast<std::size_t>(std::lround(frequency * natural / kStep));
      const double omega = kStep * static_cast<double>(bin);
      const Complex exact = updated(0.1, answers[bin], omega, damping - base);
      const Complex got = stepped(memory, bin, 0.1, answers[bin], {damping, 0.0});
      // The trapezoidal rule errs by (omega dt)^2 / 12 = 0.2 % of the base damping; with a seventh of it left
      // at resonance that is 1 % of roll.
      EXPECT_NEAR(std::abs(got - exact) / std::abs(exact), 0.0, ratio < 0.03 ? 0.012 : 0.005)
          << ratio << " at " << frequency;
    }
  }
}

// Harmonic balance: quadratic damping is 8/(3 pi) omega a b2 of linear damping at amplitude a.
TEST(RollMemory, QuadraticDampingInARegularWaveIsThatOfHarmonicBalance) {
  const Pendulum pendulum;
  const std::vector<Complex> answers = pendulum.answers();
  RollMemory memory(answers, kStep, pendulum.damping());
  const auto bin = static_cast<std::size_t>(std::lround(pendulum.natural / kStep));
  const double omega = kStep * static_cast<double>(bin);
  const RollDampingLaw law{0.2 * pendulum.damping(), 3.0 * pendulum.damping()};
  const Complex roll = stepped(memory, bin, 0.3, answers[bin], law);
  const double equivalent = law.linear + 8.0 / (3.0 * kPi) * omega * std::abs(roll) * law.quadratic;
  const Complex exact = updated(0.3, answers[bin], omega, equivalent - pendulum.damping());
  EXPECT_NEAR(std::abs(roll) / std::abs(exact), 1.0, 0.01);  // the third harmonic is 0.5 % of the motion
}

// After a push, with quadratic damping alone, 1/amplitude grows by 4/(3 pi) (b2/I) omega a second.
TEST(RollMemory, FreeRollDecaysAsQuadraticDampingHasIt) {
  const Pendulum pendulum;
  RollMemory memory(pendulum.answers(), kStep, pendulum.damping());
  // The linear pendulum's velocity after an impulse at t = 300 s; it is at rest when the block begins.
  constexpr double kPush = 0.5;
  std::vector<double> velocity(kSamples);
  const auto start = static_cast<std::size_t>(300.0 / memory.dt());
  for (std::size_t j = 0; j < memory.kernel_length(); ++j) {
    velocity[start + j] = (j == 0 ? 2.0 : 1.0) * kPush * memory.kernel()[j];
  }
  const double quadratic = 0.6;  // b2, same unit as the inertia
  std::vector<double> moment(kSamples);
  const RollDampingLaw law{0.0, quadratic};
  memory.step_through(velocity, law, moment);
  // M = base v - b2 |v| v tells v.
  const auto velocity_of = [&](std::size_t j) {
    const double b = pendulum.damping();
    double v = moment[j] / b;
    for (int i = 0; i < 50; ++i) {
      v = (moment[j] + quadratic * std::fabs(v) * v) / b;
    }
    return v;
  };
  std::vector<double> crest;
  std::vector<double> when;
  for (std::size_t j = start + 2; j + 1 < start + 600; ++j) {
    const double before = velocity_of(j - 1);
    const double here = velocity_of(j);
    const double after = velocity_of(j + 1);
    if (here > before && here >= after && here > 0.0) {
      crest.push_back(here + (after - before) * (after - before) / (8.0 * (2.0 * here - before - after)));
      when.push_back(memory.dt() * static_cast<double>(j));
    }
  }
  ASSERT_GT(crest.size(), 8U);
  // In velocity: d(1/v)/dt = 4/(3 pi) b2/I.
  const std::size_t last = crest.size() - 1;
  const double growth = (1.0 / crest[last] - 1.0 / crest[1]) / (when[last] - when[1]);
  EXPECT_NEAR(growth / (4.0 / (3.0 * kPi) * quadratic / pendulum.inertia), 1.0, 0.03);  // slowly varying
}

// Over a block the power that damping takes is that which the waves' moment brings: with no net moment there
// is none.
TEST(RollMemory, EnergyIsBalanced) {
  const Pendulum pendulum;
  const std::vector<Complex> answers = pendulum.answers();
  RollMemory memory(answers, kStep, pendulum.damping());
  Gaussian random(4, 0);
  std::vector<Complex> excitation(kSamples / 2);  // moment of the waves
  std::vector<Complex> linear(kSamples / 2);
  for (std::size_t n = 100; n < 500; ++n) {
    const Gaussian::Pair p = random.pair();
    excitation[n] = 0.01 * Complex(p.first, p.second);
    linear[n] = answers[n] * excitation[n];
  }
  const RollDampingLaw law{0.1 * pendulum.damping(), 4.0 * pendulum.damping()};
  std::vector<Complex> moment(kSamples / 2);
  memory.solve(linear, law, moment);
  std::vector<Complex> rate(kSamples / 2);
  for (std::size_t n = 0; n < rate.size(); ++n) {
    rate[n] = Complex(0.0, kStep * static_cast<double>(n)) * (linear[n] + answers[n] * moment[n]);
  }
  std::vector<double> force(kSamples);
  std::vector<double> velocity(kSamples);
  Fourier(kSamples).series(excitation, rate, force, velocity);
  double brought = 0.0;
  double taken = 0.0;
  for (std::size_t j = 0; j < kSamples; ++j) {
    const double v = velocity[j];
    brought += force[j] * v;
    taken += law.linear * v * v + law.quadratic * std::fabs(v) * v * v;
  }
  EXPECT_NEAR(brought / taken, 1.0, 0.01);  // trapezoidal rule, (omega dt)^2 / 12 of the base damping
}

}  // namespace
}  // namespace quickstrip::seaway
