#include "sim/parent/mapped_flow.hpp"

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr double kTolerance = 1e-4;
constexpr int kMostMultipoles = 192;
// Loads from 64 points differ by less than 1e-6 from those of 240 (tests/parent).
constexpr int kNumPoints = 64;

}  // namespace

MappedSection::MappedSection(const MappingCoefficients& a, double scale) : section_(a), scale_(scale) {
  QS_CHECK(scale > 0.0 && is_conformal(a));
}

SectionFlow MappedSection::flow(double wave_number) const {
  PotentialStrengths strengths;
  const SectionSolution s =
      section_.solve_adaptive(wave_number * scale_, kTolerance, kMostMultipoles, &strengths);
  const double m = scale_;
  SectionFlow flow;
  flow.wave_number = wave_number;
  flow.a22 = m * m * s.a22;
  flow.a24 = m * m * m * s.a24;
  flow.a44 = m * m * m * m * s.a44;
  flow.a33 = m * m * s.a33;
  flow.h2 = m * s.h2;
  flow.h4 = m * m * s.h4;
  flow.h3 = m * s.h3;
  flow.is_converged = s.converged;
  for (const HullPotential& p : hull_potentials(section_.harmonics(), strengths, kNumPoints)) {
    // To the time factor e^{+i omega t}: the conjugate.
    flow.points.push_back({.y = m * p.y,
                           .z = m * p.z,
                           .ny_ds = m * p.ny_ds,
                           .nz_ds = m * p.nz_ds,
                           .phi = {m * std::conj(p.phi[kSectionSway]), m * std::conj(p.phi[kSectionHeave]),
                                   m * m * std::conj(p.phi[kSectionRoll])}});
  }
  return flow;
}

MappedSection mapped_section(const LewisSection& section) {
  return {lewis_mapping(section.a1, section.a3), section.scale};
}

SectionFlow lewis_flow(const LewisSection& section, double wave_number) {
  return mapped_section(section).flow(wave_number);
}

}  // namespace quickstrip
