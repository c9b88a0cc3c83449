// What was measured or computed elsewhere of a cylinder at the surface, and what a section method has for it.
//
// The file (CSV): quantity, abscissa, measured; optionally section, the name of the cylinder that the line is
// of. Deep water, no speed, waves from abeam; abscissa omega sqrt(B / 2g); A area, O waterline and centre
// plane:
//   a22, a33 = a / (rho A), a24 / (rho A B), a44 / (rho A B^2), b.. the same times sqrt(B / 2g)
//   x2 = |F2| / (rho g k A zeta), f2, f3 = |F| / (rho g B zeta), x4 = |F4| / (rho g k B^3 / 12 zeta) about O
// Loads are the undisturbed wave's on the polygon and the diffraction's by Green's theorem
// (section_flow.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip::hull_tool {

enum class SectionQuantity : std::uint8_t {
  kA22,
  kB22,
  kA33,
  kB33,
  kA24,
  kB24,
  kA44,
  kB44,
  kX2,
  kF2,
  kF3,
  kX4
};

struct SectionFigure {
  SectionQuantity quantity = SectionQuantity::kA33;
  double abscissa = 0.0;
  double measured = 0.0;
};

std::string_view name_of(SectionQuantity quantity);

/// The figures of `section`, in the order of the file. Throws InputError, naming the line.
std::vector<SectionFigure> read_section_figures(const std::string& path, const std::string& section);

/// A half contour from a CSV file: columns y_m, z_m, from the keel to the waterline, z from the waterline,
/// up. Throws InputError.
SectionContour read_contour_file(const std::string& path);

/// Wave number of the figure's oscillation [1/m].
double wave_number_of(const SectionContour& contour, const SectionFigure& figure);

/// The figure by a solution at its wave number.
double computed_figure(const SectionContour& contour, const SectionFlow& flow, SectionQuantity quantity);

}  // namespace quickstrip::hull_tool
