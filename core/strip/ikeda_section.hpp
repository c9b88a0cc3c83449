// Roll damping of one section after Ikeda, Himeno and Tanaka: eddies shed at the bilge, and a bilge keel's
// own force and its pressure on the hull. [Ikeda1978] as restated by [ITTC2011].
//
// A section is known by its breadth, draught and area: Lewis form for the velocities, and a bilge radius that
// takes from a rectangle what the area lacks. Moments are quadratic in the roll rate; what is given here is
// their linear equivalent by equal energy over a period of harmonic roll, per metre of length.
// OG here as in the source: POSITIVE WHERE G LIES BELOW THE WATERLINE, opposite to NOTATION.md; whoever makes
// an IkedaSection turns the sign.
// Derived again where formulas §5 leaves doubt: the velocity at the bilge is that of the double body's flow,
// (2M/sqrt(H)) |a1 (1+a3) - 2 a3 exp(2 i psi)|, which equals the printed polynomials A0, B0; the integrals of
// the pressure are checked against a quadrature along the girth (tests/strip/ikeda_section_test.cpp).
// Range: cylinders of H0 0.5 ... 1.3, sigma 0.43 ... 1.0 measured [Ikeda1978]; ships fuller than sigma 0.99
// have less than sharp-edged cylinders do (a quarter of it, KVLCC2): see ikeda_section().
// Expected error of C_R: a quarter, for 13 of 16 measured cylinders; the slackest (C_R 0.06) has four times
// ours. Cost: below 0.3 us each.
#pragma once

namespace quickstrip {

struct IkedaSection {
  double breadth = 0.0;  // m
  double draught = 0.0;  // m
  double h0 = 0.0;
  double sigma = 0.0;
  double a1 = 0.0;
  double a3 = 0.0;
  double og_down = 0.0;       // depth of G below the waterline [m]
  double bilge_radius = 0.0;  // m
  bool brought_into_range = false;
};

/// The fullest section that is computed as it is. Above, a sharp edge is assumed ever more violently, which
/// ships with a bilge radius do not have.
inline constexpr double kGreatestIkedaSigma = 0.99;

/// Breadth and draught as they are but H0 at least 0.01; sigma brought up to the re-entrant limit, or down to
/// `greatest_sigma` (1 for a sharp-edged cylinder as it is); OG at most 0.8 sigma draught, so that a part of
/// the section lies below G. All lengths > 0 but the breadth >= 0, area > 0 [m, m2].
IkedaSection ikeda_section(double breadth, double draught, double area, double og_down,
                           double greatest_sigma = kGreatestIkedaSigma);

/// R [m] = 2 d sqrt(H0 (1 - sigma) / (4 - pi)), at most d or B/2.
double ikeda_bilge_radius(double breadth, double draught, double sigma);

/// C_R of eddies >= 0: moment = 1/2 rho d^4 C_R |rate| rate per metre. Where the printed formula goes below
/// zero (shallow, wide, slack sections) it is zero: eddies give no energy.
double eddy_coefficient(const IkedaSection& section);

/// Linear equivalent of eddies: times omega and amplitude [N s2/rad]. rho: kg/m3.
double eddy_damping(const IkedaSection& section, double density);

/// A bilge keel of breadth b [m] on each side at this section.
struct IkedaKeel {
  double lever = 0.0;     // from G to the keel [m]
  double velocity = 1.0;  // f: over the undisturbed one
  double breadth = 0.0;   // m
};
IkedaKeel ikeda_keel(const IkedaSection& section, double breadth);

/// Normal force, per metre: omega (constant + per_amplitude amplitude).
struct KeelNormalDamping {
  double constant = 0.0;       // N s2
  double per_amplitude = 0.0;  // N s2/rad
};
KeelNormalDamping keel_normal_damping(const IkedaKeel& keel, double density);

/// Pressure on the hull, per metre and omega [N s2], at a roll amplitude >= 0 [rad]. Ours: the low pressure
/// behind the keel ends where the waterline or the centre plane is reached.
double keel_pressure_damping(const IkedaSection& section, const IkedaKeel& keel, double amplitude,
                             double density);

/// Moments of unit pressure about G in d^2 [-]: of a uniform one behind the keel over `length` of girth [m],
/// and of one that falls from the keel to nothing at the waterline and the centre plane.
double uniform_pressure_moment(const IkedaSection& section, double length);
double falling_pressure_moment(const IkedaSection& section);

}  // namespace quickstrip
