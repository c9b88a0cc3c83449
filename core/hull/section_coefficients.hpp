// The eight two-dimensional coefficients of a section oscillating in the surface, normalised.
#pragma once

namespace quickstrip {

/// Dimensionless: a22, a33 by rho A; a24 by rho A B; a44 by rho A B^2; b the same times sqrt(B/2g).
/// A, B are those of the section that was used. About O (waterline, centre plane), z up (NOTATION.md):
/// force = -(a v' + b v); a24 = a42 > 0 for deep narrow sections.
struct SectionCoefficients {
  double a22 = 0.0;
  double b22 = 0.0;
  double a33 = 0.0;
  double b33 = 0.0;
  double a44 = 0.0;
  double b44 = 0.0;
  double a24 = 0.0;
  double b24 = 0.0;
};

}  // namespace quickstrip
