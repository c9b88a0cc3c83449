// What a towing tank measured on the Wigley hulls in head waves, and what strip theory has for it.
//
// The file: hull (I ... IV), fn, quantity, abscissa, measured; dimensionless, quantities and abscissae as in
// the header of tests/golden/wigley_tank.csv. g 9.81 m/s2, fresh water; loads and motions at wave lengths,
// added mass and damping at frequencies of encounter; added resistance by its peak over wave lengths of 0.6
// ... 3 L. Known of all strip theories: at speed A55 lies 30 % below the tank and B55 grows with V^2, which
// it does not there; judge by heave and by wave loads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/strip/loaded_hull.hpp"

namespace quickstrip::hull_tool {

enum class TankQuantity : std::uint8_t { kA33, kB33, kB55, kX3, kX5, kHeave, kPitch, kAddedResistance };

struct TankFigure {
  int hull = 1;  // 1 ... 4
  double fn = 0.0;
  TankQuantity quantity = TankQuantity::kHeave;
  std::optional<double> abscissa;  // none: the largest of the curve
  double measured = 0.0;
};

/// "I" ... "IV".
std::string_view wigley_numeral(int hull);

std::string_view name_of(TankQuantity quantity);

/// Throws InputError, naming the line.
std::vector<TankFigure> read_tank_file(const std::string& path);

/// Wigley hull 1 ... 4 in the tank.
void load_wigley(int which, const StripMethod& method, LoadedHull& out);

/// The figure as `hull` has it.
double computed_figure(const LoadedHull& hull, const TankFigure& figure);

}  // namespace quickstrip::hull_tool
