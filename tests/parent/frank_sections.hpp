// Contours that the tests of the panel method share, and the comparison of two solutions.
#pragma once

#include <cmath>
#include <complex>

#include "core/base/constants.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip::test {

/// y = M {(1+a1) sin t - a3 sin 3t}, z = -M {(1-a1) cos t + a3 cos 3t}, M = 1, as a polygon.
inline SectionContour lewis_contour(double a1, double a3, int num_sides) {
  SectionContour contour;
  for (int i = 0; i <= num_sides; ++i) {
    const double t = 0.5 * kPi * i / num_sides;
    contour.points.push_back({(1.0 + a1) * std::sin(t) - a3 * std::sin(3.0 * t),
                              -(1.0 - a1) * std::cos(t) - a3 * std::cos(3.0 * t)});
  }
  contour.points.front().y = 0.0;
  contour.points.back().z = 0.0;
  return contour;
}

inline SectionContour semicircle(double radius, int num_sides) {
  SectionContour contour = lewis_contour(0.0, 0.0, num_sides);
  for (Offset& p : contour.points) {
    p = {radius * p.y, radius * p.z};
  }
  return contour;
}

inline SectionContour rectangle(double half_breadth, double draught) {
  return {{{0.0, -draught}, {half_breadth, -draught}, {half_breadth, 0.0}}};
}

/// Ellipse of half axes a (horizontal), c (vertical), its centre `depth` below the surface.
inline SectionContour submerged_ellipse(double a, double c, double depth, int num_sides) {
  SectionContour contour;
  for (int i = 0; i <= num_sides; ++i) {
    const double t = kPi * i / num_sides;
    contour.points.push_back({a * std::sin(t), -depth - c * std::cos(t)});
  }
  contour.points.front().y = 0.0;
  contour.points.back().y = 0.0;
  return contour;
}

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
