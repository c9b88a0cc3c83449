#include "core/strip/ikeda_section.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/constants.hpp"
#include "core/hull/lewis_section.hpp"

namespace quickstrip {
namespace {

constexpr double kLeastH0 = 0.01;           // S-175 at the forward perpendicular: 0.011
constexpr double kAboveReentrant = 1.0001;  // of sigma, as lewis_section.cpp
constexpr double kMostBelowG = 0.8;
constexpr double kEqualEnergy = 8.0 / (3.0 * kPi);  // of |rate| rate, times the rate's amplitude
constexpr double kSquareCorner =
    1.0 - 0.70710678118654752;                  // 1 - 1/sqrt(2), of the radius: keel in the corner
constexpr double kTan22 = 0.41421356237309505;  // sqrt(2) - 1

// Greatest distance from O of the contour outside the waterline, and the speed of the double body's flow
// there, both in the mapping scale M, per unit of roll rate.
struct BilgeFlow {
  double radius = 0.0;
  double velocity = 0.0;
};

BilgeFlow bilge_flow(double a1, double a3) {
  const auto radius_at = [&](double psi) {
    return std::hypot((1.0 + a1) * std::sin(psi) - a3 * std::sin(3.0 * psi),
                      (1.0 - a1) * std::cos(psi) + a3 * std::cos(3.0 * psi));
  };
  double psi = 0.0;
  const double cosine = a3 != 0.0 ? a1 * (1.0 + a3) / (4.0 * a3) : 2.0;
  if (std::fabs(cosine) <= 1.0) {
    const double off_the_keel = 0.5 * std::acos(cosine);
    psi = radius_at(off_the_keel) > radius_at(0.0) ? off_the_keel : 0.0;
  }
  const double h = 1.0 + a1 * a1 + 9.0 * a3 * a3 + 2.0 * a1 * (1.0 - 3.0 * a3) * std::cos(2.0 * psi) -
                   6.0 * a3 * std::cos(4.0 * psi);
  constexpr double kCusp = 1e-12;  // of H, so that a cusp has a large velocity and no division by zero
  const double flow = std::abs(a1 * (1.0 + a3) - 2.0 * a3 * std::polar(1.0, 2.0 * psi));
  return {radius_at(psi), 2.0 * flow / std::sqrt(std::max(h, kCusp))};
}

}  // namespace

double ikeda_bilge_radius(double breadth, double draught, double sigma) {
  const double h0 = breadth / (2.0 * draught);
  const double radius = 2.0 * draught * std::sqrt(h0 * std::max(0.0, 1.0 - sigma) / (4.0 - kPi));
  return std::min(radius, std::min(draught, 0.5 * breadth));
}

IkedaSection ikeda_section(double breadth, double draught, double area, double og_down,
                           double greatest_sigma) {
  IkedaSection out;
  out.draught = draught;
  out.breadth = std::max(breadth, 2.0 * kLeastH0 * draught);
  out.h0 = out.breadth / (2.0 * draught);
  const double own = area / (out.breadth * draught);
  const double lowest = std::min(kAboveReentrant * reentrant_limit(out.h0), greatest_sigma);
  out.sigma = std::clamp(own, lowest, greatest_sigma);
  out.brought_into_range = out.sigma != own || out.breadth != breadth;
  out.og_down = std::min(og_down, kMostBelowG * out.sigma * draught);
  const Result<LewisSection> form = lewis_section(out.breadth, draught, out.sigma * out.breadth * draught);
  if (form) {
    out.a1 = form->a1;
    out.a3 = form->a3;
  }
  out.bilge_radius = ikeda_bilge_radius(out.breadth, draught, out.sigma);
  return out;
}

double eddy_coefficient(const IkedaSection& s) {
  const double d = s.draught;
  const double og = s.og_down / d;
  const double lacking = 1.0 - s.sigma;
  const double sine = std::sin(kPi * s.sigma);
  const double f1 = 0.5 * (1.0 + std::tanh(20.0 * (s.sigma - 0.7)));
  const double f2 =
      0.5 * (1.0 - std::cos(kPi * s.sigma)) - 1.5 * (1.0 - std::exp(-5.0 * lacking)) * sine * sine;
  const double f3 = 1.0 + 4.0 * std::exp(-1.65e5 * lacking * lacking);

  const BilgeFlow flow = bilge_flow(s.a1, s.a3);
  const double scale = 0.5 * s.breadth / (1.0 + s.a1 + s.a3);  // M
  const double r_max = scale * flow.radius;
  const double depth_below_g = 1.0 - og;
  const double h0_below_g = s.h0 / depth_below_g;
  const double sigma_below_g = (s.sigma - og) / depth_below_g;
  const double mean_radius = 2.0 * d * depth_below_g * std::sqrt(h0_below_g * sigma_below_g / kPi);
  const double gamma = f3 * (r_max + scale * flow.velocity) / mean_radius;  // greatest over mean velocity
  const double pressure = 0.5 * (0.87 * std::exp(-gamma) - 4.0 * std::exp(-0.187 * gamma) + 3.0);  // C_P

  const double r = f1 * s.bilge_radius / d;
  const double lever = (1.0 - r) * (depth_below_g - r) + f2 * (s.h0 - r) * (s.h0 - r);
  const double reach = r_max / d;
  return std::max(0.0, reach * reach * lever * pressure);
}

double eddy_damping(const IkedaSection& section, double density) {
  const double d2 = section.draught * section.draught;
  return kEqualEnergy * 0.5 * density * d2 * d2 * eddy_coefficient(section);
}

IkedaKeel ikeda_keel(const IkedaSection& section, double breadth) {
  const double inset = kSquareCorner * section.bilge_radius / section.draught;
  const double og = section.og_down / section.draught;
  IkedaKeel out;
  out.breadth = breadth;
  out.lever = section.draught * std::hypot(section.h0 - inset, 1.0 - og - inset);
  out.velocity = 1.0 + 0.3 * std::exp(-160.0 * (1.0 - section.sigma));
  return out;
}

// C_D = 22.5 b / (pi l amplitude f) + 2.4, of a pair: its first part makes the damping linear.
KeelNormalDamping keel_normal_damping(const IkedaKeel& keel, double density) {
  const double of_drag = kEqualEnergy * density * keel.breadth * keel.lever * keel.lever * keel.lever *
                         keel.velocity * keel.velocity;
  return {of_drag * 22.5 * keel.breadth / (kPi * keel.lever * keel.velocity), of_drag * 2.4};
}

double uniform_pressure_moment(const IkedaSection& section, double length) {
  const double d = section.draught;
  const double m1 = section.bilge_radius / d;
  const double m3 = 1.0 - m1 - section.og_down / d;
  const double m4 = section.h0 - m1;
  const double straight = length / d - 0.25 * kPi * m1;  // beyond the bilge's arc
  if (straight > 0.0) {
    const double m7 = std::min({straight, 1.0 - m1, m4});
    return (m3 + m4) * (m7 + kTan22 * m1) - m7 * m7;
  }
  return (m3 + m4) * std::sqrt(2.0) * m1 * (1.0 - std::cos(length / section.bilge_radius));
}

double falling_pressure_moment(const IkedaSection& section) {
  const double h0 = section.h0;
  const double m1 = section.bilge_radius / section.draught;
  const double m2 = section.og_down / section.draught;
  const double m3 = 1.0 - m1 - m2;
  const double m4 = h0 - m1;
  const double girth_to_centre = h0 - 0.215 * m1;  // 0.215 = 1 - pi/4
  const double girth_to_waterline = 1.0 - 0.215 * m1;
  const double both = girth_to_centre * girth_to_waterline;
  const double m5 = (0.414 * h0 + 0.0651 * m1 * m1 - (0.382 * h0 + 0.0106) * m1) / both;
  const double m6 = (0.414 * h0 + 0.0651 * m1 * m1 - (0.382 + 0.0106 * h0) * m1) / both;
  return m4 * m4 * m4 / (3.0 * girth_to_centre) +
         (1.0 - m1) * (1.0 - m1) * (2.0 * m3 - m2) / (6.0 * girth_to_waterline) + m1 * (m3 * m5 + m4 * m6);
}

double keel_pressure_damping(const IkedaSection& section, const IkedaKeel& keel, double amplitude,
                             double density) {
  const double l = keel.lever;
  const double f = keel.velocity;
  const double d = section.draught;
  // Both coefficients times the amplitude: C_P- = -22.5 b / (pi l f amplitude) - 1.2 stays finite so.
  const double front = 1.2 * amplitude;
  const double behind = 22.5 * keel.breadth / (kPi * l * f) + 1.2 * amplitude;
  const double length_behind = 0.3 * kPi * f * l * amplitude + 1.95 * keel.breadth;  // S0
  const double moment =
      uniform_pressure_moment(section, length_behind) * behind + falling_pressure_moment(section) * front;
  return std::max(0.0, kEqualEnergy * 0.5 * density * l * l * f * f * d * d * moment);
}

}  // namespace quickstrip
