// Flow about a section that is the conformal image of a circle: the Lewis form of a section, or the close fit
// of its contour. Multipole solution in all modes (sim/section_table/multipole_solver.hpp: what it assumes,
// its range and its error). Cost: 0.1 ms once a section; 0.3 ... 0.4 ms a frequency for a ship's section.
#pragma once

#include "core/hull/lewis_section.hpp"
#include "sim/parent/section_flow.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {

class MappedSection {
 public:
  /// Coefficients of a conformal mapping (is_conformal), its scale M [m] > 0.
  MappedSection(const MappingCoefficients& a, double scale);

  /// K = omega^2 / g > 0 [1/m]; several threads may ask. Not converged where 192 multipoles do not settle
  /// every value within 1e-4.
  [[nodiscard]] SectionFlow flow(double wave_number) const;

 private:
  MultipoleSection section_;
  double scale_;
};

/// Of the Lewis form as it is (hydrodynamic_lewis_section gives one that has a flow).
MappedSection mapped_section(const LewisSection& section);
SectionFlow lewis_flow(const LewisSection& section, double wave_number);

}  // namespace quickstrip
