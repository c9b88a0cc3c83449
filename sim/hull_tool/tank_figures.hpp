// What a towing tank measured on a model in regular waves, and what strip theory has for it.
//
// The file (CSV): fn, quantity, abscissa, measured; optionally hull, the name of the model that the line is
// of, and mu_deg (180, head waves, where the column is missing). All dimensionless, L = lpp, V volume:
//   at frequencies of encounter, abscissa omega_e sqrt(L/g):
//     a33 = A33 / (rho V), b33 = B33 / (rho V) sqrt(L/g), b55 = B55 / (rho V L^2) sqrt(L/g)
//   at wave lengths, abscissa lambda / L:
//     x3 = |X3| / (C33 zeta), x5 = |X5| / (k C55 zeta), heave = z / zeta, pitch = theta / (2 pi zeta / L),
//     pitch_slope = theta / (k zeta)
//   added_resistance = R / (rho g zeta^2 B^2 / L), the largest of the curve over 0.6 ... 3 L: no abscissa.
// Motions are those of G. Known of all strip theories: at speed A55 of slender hulls lies 30 % below the tank
// and B55 grows with V^2, which it does not there; judge by heave and by wave loads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/strip/loaded_hull.hpp"

namespace quickstrip::hull_tool {

enum class TankQuantity : std::uint8_t {
  kA33,
  kB33,
  kB55,
  kX3,
  kX5,
  kHeave,
  kPitch,
  kPitchSlope,
  kAddedResistance
};

struct TankFigure {
  double fn = 0.0;
  double mu_deg = 180.0;
  TankQuantity quantity = TankQuantity::kHeave;
  std::optional<double> abscissa;  // none: the largest of the curve
  double measured = 0.0;
};

std::string_view name_of(TankQuantity quantity);

/// The figures of `model`, in the order of the file; of all lines where the file has no column hull. Throws
/// InputError, naming the line, or the models of the file if `model` is none of them.
std::vector<TankFigure> read_tank_file(const std::string& path, const std::string& model);

/// The figure as `hull` has it.
double computed_figure(const LoadedHull& hull, const TankFigure& figure);

/// A curve: figures of one Froude number, direction and quantity.
struct TankCurve {
  double fn = 0.0;
  double mu_deg = 180.0;
  TankQuantity quantity = TankQuantity::kHeave;
  int num_figures = 0;
  std::optional<double> peak_abscissa{};  // where the largest measured value is
  double peak_measured = 0.0;
  double peak_computed = 0.0;      // the largest over the same abscissae
  double peak_miss_percent = 0.0;  // of peak_measured, as all below
  double rms_percent = 0.0;        // of computed - measured
  double worst_percent = 0.0;      // signed
};

/// In the order in which they first come; `computed` beside `figures`, one by one.
std::vector<TankCurve> tank_curves(const std::vector<TankFigure>& figures,
                                   const std::vector<double>& computed);

}  // namespace quickstrip::hull_tool
