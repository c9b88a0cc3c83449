// The ships of [Journee1992] §5 and of the Delft experiments whose lines are given by formulas: our own
// tanker and trawler of the paper's sizes, and the four Wigley hulls of report 0909.
//
// Tanker: particulars of the 200,000 t tanker of Dutch model tests, from memory ([Oortmerssen1976],
// [Pinkster1980]; not read in the original): 310 x 47.17 x 18.90 m, 234,994 m3, centre of buoyancy 6.61 m
// forward of midship, KG 13.32 m, gyradii 14.77, 77.47, 79.30 m; her GM, 5.78 m, checks ours. Trawler:
// lengths are the paper's, proportions those of side and stern trawlers of her time (L/B 3.8, B/T 2.4, CB
// 0.56), GM twice the 0.35 m that IMO asks of fishing vessels. Lines, deck and places of both are ours.
#pragma once

#include <array>
#include <string_view>

#include "core/hull/hull.hpp"

namespace quickstrip::hull_tool {

inline constexpr std::array<std::string_view, 6> kParametricShips = {"tanker",    "trawler",    "wigley-i",
                                                                     "wigley-ii", "wigley-iii", "wigley-iv"};

/// `which`: one of kParametricShips. Returns the comment for the head of the file.
std::string_view make_parametric_ship(std::string_view which, Hull& out);

/// Half-breadth of Wigley hull 1 ... 4 [m]; X from amidships, Z depth below the waterline [m].
double wigley_form(int which, double from_midship, double depth);

}  // namespace quickstrip::hull_tool
