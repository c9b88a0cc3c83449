// Contours that the tests of the panel method share, and the comparison of two solutions.
#pragma once

#include <cmath>

#include "core/base/constants.hpp"
#include "sim/parent/section_contour.hpp"

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

}  // namespace quickstrip::test
