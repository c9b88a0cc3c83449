#include "sim/section_table/multipole_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "sim/section_table/linear_solve.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// The Galerkin equations of one symmetry: real symmetric block of the multipoles, complex border of the
// singularity, right-hand sides of up to two modes.
struct System {
  std::size_t n = 0;
  std::vector<double> block;                  // n x n
  std::array<std::vector<double>, 2> border;  // real, imaginary
  Complex corner;
  std::array<std::vector<double>, 2> loads;  // of the multipoles
  std::array<Complex, 2> corner_load;        // of the singularity
};

void add_singularity(Symmetry symmetry, const SectionHarmonics& section, double kappa,
                     std::span<const ModeNormal> normals, const SingularityMoments& moments, System& system) {
  const auto s = static_cast<std::size_t>(symmetry);
  const std::array<const std::vector<double>*, 2> part = {&moments.real[s], &moments.imag[s]};
  for (std::size_t c = 0; c < 2; ++c) {
    const std::vector<double>& moment = *part[c];
    for (std::size_t m = 1; m <= system.n; ++m) {
      const std::size_t p = multipole_frequency(symmetry, m);
      double chain = 0.0;
      for (std::size_t k = 0; k < section.chain_length(); ++k) {
        chain += section.chain(k) * moment[p - 1 + 2 * k];
      }
      system.border[c].push_back(-(static_cast<double>(p) * moment[p] + kappa * chain));
    }
  }
  system.corner = moments.corner[s];
  for (std::size_t mode = 0; mode < normals.size(); ++mode) {
    for (std::size_t n = 0; n < normals[mode].amplitude.size(); ++n) {
      const std::size_t f = normals[mode].first + 2 * n;
      system.corner_load[mode] += normals[mode].amplitude[n] * Complex((*part[0])[f], (*part[1])[f]);
    }
  }
}

System assemble(Symmetry symmetry, const SectionHarmonics& section, double kappa, std::size_t num_multipoles,
                std::span<const ModeNormal> normals, const SingularityMoments& moments) {
  System system;
  system.n = num_multipoles;
  system.block.resize(system.n * system.n);
  for (std::size_t i = 1; i <= system.n; ++i) {
    for (std::size_t j = 1; j <= i; ++j) {
      const double value = section.coupling(symmetry, kappa, i, j);
      system.block[(i - 1) * system.n + (j - 1)] = value;
      system.block[(j - 1) * system.n + (i - 1)] = value;
    }
  }
  for (std::size_t mode = 0; mode < normals.size(); ++mode) {
    for (std::size_t m = 1; m <= system.n; ++m) {
      system.loads[mode].push_back(multipole_load(symmetry, section, normals[mode], kappa, m));
    }
  }
  add_singularity(symmetry, section, kappa, normals, moments, system);
  return system;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    total += a[i] * b[i];
  }
  return total;
}

// I_kj = 2 b_k . D^-1 b_j by elimination of the multipoles, and the strengths D^-1 b.
struct Response {
  std::array<std::array<Complex, 2>, 2> force{};
  std::array<Complex, 2> strength{};  // of the singularity
  std::array<std::vector<Complex>, 2> multipoles;
};

