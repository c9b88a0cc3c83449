// The potentials on the hull of a section that multipole_solver has solved.
#include <cmath>

#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// The multipoles of a mode, as amplitudes of the harmonics h_f.
std::vector<Complex> harmonic_amplitudes(const SectionHarmonics& section, Symmetry symmetry, double kappa,
                                         const std::vector<Complex>& strengths) {
  std::vector<Complex> amplitude(top_frequency(strengths.size()) + 1);
  for (std::size_t m = 1; m <= strengths.size(); ++m) {
    const std::size_t p = multipole_frequency(symmetry, m);
    amplitude[p] += strengths[m - 1];
    for (std::size_t k = 0; k < section.chain_length(); ++k) {
      const std::size_t q = p - 1 + 2 * k;
      amplitude[q] += kappa * section.chain(k) / static_cast<double>(q) * strengths[m - 1];
    }
  }
  return amplitude;
}

Complex sum_of(const std::vector<Complex>& amplitude, std::span<const double> harmonic) {
  double re = 0.0;
  double im = 0.0;
  for (std::size_t f = 0; f < amplitude.size(); ++f) {
    re += amplitude[f].real() * harmonic[f];
    im += amplitude[f].imag() * harmonic[f];
  }
  return {re, im};
}

constexpr std::array<Symmetry, kNumModes> kSymmetryOf = {Symmetry::kSwayRoll, Symmetry::kHeave,
                                                         Symmetry::kSwayRoll};

}  // namespace

std::vector<HullPotential> hull_potentials(const SectionHarmonics& section,
                                           const PotentialStrengths& strengths, int num_points) {
  const ContourHarmonics& harmonics =
      contour_harmonics(num_points, top_frequency(strengths.multipoles[0].size()));
  std::array<std::vector<Complex>, kNumModes> amplitude;
  for (std::size_t mode = 0; mode < kNumModes; ++mode) {
    amplitude[mode] =
        harmonic_amplitudes(section, kSymmetryOf[mode], strengths.kappa, strengths.multipoles[mode]);
  }
  std::vector<HullPotential> points;
  for (std::size_t j = 0; j < harmonics.rule().size(); ++j) {
    const std::array<std::span<const double>, 2> shape = {harmonics.cosines(j), harmonics.sines(j)};
    const MappedPoint at = section.point(shape[0], shape[1]);
    const Singularities singularity = singularities(at, strengths.kappa);
    const double weight = harmonics.rule().weight(j);
    HullPotential point{.y = at.w.imag(),
                        .z = at.w.real(),
                        .ny_ds = weight * at.slope.real(),
                        .nz_ds = -weight * at.slope.imag()};
    for (std::size_t mode = 0; mode < kNumModes; ++mode) {
      const auto s = static_cast<std::size_t>(kSymmetryOf[mode]);
      point.phi[mode] =
          strengths.singularity[mode] * singularity[s].potential + sum_of(amplitude[mode], shape[s]);
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace quickstrip
