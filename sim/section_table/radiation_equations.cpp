#include "sim/section_table/radiation_equations.hpp"

#include <cmath>

#include "core/base/constants.hpp"
#include "sim/section_table/exponential_integral.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// integral over 0 ... pi/2 of cos n theta, for every sum of two frequencies
constexpr std::size_t kTopSum = 2 * top_frequency(static_cast<std::size_t>(kMaxMultipoles));
struct CosineIntegrals {
  std::array<double, kTopSum + 1> value{};
  constexpr CosineIntegrals() {
    value[0] = 0.5 * kPi;
    for (std::size_t n = 1; n < value.size(); n += 2) {
      value[n] = (n % 4 == 1 ? 1.0 : -1.0) / static_cast<double>(n);
    }
  }
};
constexpr CosineIntegrals kCosineIntegrals;

// integral of the product of two harmonics of the same kind over the quarter contour
double overlap(Symmetry symmetry, std::size_t p, std::size_t q) {
  const double sum = kCosineIntegrals.value[p + q];
  const double difference = kCosineIntegrals.value[p > q ? p - q : q - p];
  return 0.5 * (symmetry == Symmetry::kHeave ? difference + sum : difference - sum);
}

double real(std::size_t n) {
  return static_cast<double>(n);
}

}  // namespace

SectionHarmonics::SectionHarmonics(const MappingCoefficients& a) : a_(a), powers_(power_coefficients(a)) {
  const std::array<double, kMaxMappingCoefficients> g = radius_harmonics(a);
  chain_[0] = 1.0;
  // n3 ds = -dy, n2 ds = dz, n4 ds = -(y dy + z dz)
  heave_.amplitude[0] = -1.0;
  sway_.amplitude[0] = 1.0;
  roll_.first = 2;
  for (std::size_t n = 1; n <= a.size(); ++n) {
    const double slope = (2.0 * real(n) - 1.0) * powers_[n - 1];
    chain_[n] = -slope;
    heave_.amplitude[n - 1] += slope;
    sway_.amplitude[n - 1] += slope;
    roll_.amplitude[n - 1] = 2.0 * real(n) * g[n - 1];
  }
}

MappedPoint SectionHarmonics::point(std::span<const double> cosines, std::span<const double> sines) const {
  double y = sines[1];
  double z = -cosines[1];
  double dy = cosines[1];
  double dz = sines[1];
  for (std::size_t n = 1; n <= a_.size(); ++n) {
    const std::size_t f = 2 * n - 1;
    y -= powers_[n - 1] * sines[f];
    z -= powers_[n - 1] * cosines[f];
    dy += chain_[n] * cosines[f];
    dz -= chain_[n] * sines[f];
  }
  return {{z, y}, {dz, dy}};
}

// Frequencies of one multipole differ by odd numbers between h_p and the chain, by even ones otherwise: then
// the overlap is that of equal frequencies alone.
double SectionHarmonics::linear_coupling(Symmetry symmetry, std::size_t i, std::size_t j) const {
  const std::size_t pi = multipole_frequency(symmetry, i);
  const std::size_t pj = multipole_frequency(symmetry, j);
  double total = 0.0;
  for (std::size_t k = 0; k < chain_length(); ++k) {
    const std::size_t qi = pi - 1 + 2 * k;
    const std::size_t qj = pj - 1 + 2 * k;
    total += chain_[k] * (overlap(symmetry, pi, qj) + overlap(symmetry, qi, pj) * real(pj) / real(qi));
  }
  return -total;
}

double SectionHarmonics::band(Symmetry symmetry, std::size_t i, std::size_t j) const {
  // i >= j: q_ik == q_jl with l = k + i - j
  double total = 0.0;
  for (std::size_t k = 0; k + (i - j) < chain_length(); ++k) {
    const std::size_t q = multipole_frequency(symmetry, i) - 1 + 2 * k;
    total += chain_[k] * chain_[k + (i - j)] / real(q);
  }
  return -0.25 * kPi * total;
}

