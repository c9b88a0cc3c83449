#include "sim/hull_tool/motion_spline.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/angles.hpp"
#include "core/base/interpolation.hpp"
#include "sim/section_table/linear_solve.hpp"

namespace quickstrip::hull_tool {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t kPaperFrequencies = 18;
constexpr double kPaperStep = 0.1;   // rad/s
constexpr std::size_t kCurves = 12;  // two of each motion

/// The curves of a motion, one after the other: [curve][node].
std::vector<double> curves_of(const std::vector<MotionTransfer>& motions, bool by_amplitude) {
  const std::size_t n = motions.size();
  std::vector<double> curves(kCurves * n);
  for (std::size_t j = 0; j < 6; ++j) {
    double phase = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const Complex h = motions[i].motion[j];
      phase = i == 0 ? std::arg(h) : phase + wrap_pi(std::arg(h) - phase);  // the nearest turn
      curves[2 * j * n + i] = by_amplitude ? std::abs(h) : h.real();
      curves[(2 * j + 1) * n + i] = by_amplitude ? phase : h.imag();
    }
  }
  return curves;
}

}  // namespace

std::vector<double> paper_frequencies() {
  std::vector<double> out;
  for (std::size_t i = 1; i <= kPaperFrequencies; ++i) {
    out.push_back(kPaperStep * static_cast<double>(i));
  }
  return out;
}

std::vector<double> paper_frequencies_filled() {
  std::vector<double> out;
  for (std::size_t i = 3; i <= 3 * kPaperFrequencies; ++i) {
    out.push_back(kPaperStep * static_cast<double>(i) / 3.0);
  }
  return out;
}

std::vector<MotionTransfer> spline_motions(const std::vector<double>& nodes,
                                           const std::vector<MotionTransfer>& motions,
                                           const std::vector<double>& at, bool by_amplitude) {
  const std::size_t n = nodes.size();
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const SplineStencil stencil = spline_stencil(nodes, nodes[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      matrix[i * n + stencil.first + k] = stencil.weight[k];
    }
  }
  std::vector<double> coefficients = curves_of(motions, by_amplitude);
  solve_in_place(matrix, coefficients, n, kCurves);
  std::vector<MotionTransfer> out(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const SplineStencil stencil = spline_stencil(nodes, at[i]);
    const auto value = [&](std::size_t curve) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += stencil.weight[k] * coefficients[curve * n + stencil.first + k];
      }
      return sum;
    };
    for (std::size_t j = 0; j < 6; ++j) {
      const double first = value(2 * j);
      const double second = value(2 * j + 1);
      // A spline of amplitudes may dip below zero: not an amplitude.
      out[i].motion[j] = by_amplitude ? std::polar(std::max(0.0, first), second) : Complex(first, second);
    }
  }
  return out;
}

}  // namespace quickstrip::hull_tool
