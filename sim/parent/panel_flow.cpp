#include "sim/parent/panel_flow.hpp"

#include <cmath>
#include <cstddef>
#include <span>

#include "core/base/constants.hpp"
#include "sim/parent/least_squares.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

double dot(std::span<const double> a, std::span<const double> b) {
  double total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    total += a[i] * b[i];
  }
  return total;
}

// Weight of an equation for a point inside against one of a panel. Measured on rectangles at their first
// seven irregular frequencies and on Lewis forms: at 1 the former are still to be seen (10 % of b22), at 10
// the points' own discretisation error is (7 % of a22).
constexpr double kInsideWeight = 3.0;

// Lower bounds of K b (b half breadth at the waterline) of the irregular frequencies of any section, even and
// odd: those of the half plane below z = 0 with phi = 0 outside the waterline, which holds every section (the
// eigenvalues 1.1577 and 2.7547 of (-d2/dx2)^1/2 on an interval, [Kwasnicki2012]), less a margin. Below them
// the points inside are left out: a thin neck above a bulb would make them do harm.
constexpr double kFirstIrregularEven = 1.05;
constexpr double kFirstIrregularOdd = 2.5;

constexpr std::array<SectionMode, 1> kEvenModes = {kSectionHeave};
constexpr std::array<SectionMode, 2> kOddModes = {kSectionSway, kSectionRoll};

std::span<const SectionMode> modes(bool is_even) {
  return is_even ? std::span<const SectionMode>(kEvenModes) : std::span<const SectionMode>(kOddModes);
}

}  // namespace

// Of one symmetry. Right-hand sides: the modes; the standing wave e^{Kz} cos|sin Ky; a flux through the
// uppermost panel alone.
struct PanelMesh::Equations {
  std::vector<double> matrix;
  std::vector<double> right;
  std::vector<double> wave_normal;     // int d(wave)/dn over each panel
  std::vector<double> wave_potential;  // int wave over each panel
};

PanelMesh::PanelMesh(const std::vector<Complex>& ends, const std::vector<Complex>& inside) : ends_(ends) {
  for (std::size_t j = 0; j + 1 < ends.size(); ++j) {
    const Complex step = ends[j + 1] - ends[j];
    const double length = std::abs(step);
    const Complex direction = step / length;
    const Complex middle = 0.5 * (ends[j] + ends[j + 1]);
    const double ny = direction.real();
    const double nz = -direction.imag();
    directions_.push_back(direction);
    points_.push_back({middle.imag(), middle.real(), ny * length, nz * length, {}});
    normals_.push_back({});
    normals_.back()[kSectionSway] = ny;
    normals_.back()[kSectionHeave] = nz;
    normals_.back()[kSectionRoll] = middle.imag() * nz - middle.real() * ny;
    rows_.push_back(middle);
  }
  rows_.insert(rows_.end(), inside.begin(), inside.end());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    direct_.emplace_back(rows_[i], ends, i < points_.size() ? static_cast<int>(i) : -1);
    mirrored_.emplace_back(std::conj(rows_[i]), ends, -1);
  }
}

std::size_t PanelMesh::num_rows(double wave_number, bool is_even) const {
  const double limit = is_even ? kFirstIrregularEven : kFirstIrregularOdd;
  return wave_number * ends_.back().imag() > limit ? rows_.size() : points_.size();
}

PanelMesh::Equations PanelMesh::equations(double wave_number, bool is_even,
                                          const std::vector<PanelInfluence>& direct,
                                          const std::vector<PanelInfluence>& mirrored) const {
  const std::size_t n = points_.size();
  const std::size_t m = num_rows(wave_number, is_even);
  const std::span<const SectionMode> of = modes(is_even);
  const double sign = is_even ? 1.0 : -1.0;
  Equations out;
  out.matrix.resize(m * n);
  out.right.assign(m * (of.size() + 2), 0.0);
  for (std::size_t i = 0; i < m; ++i) {
    const double weight = i < n ? 1.0 : kInsideWeight;
    for (std::size_t j = 0; j < n; ++j) {
      const PanelInfluence& a = direct[i * n + j];
      const PanelInfluence& b = mirrored[i * n + j];
      out.matrix[j * m + i] = weight * (a.normal + sign * b.normal + (i == j ? kPi : 0.0));
      const double potential = weight * (a.potential + sign * b.potential);
      for (std::size_t k = 0; k < of.size(); ++k) {
        out.right[k * m + i] += potential * normals_[j][of[k]];
      }
      if (j + 1 == n) {
        out.right[(of.size() + 1) * m + i] = potential;
      }
    }
    const double phase = wave_number * rows_[i].imag();
    const double standing = is_even ? std::cos(phase) : std::sin(phase);
    out.right[of.size() * m + i] = weight * std::exp(wave_number * rows_[i].real()) * standing;
  }
  for (std::size_t j = 0; j < n; ++j) {
    const Complex rise = std::exp(wave_number * ends_[j + 1]) - std::exp(wave_number * ends_[j]);
    const Complex integral = std::conj(directions_[j]) * rise / wave_number;
    out.wave_normal.push_back(is_even ? -rise.imag() : rise.real());
    out.wave_potential.push_back(is_even ? integral.real() : integral.imag());
  }
  return out;
}

