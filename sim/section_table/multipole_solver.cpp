#include "sim/section_table/multipole_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "sim/section_table/contour_quadrature.hpp"
#include "sim/section_table/exponential_integral.hpp"
#include "sim/section_table/linear_solve.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

enum class Symmetry { kHeave, kSwayRoll };

constexpr int kTopFrequency = 2 * kMaxMultipoles + 4;

// integral over 0 ... pi/2 of cos n theta, for n = 0 ... 2 kTopFrequency
struct CosineIntegrals {
  std::array<double, 2 * kTopFrequency + 1> value{};
  constexpr CosineIntegrals() {
    value[0] = 0.5 * kPi;
    for (std::size_t n = 1; n < value.size(); n += 2) {
      value[n] = (n % 4 == 1 ? 1.0 : -1.0) / static_cast<double>(n);
    }
  }
};
constexpr CosineIntegrals kCosineIntegrals;

double cosine_integral(int n) {
  return kCosineIntegrals.value[static_cast<std::size_t>(std::abs(n))];
}

// One term of a multipole on the hull: amplitude cos(frequency theta) in heave, sin in sway and roll.
struct Term {
  int frequency;
  double amplitude;
};
using Multipole = std::array<Term, 4>;

// Wave-free potential m = 1, 2, ... on the hull: phi = sum amplitude cos|sin(f theta), and along the hull
// d psi/d theta = sum amplitude f cos|sin(f theta). Satisfies the free-surface condition exactly.
Multipole multipole(Symmetry symmetry, int m, double a1, double a3, double kappa) {
  const int p = symmetry == Symmetry::kHeave ? 2 * m : 2 * m + 1;
  return {{{p, 1.0},
           {p - 1, kappa / (p - 1)},
           {p + 1, kappa * a1 / (p + 1)},
           {p + 3, -3.0 * kappa * a3 / (p + 3)}}};
}

// integral of the product of two harmonics of the same kind over the quarter contour
double overlap(Symmetry symmetry, int p, int q) {
  const double sum = cosine_integral(p + q);
  return 0.5 * (cosine_integral(p - q) + (symmetry == Symmetry::kHeave ? sum : -sum));
}

double overlap(Symmetry symmetry, const Multipole& phi, const Multipole& psi_slope) {
  double total = 0.0;
  for (const Term& left : phi) {
    for (const Term& right : psi_slope) {
      total += left.amplitude * right.amplitude * right.frequency *
               overlap(symmetry, left.frequency, right.frequency);
    }
  }
  return total;
}

// n ds of a mode, as two harmonics: heave -dy, sway dz, roll -(y dy + z dz).
using ModeNormal = std::array<Term, 2>;
ModeNormal heave_normal(double a1, double a3) {
  return {{{1, -(1.0 + a1)}, {3, 3.0 * a3}}};
}
ModeNormal sway_normal(double a1, double a3) {
  return {{{1, 1.0 - a1}, {3, 3.0 * a3}}};
}
ModeNormal roll_normal(double a1, double a3) {
  return {{{2, -2.0 * a1 * (1.0 + a3)}, {4, 4.0 * a3}}};
}

double load(Symmetry symmetry, const Multipole& phi, const ModeNormal& normal) {
  double total = 0.0;
  for (const Term& left : phi) {
    for (const Term& right : normal) {
      total += left.amplitude * right.amplitude * overlap(symmetry, left.frequency, right.frequency);
    }
  }
  return total;
}

// Source or dipole at O on the hull: potential, and slope of the stream function along theta.
struct Singularity {
  Complex potential;
  Complex stream_slope;
};