void SectionHarmonics::keep(std::size_t num_multipoles) {
  for (const Symmetry symmetry : {Symmetry::kHeave, Symmetry::kSwayRoll}) {
    std::vector<std::vector<double>>& rows = linear_[static_cast<std::size_t>(symmetry)];
    for (std::size_t i = rows.size() + 1; i <= num_multipoles; ++i) {
      std::vector<double> row;
      for (std::size_t j = 1; j <= i; ++j) {
        row.push_back(linear_coupling(symmetry, i, j));
      }
      rows.push_back(std::move(row));
    }
  }
}

double SectionHarmonics::coupling(Symmetry symmetry, double kappa, std::size_t i, std::size_t j) const {
  const std::vector<std::vector<double>>& kept = linear_[static_cast<std::size_t>(symmetry)];
  double value = kappa * (i <= kept.size() ? kept[i - 1][j - 1] : linear_coupling(symmetry, i, j));
  if (i - j < chain_length()) {
    value += kappa * kappa * band(symmetry, i, j);
  }
  return i == j ? value - 0.25 * kPi * real(multipole_frequency(symmetry, i)) : value;
}

double multipole_load(Symmetry symmetry, const SectionHarmonics& section, const ModeNormal& normal,
                      double kappa, std::size_t m) {
  const std::size_t p = multipole_frequency(symmetry, m);
  double total = 0.0;
  for (std::size_t n = 0; n < normal.amplitude.size(); ++n) {
    if (normal.amplitude[n] == 0.0) {
      continue;
    }
    const std::size_t f = normal.first + 2 * n;
    double phi = overlap(symmetry, p, f);
    for (std::size_t k = 0; k < section.chain_length(); ++k) {
      const std::size_t q = p - 1 + 2 * k;
      phi += kappa * section.chain(k) * overlap(symmetry, q, f) / real(q);
    }
    total += normal.amplitude[n] * phi;
  }
  return total;
}

// F(w) = PV integral of e^{kw}/(k-K) dk = e^{Kw} (E1(Kw) + i pi), the "i" of space; the outgoing wave adds
// i pi e^{Kw} with the "i" of time, kept apart by taking real (imaginary) parts in space first. The dipole is
// the source's derivative in y, i F'.
Singularities singularities(const MappedPoint& point, double kappa) {
  const Complex i_space(0.0, 1.0);
  const auto& [w, slope] = point;
  const Complex wave = std::exp(kappa * w);
  const Complex wave_slope = wave * slope;
  const Complex f = scaled_exponential_integral(kappa * w) + i_space * kPi * wave;
  const Complex inverse = 1.0 / w;
  const Complex f1 = kappa * f - inverse;
  const Complex f2 = kappa * f1 + inverse * inverse;
  return {{{{f.real(), kPi * wave.real()}, {(f1 * slope).imag(), kPi * kappa * wave_slope.imag()}},
           {{-f1.imag(), -kPi * kappa * wave.imag()},
            {(f2 * slope).real(), kPi * kappa * kappa * wave_slope.real()}}}};
}

SingularityMoments singularity_moments(const SectionHarmonics& section, double kappa,
                                       const ContourHarmonics& harmonics) {
  SingularityMoments moments;
  const ContourQuadrature& rule = harmonics.rule();
  for (std::size_t s = 0; s < 2; ++s) {
    moments.real[s].assign(harmonics.count(), 0.0);
    moments.imag[s].assign(harmonics.count(), 0.0);
  }
  for (std::size_t j = 0; j < rule.size(); ++j) {
    const std::array<std::span<const double>, 2> shape = {harmonics.cosines(j), harmonics.sines(j)};
    const Singularities at_point = singularities(section.point(shape[0], shape[1]), kappa);
    for (std::size_t s = 0; s < 2; ++s) {
      const Complex weighted = rule.weight(j) * at_point[s].potential;
      moments.corner[s] -= weighted * at_point[s].stream_slope;
      double* const re = moments.real[s].data();
      double* const im = moments.imag[s].data();
      const double* const h = shape[s].data();
      const double wr = weighted.real();
      const double wi = weighted.imag();
      for (std::size_t f = 0; f < harmonics.count(); ++f) {
        re[f] += wr * h[f];
        im[f] += wi * h[f];
      }
    }
  }
  return moments;
}

}  // namespace quickstrip
