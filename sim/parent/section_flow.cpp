#include "sim/parent/section_flow.hpp"

#include <cmath>

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

double sinc(double u) {
  return std::fabs(u) < 1e-4 ? 1.0 - u * u / 6.0 : std::sin(u) / u;
}

}  // namespace

DiffractionFactors diffraction_factors(const SectionFlow& flow, double k, double sin_mu) {
  // Phi_kj = -int phi_k n_j ds of the uniform motion, Phi_wk of the wave, over the half contour. Sway and
  // roll divided by -i sin mu, which v_2 / v_3 is.
  Complex uniform22;
  Complex uniform24;
  Complex uniform33;
  Complex wave2;
  Complex wave3;
  Complex wave4;
  const double b = k * sin_mu;
  for (const FlowPoint& p : flow.points) {
    const double decay = std::exp(k * p.z);
    const double vertical = decay * (p.nz_ds * std::cos(b * p.y) - sin_mu * p.ny_ds * std::sin(b * p.y));
    const double lateral = decay * (p.ny_ds * std::cos(b * p.y) + p.nz_ds * k * p.y * sinc(b * p.y));
    uniform22 -= p.phi[kSectionSway] * p.ny_ds;
    uniform24 -= p.phi[kSectionRoll] * p.ny_ds;
    uniform33 -= p.phi[kSectionHeave] * p.nz_ds;
    wave2 -= p.phi[kSectionSway] * lateral;
    wave3 -= p.phi[kSectionHeave] * vertical;
    wave4 -= p.phi[kSectionRoll] * lateral;
  }
  DiffractionFactors out;
  out.heave = wave3 / uniform33;
  out.sway = wave2 / uniform22;
  out.roll_lever = (wave4 - uniform24 * out.sway) / uniform22;
  return out;
}

}  // namespace quickstrip