// F(w) = PV integral of e^{kw}/(k-K) dk = e^{Kw} (E1(Kw) + i pi), the "i" of space; the outgoing wave adds
// i pi e^{Kw} with the "i" of time, kept apart by taking real (imaginary) parts in space first.
Singularity singularity(Symmetry symmetry, Complex w, Complex slope, double kappa) {
  const Complex i_space(0.0, 1.0);
  const Complex wave = std::exp(kappa * w);
  const Complex f = scaled_exponential_integral(kappa * w) + i_space * kPi * wave;
  const Complex f1 = kappa * f - 1.0 / w;
  if (symmetry == Symmetry::kHeave) {
    return {{f.real(), kPi * wave.real()}, {(f1 * slope).imag(), kPi * (kappa * wave * slope).imag()}};
  }
  const Complex f2 = kappa * f1 + 1.0 / (w * w);
  return {{-f1.imag(), -kPi * kappa * wave.imag()},
          {(i_space * f2 * slope).imag(), kPi * (i_space * kappa * kappa * wave * slope).imag()}};
}

// The Galerkin equations of one symmetry: real symmetric block of the multipoles, complex border of the
// singularity, right-hand sides of up to two modes.
struct System {
  std::size_t n = 0;
  std::vector<double> block;    // n x n
  std::vector<Complex> border;  // n
  Complex corner;
  std::array<std::vector<double>, 2> loads;  // of the multipoles
  std::array<Complex, 2> corner_load;        // of the singularity
};

void add_singularity(Symmetry symmetry, double a1, double a3, double kappa,
                     std::span<const Multipole> multipoles, std::span<const ModeNormal> normals,
                     System& system) {
  const ContourQuadrature& quadrature = contour_quadrature(4 * static_cast<int>(system.n) + 48);
  std::vector<Complex> harmonic(2 * system.n + 5);  // e^{i f theta}
  std::vector<double> shape(harmonic.size());
  for (std::size_t j = 0; j < quadrature.size(); ++j) {
    const double theta = quadrature.theta(j);
    const Complex turn(std::cos(theta), std::sin(theta));
    harmonic[0] = 1.0;
    shape[0] = symmetry == Symmetry::kHeave ? 1.0 : 0.0;
    for (std::size_t f = 1; f < harmonic.size(); ++f) {
      harmonic[f] = harmonic[f - 1] * turn;
      shape[f] = symmetry == Symmetry::kHeave ? harmonic[f].real() : harmonic[f].imag();
    }
    const auto at = [&shape](int f) { return shape[static_cast<std::size_t>(f)]; };
    const Complex triple = harmonic[3];
    const Complex w(-((1.0 - a1) * turn.real() + a3 * triple.real()),
                    (1.0 + a1) * turn.imag() - a3 * triple.imag());
    const Complex slope((1.0 - a1) * turn.imag() + 3.0 * a3 * triple.imag(),
                        (1.0 + a1) * turn.real() - 3.0 * a3 * triple.real());
    const Singularity s = singularity(symmetry, w, slope, kappa);
    const Complex weighted = quadrature.weight(j) * s.potential;
    system.corner -= weighted * s.stream_slope;
    for (std::size_t k = 0; k < normals.size(); ++k) {
      for (const Term& term : normals[k]) {
        system.corner_load[k] += weighted * (term.amplitude * at(term.frequency));
      }
    }
    for (std::size_t m = 0; m < system.n; ++m) {
      double psi_slope = 0.0;
      for (const Term& term : multipoles[m]) {
        psi_slope += term.amplitude * term.frequency * at(term.frequency);
      }
      system.border[m] -= weighted * psi_slope;
    }
  }
}

System assemble(Symmetry symmetry, double a1, double a3, double kappa, int num_multipoles,
                std::span<const ModeNormal> normals) {
  System system;
  system.n = static_cast<std::size_t>(num_multipoles);
  system.block.resize(system.n * system.n);
  system.border.resize(system.n);
  std::vector<Multipole> multipoles;
  for (int m = 1; m <= num_multipoles; ++m) {
    multipoles.push_back(multipole(symmetry, m, a1, a3, kappa));
  }
  for (std::size_t i = 0; i < system.n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double value = -overlap(symmetry, multipoles[i], multipoles[j]);
      system.block[i * system.n + j] = value;
      system.block[j * system.n + i] = value;
    }
  }
  for (std::size_t k = 0; k < normals.size(); ++k) {
    for (const Multipole& phi : multipoles) {
      system.loads[k].push_back(load(symmetry, phi, normals[k]));
    }
  }
  add_singularity(symmetry, a1, a3, kappa, multipoles, normals, system);
  return system;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    total += a[i] * b[i];
  }
  return total;
}