void PanelMesh::solve(bool is_even, Equations& equations, PanelFlow& out) const {
  const std::size_t n = points_.size();
  const std::size_t m = equations.matrix.size() / n;
  const std::span<const SectionMode> of = modes(is_even);
  least_squares(equations.matrix, equations.right, m, n);
  const auto solution = [&](std::size_t c) {
    return std::span<const double>(equations.right).subspan(c * m, n);
  };
  // H = 2 oint (n - phi d/dn) wave ds = in_phase / (1 - 4 pi i beta)
  const std::span<const double> of_wave = solution(of.size());
  const Complex feedback(1.0, -4.0 * kPi * dot(equations.wave_normal, of_wave));
  // All waves of one symmetry have one phase. That of a flux out of the uppermost panel is nowhere zero, so
  // the sign against it changes only where an amplitude passes through zero. In long waves a section that
  // rises draws in water at the surface; a submerged one and one that sways press it out at the top.
  const double flux = equations.wave_potential.back() - dot(equations.wave_normal, solution(of.size() + 1));
  const double reference = is_even && ends_.back().real() >= 0.0 ? -flux : flux;
  for (std::size_t k = 0; k < of.size(); ++k) {
    double in_phase = -2.0 * dot(equations.wave_normal, solution(k));
    for (std::size_t j = 0; j < n; ++j) {
      in_phase += 2.0 * equations.wave_potential[j] * normals_[j][of[k]];
    }
    const Complex amplitude = in_phase / feedback;
    out.h[of[k]] = std::copysign(std::abs(amplitude), in_phase * reference);
    std::vector<Complex>& phi = out.phi[of[k]];
    phi.resize(n);
    for (std::size_t j = 0; j < n; ++j) {
      // to the time factor e^{+i omega t}: the conjugate
      phi[j] = std::conj(solution(k)[j] - Complex(0.0, 2.0 * kPi) * amplitude * of_wave[j]);
    }
    for (const SectionMode mode : of) {
      out.force[mode][of[k]] = force(phi, mode);
    }
  }
}

// Of both halves of the section.
Complex PanelMesh::force(const std::vector<Complex>& phi, SectionMode mode) const {
  Complex total = 0.0;
  for (std::size_t j = 0; j < phi.size(); ++j) {
    const double length = std::hypot(points_[j].ny_ds, points_[j].nz_ds);
    total += phi[j] * (2.0 * normals_[j][mode] * length);
  }
  return total;
}

PanelFlow PanelMesh::flow(double wave_number) const {
  std::vector<Complex> waves;
  for (const Complex end : ends_) {
    waves.push_back(std::exp(wave_number * end));
  }
  std::vector<PanelInfluence> direct;
  std::vector<PanelInfluence> mirrored;
  std::vector<PanelInfluence> row;
  for (std::size_t i = 0; i < num_rows(wave_number, true); ++i) {  // the even problem's are the more
    direct_[i].influence(wave_number, waves, row);
    direct.insert(direct.end(), row.begin(), row.end());
    mirrored_[i].influence(wave_number, waves, row);
    mirrored.insert(mirrored.end(), row.begin(), row.end());
  }
  PanelFlow out;
  for (const bool is_even : {true, false}) {
    Equations both = equations(wave_number, is_even, direct, mirrored);
    solve(is_even, both, out);
  }
  return out;
}

}  // namespace quickstrip
