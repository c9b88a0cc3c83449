// Roll with linear and quadratic damping, integrated in time.
//
// The linear ship with a base damping b0 rolls phi_lin; the moment that the true damping has beyond it,
//   M = -(b1 - b0) phi' - b2 |phi'| phi',
// moves her as any roll moment does: phi = phi_lin + k * M, k(t) the impulse response, whose Fourier
// transform is the roll of a unit moment (core/strip/roll_admittance.hpp), sway, yaw and the memory of the
// water included. Roll velocity is stepped through the block by discrete convolution (trapezoidal rule, the
// present moment implicit: a quadratic equation with one root), after a start-up of the kernel's length on
// the end of the periodic block. What is wanted of motions follows from the amplitudes of M: roll, sway and
// yaw. k is taken as k_ref + rest: k_ref that of one degree of freedom with the inertia of high and the
// stiffness of low frequencies, in closed form; the rest is smooth at t = 0 and comes from its Fourier
// transform.
//
// Error: a linear change of damping against the rank-one update of the linear equations: 0.3 % in amplitude
// at resonance with omega dt = 0.16 (tests/seaway). Cost: kernel x samples multiply-adds, some 3 ms an hour.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/seaway/fourier.hpp"

namespace quickstrip::seaway {

/// Roll damping beyond potential flow: moment = -(linear phi' + quadratic |phi'| phi').
struct RollDampingLaw {
  double linear = 0.0;     // b1 [N m s]
  double quadratic = 0.0;  // b2 [N m s2]
};

class RollMemory {
 public:
  /// roll_answer: of a unit roll moment at n `step`, n = 0 ... N/2 - 1, with `base_damping` [N m s] in it;
  /// step 2 pi / T of the block, N samples.
  RollMemory(std::span<const Complex> roll_answer, double step, double base_damping);

  [[nodiscard]] std::size_t num_samples() const { return fourier_.num_samples(); }
  [[nodiscard]] double dt() const { return dt_; }
  [[nodiscard]] std::size_t kernel_length() const { return kernel_.size(); }
  /// The velocity's answer to a unit impulse at j dt, half of it at j = 0.
  [[nodiscard]] std::span<const double> kernel() const { return kernel_; }

  /// roll_amplitudes of the linear ship by bin; moment: amplitudes of M by bin, as many as there is room for,
  /// at most N/2.
  void solve(std::span<const Complex> roll_amplitudes, const RollDampingLaw& law, std::span<Complex> moment);

  /// The moment in time from the linear velocity in time; both N samples of a periodic block.
  void step_through(std::span<const double> velocity, const RollDampingLaw& law, std::span<double> moment);

 private:
  Fourier fourier_;
  double step_;
  double dt_;
  double base_damping_;
  std::vector<double> kernel_;
  std::vector<double> memory_;  // what past moments add to the velocity, from now on
};

}  // namespace quickstrip::seaway