Response respond(System system, std::size_t num_modes) {
  const std::size_t n = system.n;
  std::vector<double> right(n * 4, 0.0);  // columns: border (real, imaginary), loads
  const std::array<std::vector<double>, 2>& border = system.border;
  for (std::size_t i = 0; i < n; ++i) {
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
    for (std::size_t i = 0; i < n; ++i) {
      response.multipoles[k].push_back(column(2 + k)[i] -
                                       response.strength[k] * Complex(column(0)[i], column(1)[i]));
    }
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

SectionSolution collect(const Response& heave, const Response& sway, double kappa, double half_breadth) {
  SectionSolution solution;
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
  const double waterline = kappa * half_breadth;
  const Complex heave_phase = std::polar(1.0, waterline);
  const Complex sway_phase = std::polar(1.0, waterline - 0.25 * kPi);
  // Taken off its waterline's phase first: what is left lies between 0 and pi/2.
  solution.sway_phase_lag = std::arg(sway.strength[0] * std::polar(1.0, waterline)) - waterline;
  solution.h3 = amplitude(solution.damping33, heave.strength[0] * heave_phase);
  solution.h2 = amplitude(solution.damping22, sway.strength[0] * sway_phase);
  solution.h4 = amplitude(solution.damping44, sway.strength[1] * sway_phase);
  return solution;
}

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

// At the points that the most multipoles ask for, fewer of them can be solved for as well.
const ContourHarmonics& harmonics_for(std::size_t num_multipoles) {
  return contour_harmonics(4 * static_cast<int>(num_multipoles) + 48, top_frequency(num_multipoles));
}

SectionSolution solve_with(const SectionHarmonics& section, double kappa, std::size_t num_multipoles,
                           const SingularityMoments& moments, PotentialStrengths* strengths) {
  const std::array<ModeNormal, 1> vertical = {section.heave()};
  const std::array<ModeNormal, 2> lateral = {section.sway(), section.roll()};
  Response heave =
      respond(assemble(Symmetry::kHeave, section, kappa, num_multipoles, vertical, moments), vertical.size());
  Response sway = respond(assemble(Symmetry::kSwayRoll, section, kappa, num_multipoles, lateral, moments),
                          lateral.size());
  SectionSolution solution = collect(heave, sway, kappa, mapped_half_breadth(section.coefficients()));
  solution.num_multipoles = static_cast<int>(num_multipoles);
  if (strengths != nullptr) {
    strengths->kappa = kappa;
    strengths->singularity = {sway.strength[0], heave.strength[0], sway.strength[1]};
    strengths->multipoles = {std::move(sway.multipoles[0]), std::move(heave.multipoles[0]),
                             std::move(sway.multipoles[1])};
  }
  return solution;
}

}  // namespace

SectionSolution MultipoleSection::solve(double kappa, int num_multipoles,
                                        PotentialStrengths* strengths) const {
  QS_CHECK(kappa > 0.0 && num_multipoles >= 2 && num_multipoles <= kMaxMultipoles);
  const auto n = static_cast<std::size_t>(num_multipoles);
  return solve_with(harmonics_, kappa, n, singularity_moments(harmonics_, kappa, harmonics_for(n)),
                    strengths);
}

SectionSolution MultipoleSection::solve_adaptive(double kappa, double tolerance, int most,
                                                 PotentialStrengths* strengths) const {
  constexpr std::size_t kFirst = 24;
  const auto last = static_cast<std::size_t>(most);
  QS_CHECK(kappa > 0.0 && last >= 2 * kFirst && most <= kMaxMultipoles);
  SingularityMoments moments = singularity_moments(harmonics_, kappa, harmonics_for(2 * kFirst));
  SectionSolution before = solve_with(harmonics_, kappa, kFirst, moments, nullptr);
  for (std::size_t n = 2 * kFirst; n <= last; n = n < last ? std::min(2 * n, last) : n + 1) {
    if (n > 2 * kFirst) {
      moments = singularity_moments(harmonics_, kappa, harmonics_for(n));
    }
    SectionSolution now = solve_with(harmonics_, kappa, n, moments, strengths);
    if (change(now, before) < tolerance) {
      return now;
    }
    before = now;
  }
  before.converged = false;
  return before;
}

SectionSolution solve_lewis_form(double a1, double a3, double kappa, int num_multipoles) {
  return MultipoleSection(lewis_mapping(a1, a3)).solve(kappa, num_multipoles);
}

SectionSolution solve_lewis_form_adaptive(double a1, double a3, double kappa, double tolerance) {
  return MultipoleSection(lewis_mapping(a1, a3)).solve_adaptive(kappa, tolerance);
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
