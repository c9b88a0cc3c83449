// Loads of a beam wave from a solution of the flow about a section, for the laws that they obey.
#pragma once

#include <cmath>
#include <complex>

#include "sim/parent/section_flow.hpp"

namespace quickstrip::test {

/// Loads of a beam wave, crest at O, per metre of amplitude; rho = g = 1, about O: Froude-Krilov over the
/// points of the solution and the diffraction load.
struct BeamLoads {
  std::complex<double> sway;
  std::complex<double> heave;
  std::complex<double> roll;
};

inline BeamLoads beam_loads(const SectionFlow& flow) {
  using Complex = std::complex<double>;
  const double k = flow.wave_number;
  const double omega = std::sqrt(k);
  BeamLoads load;
  for (const FlowPoint& p : flow.points) {
    // -int p n ds of p = e^{kz - i k y}, both sides
    const double decay = std::exp(k * p.z);
    const Complex odd(0.0, 2.0 * decay * std::sin(k * p.y));
    load.heave -= 2.0 * decay * std::cos(k * p.y) * p.nz_ds;
    load.sway += odd * p.ny_ds;
    load.roll += odd * (p.y * p.nz_ds - p.z * p.ny_ds);
  }
  const DiffractionFactors factor = diffraction_factors(flow, k, 1.0);
  const Complex i(0.0, 1.0);
  const Complex mass22 = i * omega * flow.a22 + omega * flow.h2 * flow.h2;
  const Complex mass24 = i * omega * flow.a24 + omega * flow.h2 * flow.h4;
  const Complex mass33 = i * omega * flow.a33 + omega * flow.h3 * flow.h3;
  load.heave += mass33 * factor.heave * (i * omega);
  load.sway += mass22 * factor.sway * omega;
  load.roll += (mass24 * factor.sway + mass22 * factor.roll_lever) * omega;
  return load;
}

}  // namespace quickstrip::test
