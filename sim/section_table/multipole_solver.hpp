// Added mass and damping of sections heaving, swaying and rolling in the surface of deep water, the sections
// mapped with up to ten coefficients, Lewis forms with two: wave-free multipoles and a source (dipole) at O,
// as Ursell 1949, Tasai 1961 and de Jong 1973, the body condition met in a variational (Galerkin) form. The
// result is stationary: its error is the square of the potential's. Assumes linear theory, deep water, a
// section that is symmetric and whose mapping is conformal. Range: H0 0.05 ... 10, Lewis forms of a3 >= -1/3,
// xi 1e-4 ... 40. Error with the adaptive form: 2e-4 of an independent boundary-element solution
// (tests/sections). Cost: 0.1 ms at 24 multipoles, 0.2 ms at 48, 1 ms at 128; adaptive 0.2 ... 0.3 ms for a
// ship's section. Notation and signs: core/NOTATION.md; potentials are for the time factor exp(-i omega t).
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "core/base/result.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/hull/section_coefficients.hpp"
#include "sim/section_table/conformal_mapping.hpp"
#include "sim/section_table/radiation_equations.hpp"

namespace quickstrip {

/// Everything is in units of the mapping scale M, rho = g = 1: added masses M^2, M^3, M^4, frequency
/// kappa = K M with K = omega^2 / g. damping_kj = b_kj / (rho omega).
struct SectionSolution {
  double a22 = 0.0;
  double a24 = 0.0;
  double a44 = 0.0;
  double a33 = 0.0;
  double damping22 = 0.0;
  double damping24 = 0.0;
  double damping44 = 0.0;
  double damping33 = 0.0;
  // Signed amplitudes of the radiated waves (Kochin functions without their common phase); magnitude from the
  // damping, sign from the strength of the source and of the dipole: damping33 = h3^2, damping22 = h2^2,
  // damping24 = h2 h4, damping44 = h4^2.
  double h2 = 0.0;
  double h4 = 0.0;
  double h3 = 0.0;
  // By how much the load of a beam wave lags behind that of a long one (pi/2 ahead of the crest at O), rad:
  // the phase of the dipole, which by the Haskind relation is the load's.
  double sway_phase_lag = 0.0;
  // The same magnitudes from the far field of the source (dipole) instead of the pressure on the hull.
  double far_field2 = 0.0;
  double far_field4 = 0.0;
  double far_field3 = 0.0;
  int num_multipoles = 0;
  bool converged = true;
};

/// The potential of a mode (sway, heave, roll) is that of the singularity and of the multipoles, m = 1, 2,
/// ...
inline constexpr std::size_t kNumModes = 3;
struct PotentialStrengths {
  double kappa = 0.0;
  std::array<std::complex<double>, kNumModes> singularity{};
  std::array<std::vector<std::complex<double>>, kNumModes> multipoles;
};

/// A section for any number of frequencies. Keeps what does not depend on frequency; several threads may
/// solve.
class MultipoleSection {
 public:
  explicit MultipoleSection(const MappingCoefficients& a) : harmonics_(a) { harmonics_.keep(48); }
  [[nodiscard]] const SectionHarmonics& harmonics() const { return harmonics_; }

  /// kappa > 0, finite; 2 <= num_multipoles <= kMaxMultipoles, in each of the two problems.
  [[nodiscard]] SectionSolution solve(double kappa, int num_multipoles,
                                      PotentialStrengths* strengths = nullptr) const;

  /// Doubles the multipoles, from 24, until every value moves by less than `tolerance` (24 and 44 of the
  /// 22-44 mean, damping of 1 % of the added mass at least); not converged at `most`: says so.
  [[nodiscard]] SectionSolution solve_adaptive(double kappa, double tolerance = 1e-4,
                                               int most = kMaxMultipoles,
                                               PotentialStrengths* strengths = nullptr) const;

 private:
  SectionHarmonics harmonics_;
};

/// The same for Lewis forms.
SectionSolution solve_lewis_form(double a1, double a3, double kappa, int num_multipoles);
SectionSolution solve_lewis_form_adaptive(double a1, double a3, double kappa, double tolerance = 1e-4);

/// A point of quadrature on the hull, y >= 0: normal times length out of the body, potentials of unit
/// velocity, time factor exp(-i omega t). Units of M.
struct HullPotential {
  double y = 0.0;
  double z = 0.0;
  double ny_ds = 0.0;
  double nz_ds = 0.0;
  std::array<std::complex<double>, kNumModes> phi{};  // sway, heave, roll
};
std::vector<HullPotential> hull_potentials(const SectionHarmonics& section,
                                           const PotentialStrengths& strengths, int num_points);

/// kappa = K M of xi = K B/2 for this section.
double kappa_of_xi(const LewisSection& section, double xi);

SectionCoefficients normalised(const LewisSection& section, double xi, const SectionSolution& solution);

/// The contract's coefficients by the direct solution; xi > 0.
SectionCoefficients solve_section(const LewisSection& section, double xi, int num_multipoles);
SectionCoefficients solve_section(const LewisSection& section, double xi);  // adaptive

}  // namespace quickstrip
