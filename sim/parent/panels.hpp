// Straight panels on the half contour of a section, and points inside it.
//
// The contour is divided at its corners (a turn of more than 15 degrees, ends included unless the contour
// crosses the centre plane at a right angle), which stay ends of panels; between them the panels' ends lie on
// the contour and gather towards corners and the waterline, where the potential is not smooth (r^2/3 at a
// right angle, r^2 ln r at the waterline). Every part has an even number of panels, so that each second end
// makes a mesh of half the number.
#pragma once

#include <complex>
#include <vector>

#include "sim/parent/section_contour.hpp"

namespace quickstrip {

/// Ends of the panels, w = z + i y [m], in the order of the contour: `num_panels` or a few more, at least two
/// for each part between corners. num_panels >= 4.
std::vector<std::complex<double>> panel_ends(const SectionContour& contour, int num_panels);

/// Every second end.
std::vector<std::complex<double>> coarsened(const std::vector<std::complex<double>>& ends);

/// Points of the waterline inside the section, y >= 0; none if the section does not pierce the surface.
std::vector<std::complex<double>> interior_points(const SectionContour& contour);

}  // namespace quickstrip