// I_kj = 2 b_k . D^-1 b_j by elimination of the multipoles, and the strengths of the singularity.
struct Response {
  std::array<std::array<Complex, 2>, 2> force{};
  std::array<Complex, 2> strength{};
};

Response respond(System system, std::size_t num_modes) {
  const std::size_t n = system.n;
  std::vector<double> right(n * 4, 0.0);  // columns: border (real, imaginary), loads
  std::array<std::vector<double>, 2> border{std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    border[0][i] = system.border[i].real();
    border[1][i] = system.border[i].imag();
    right[i] = border[0][i];
    right[n + i] = border[1][i];
    for (std::size_t k = 0; k < num_modes; ++k) {
      right[(2 + k) * n + i] = system.loads[k][i];
    }
  }
  solve_in_place(system.block, right, n, 2 + num_modes);
  const auto column = [&right, n](std::size_t c) { return std::span<const double>(right).subspan(c * n, n); };
  const double rr = dot(border[0], column(0));
  const double ri = dot(border[0], column(1));
  const double ii = dot(border[1], column(1));
  const Complex schur = system.corner - Complex(rr - ii, 2.0 * ri);
  Response response;
  std::array<Complex, 2> reduced{};
  for (std::size_t k = 0; k < num_modes; ++k) {
    reduced[k] =
        system.corner_load[k] - Complex(dot(system.loads[k], column(0)), dot(system.loads[k], column(1)));
    response.strength[k] = reduced[k] / schur;
  }
  for (std::size_t k = 0; k < num_modes; ++k) {
    for (std::size_t j = 0; j < num_modes; ++j) {
      response.force[k][j] = 2.0 * (dot(system.loads[k], column(2 + j)) + reduced[k] * reduced[j] / schur);
    }
  }
  return response;
}

// The common phase of the radiated wave is that of a wave made at the waterline, -K B/2, within a quarter
// turn: so the sign is that of the real part once this phase is taken off.
double amplitude(double damping, Complex in_phase) {
  return std::copysign(std::sqrt(std::max(0.0, damping)), in_phase.real());
}

}  // namespace

SectionSolution solve_lewis_form(double a1, double a3, double kappa, int num_multipoles) {
  QS_CHECK(kappa > 0.0 && num_multipoles >= 2 && num_multipoles <= kMaxMultipoles);
  const std::array<ModeNormal, 1> vertical = {heave_normal(a1, a3)};
  const std::array<ModeNormal, 2> lateral = {sway_normal(a1, a3), roll_normal(a1, a3)};
  const Response heave =
      respond(assemble(Symmetry::kHeave, a1, a3, kappa, num_multipoles, vertical), vertical.size());
  const Response sway =
      respond(assemble(Symmetry::kSwayRoll, a1, a3, kappa, num_multipoles, lateral), lateral.size());

  SectionSolution solution;
  solution.num_multipoles = num_multipoles;
  solution.a33 = -heave.force[0][0].real();
  solution.damping33 = -heave.force[0][0].imag();
  solution.a22 = -sway.force[0][0].real();
  solution.a24 = -sway.force[0][1].real();
  solution.a44 = -sway.force[1][1].real();
  solution.damping22 = -sway.force[0][0].imag();
  solution.damping24 = -sway.force[0][1].imag();
  solution.damping44 = -sway.force[1][1].imag();
  // Far from the hull E1 dies away and the unit source is i pi e^{iKy + Kz}, the dipole its derivative in y.
  solution.far_field3 = kPi * std::abs(heave.strength[0]);
  solution.far_field2 = kPi * kappa * std::abs(sway.strength[0]);
  solution.far_field4 = kPi * kappa * std::abs(sway.strength[1]);
  const double waterline = kappa * (1.0 + a1 + a3);
  const Complex heave_phase = std::polar(1.0, waterline);
  const Complex sway_phase = std::polar(1.0, waterline - 0.25 * kPi);
  // Taken off its waterline's phase first: what is left lies between 0 and pi/2.
  solution.sway_phase_lag = std::arg(sway.strength[0] * std::polar(1.0, waterline)) - waterline;
  solution.h3 = amplitude(solution.damping33, heave.strength[0] * heave_phase);
  solution.h2 = amplitude(solution.damping22, sway.strength[0] * sway_phase);
  solution.h4 = amplitude(solution.damping44, sway.strength[1] * sway_phase);
  return solution;
}

