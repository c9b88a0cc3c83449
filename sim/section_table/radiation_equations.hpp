// The Galerkin equations of a mapped section's radiation problem, for multipole_solver: wave-free multipoles
// of the mapping's coefficients, the source (dipole) at O, the modes' normals. Units: mapping scale M,
// kappa = K M; time factor exp(-i omega t).
//
// With c_n = (-1)^n a_{2n-1} (conformal_mapping.hpp) the potential Z^{-p} + K int Z^{-p} dw meets
// phi_z = K phi on the free surface, and its real part (imaginary, for odd p) is on the hull
//   phi_m = h_p + kappa sum_k g_k h_{p-1+2k} / (p-1+2k),  k = 0 ... N,  g_0 = 1, g_k = -(2k-1) c_k,
//   d psi_m/d theta = -phi_n ds/d theta = p h_p + kappa sum_k g_k h_{p-1+2k},
// h_f = cos f theta, p = 2m in heave; sin f theta, p = 2m+1 in sway and roll.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/section_table/conformal_mapping.hpp"
#include "sim/section_table/contour_quadrature.hpp"

namespace quickstrip {

enum class Symmetry : std::size_t { kHeave, kSwayRoll };

inline constexpr int kMaxMultipoles = 256;

/// Frequency p of multipole m = 1, 2, ...
inline std::size_t multipole_frequency(Symmetry symmetry, std::size_t m) {
  return symmetry == Symmetry::kHeave ? 2 * m : 2 * m + 1;
}

/// Harmonics met by this many multipoles of any section.
constexpr std::size_t top_frequency(std::size_t num_multipoles) {
  return 2 * (num_multipoles + kMaxMappingCoefficients);
}

/// n ds/d theta of a mode: harmonics of frequency first, first + 2, ...
struct ModeNormal {
  std::size_t first = 1;
  std::array<double, kMaxMappingCoefficients + 1> amplitude{};
};

/// What of a section does not depend on frequency.
class SectionHarmonics {
 public:
  explicit SectionHarmonics(const MappingCoefficients& a);
  [[nodiscard]] const MappingCoefficients& coefficients() const { return a_; }
  [[nodiscard]] std::size_t chain_length() const { return a_.size() + 1; }
  [[nodiscard]] double chain(std::size_t k) const { return chain_[k]; }  // g_k
  [[nodiscard]] const ModeNormal& heave() const { return heave_; }
  [[nodiscard]] const ModeNormal& sway() const { return sway_; }
  [[nodiscard]] const ModeNormal& roll() const { return roll_; }
  /// w and dw/dtheta from cos f theta, sin f theta, f = 0 ... 2N.
  [[nodiscard]] MappedPoint point(std::span<const double> cosines, std::span<const double> sines) const;
  /// -int phi_i d psi_j/dtheta = linear kappa + diagonal + kappa^2 band; i >= j, from 1.
  [[nodiscard]] double coupling(Symmetry symmetry, double kappa, std::size_t i, std::size_t j) const;
  /// Keeps the linear part for as many multipoles.
  void keep(std::size_t num_multipoles);

 private:
  [[nodiscard]] double linear_coupling(Symmetry symmetry, std::size_t i, std::size_t j) const;
  [[nodiscard]] double band(Symmetry symmetry, std::size_t i, std::size_t j) const;

  MappingCoefficients a_;
  std::array<double, kMaxMappingCoefficients> powers_{};
  std::array<double, kMaxMappingCoefficients + 1> chain_{};
  ModeNormal heave_;
  ModeNormal sway_;
  ModeNormal roll_;
  std::array<std::vector<std::vector<double>>, 2> linear_;  // lower triangle, i >= j, from 0
};

/// int n ds/dtheta phi_m over the quarter contour, m = 1, 2, ...
double multipole_load(Symmetry symmetry, const SectionHarmonics& section, const ModeNormal& normal,
                      double kappa, std::size_t m);

/// Source or dipole at O on the hull: potential, and slope of the stream function along theta.
struct Singularity {
  std::complex<double> potential;
  std::complex<double> stream_slope;
};
using Singularities = std::array<Singularity, 2>;  // by Symmetry
Singularities singularities(const MappedPoint& point, double kappa);

/// Integrals over the quarter contour of the singularity's potential times every harmonic, and times its own
/// stream slope.
struct SingularityMoments {
  std::array<std::vector<double>, 2> real;  // by Symmetry; int Re phi h_f
  std::array<std::vector<double>, 2> imag;
  std::array<std::complex<double>, 2> corner{};
};
SingularityMoments singularity_moments(const SectionHarmonics& section, double kappa,
                                       const ContourHarmonics& harmonics);

}  // namespace quickstrip
