// Which criterion governs where on the polar: regions of neighbouring cells with one governing criterion, a
// letter for each, and the place of the letter. Only cells of caution and exceeded count: a good cell needs
// no reason.
#pragma once

#include <string>
#include <vector>

#include "quickstrip/grid_t.hpp"
#include "quickstrip/limits_t.hpp"

namespace quickstrip {

/// "R" for the only roll criterion; "V1", "V2" where several criteria share a quantity. One per criterion.
std::vector<std::string> criterion_letters(const limits_t& limits);

/// One region: its criterion, the cell nearest to its centroid, and its area in knots squared.
struct GoverningRegion {
  int criterion = -1;
  int speed = 0;    // index
  int heading = 0;  // index
  double area = 0.0;
};

std::vector<GoverningRegion> governing_regions(const grid_t& grid);

/// The criterion to show for a cell: its governing one, -1 where it is good or not known.
int shown_criterion(const grid_t& grid, int speed, int heading);

}  // namespace quickstrip