namespace {

// Largest change between two solutions: 24 and 44 against the 22-44 mean, damping against 1 % of added mass.
double change(const SectionSolution& now, const SectionSolution& before) {
  const double mean = std::sqrt(std::abs(now.a22 * now.a44));
  const double damping_mean = std::sqrt(now.damping22 * now.damping44);
  const auto moved = [](double x, double y, double scale) {
    return std::abs(x - y) / std::max(scale, 1e-12);
  };
  const auto size = [](double x, double floor) { return std::max(std::abs(x), 0.01 * std::abs(floor)); };
  return std::max({moved(now.a33, before.a33, size(now.a33, 0.0)),
                   moved(now.damping33, before.damping33, size(now.damping33, now.a33)),
                   moved(now.a22, before.a22, size(now.a22, now.damping22)),
                   moved(now.damping22, before.damping22, size(now.damping22, now.a22)),
                   moved(now.a44, before.a44, size(now.a44, mean)), moved(now.a24, before.a24, mean),
                   moved(now.damping44, before.damping44, size(now.damping44, damping_mean)),
                   moved(now.damping24, before.damping24, std::max(damping_mean, 0.01 * mean))});
}

}  // namespace

SectionSolution solve_lewis_form_adaptive(double a1, double a3, double kappa, double tolerance) {
  constexpr int kFirst = 12;
  SectionSolution before = solve_lewis_form(a1, a3, kappa, kFirst);
  for (int n = 2 * kFirst; n <= kMaxMultipoles;
       n = n < kMaxMultipoles ? std::min(2 * n, kMaxMultipoles) : n + 1) {
    SectionSolution now = solve_lewis_form(a1, a3, kappa, n);
    // Twice running, in effect: two unconverged answers can agree with each other, three of doubled size
    // less.
    if (change(now, before) < tolerance && n >= 4 * kFirst) {
      return now;
    }
    before = now;
  }
  before.converged = false;
  return before;
}

double kappa_of_xi(const LewisSection& section, double xi) {
  return xi * section.scale / (0.5 * section.breadth);
}

SectionCoefficients normalised(const LewisSection& section, double xi, const SectionSolution& solution) {
  const double m2 = section.scale * section.scale;
  const double by_area = m2 / section.area;
  const double by_moment = by_area * section.scale / section.breadth;
  const double by_inertia = by_area * m2 / (section.breadth * section.breadth);
  const double root = std::sqrt(xi);  // omega sqrt(B/2g)
  return {.a22 = solution.a22 * by_area,
          .b22 = root * solution.damping22 * by_area,
          .a33 = solution.a33 * by_area,
          .b33 = root * solution.damping33 * by_area,
          .a44 = solution.a44 * by_inertia,
          .b44 = root * solution.damping44 * by_inertia,
          .a24 = solution.a24 * by_moment,
          .b24 = root * solution.damping24 * by_moment};
}

SectionCoefficients solve_section(const LewisSection& section, double xi, int num_multipoles) {
  return normalised(section, xi,
                    solve_lewis_form(section.a1, section.a3, kappa_of_xi(section, xi), num_multipoles));
}

SectionCoefficients solve_section(const LewisSection& section, double xi) {
  return normalised(section, xi, solve_lewis_form_adaptive(section.a1, section.a3, kappa_of_xi(section, xi)));
}

}  // namespace quickstrip
