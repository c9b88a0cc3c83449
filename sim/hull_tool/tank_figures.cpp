#include "sim/hull_tool/tank_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "core/sea/dispersion.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/csv_file.hpp"
#include "sim/hull_tool/parametric_ships.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr std::array<std::string_view, 8> kQuantityNames = {"a33", "b33",   "b55",   "x3",
                                                            "x5",  "heave", "pitch", "added_resistance"};
constexpr std::array<std::string_view, 4> kHullNames = {"I", "II", "III", "IV"};
constexpr double kTankGravity = 9.81;

/// A head wave of one length at one speed.
struct HeadWave {
  double k = 0.0;
  double omega = 0.0;
  double omega_e = 0.0;
  double speed = 0.0;
};

HeadWave head_wave(const LoadedHull& hull, double lambda_over_length, double fn) {
  HeadWave wave;
  wave.k = kTwoPi / (lambda_over_length * hull.lpp);
  wave.omega = std::sqrt(hull.gravity * wave.k);
  wave.speed = fn * std::sqrt(hull.gravity * hull.lpp);
  wave.omega_e = wave.omega + wave.k * wave.speed;
  return wave;
}

std::array<Complex, 6> head_loads(const LoadedHull& hull, const HeadWave& wave) {
  const bool haskind = hull.method.loads == DiffractionLoads::kHaskind;
  BeamSeaCorrection correction;
  if (haskind) {
    beam_sea_correction(hull, wave.omega, correction);
  }
  SectionWaves sections;
  section_waves(hull, wave.omega, EncounterAngle{kPi}, sections);
  WaveField field;
  wave_field(hull, wave.omega, EncounterAngle{kPi}, sections, haskind ? &correction : nullptr, field);
  SectionHydrodynamics section;
  section_hydrodynamics(hull, wave.omega_e, section);
  return wave_loads(hull, field, section, wave.omega_e, wave.speed);
}

double coefficient(const LoadedHull& hull, const TankFigure& figure) {
  const double root = std::sqrt(hull.lpp / hull.gravity);
  const double speed = figure.fn * std::sqrt(hull.gravity * hull.lpp);
  const auto h = hydrodynamic_coefficients(hull, *figure.abscissa / root, speed);
  switch (figure.quantity) {
    case TankQuantity::kA33:
      return h.a[2][2] / hull.body.mass;
    case TankQuantity::kB33:
      return h.b[2][2] / hull.body.mass * root;
    default:
      return h.b[4][4] / (hull.body.mass * hull.lpp * hull.lpp) * root;
  }
}

double largest_added_resistance(const LoadedHull& hull, double fn) {
  constexpr int kLengths = 240;
  constexpr double kFrom = 0.6;
  constexpr double kStep = 0.01;  // of L: 0.1 % of a peak that is a tenth of L wide
  double largest = 0.0;
  for (int i = 0; i <= kLengths; ++i) {
    const HeadWave wave = head_wave(hull, kFrom + kStep * i, fn);
    const MotionTransfer motion = motion_transfer(hull, wave.omega, EncounterAngle{kPi}, wave.speed);
    largest = std::max(largest, added_resistance(hull, wave.omega, EncounterAngle{kPi}, wave.speed, motion));
  }
  return largest / (hull.density * hull.gravity * hull.breadth * hull.breadth / hull.lpp);
}

std::size_t index_of(const CsvFile& file, std::size_t column, std::string_view name,
                     std::span<const std::string_view> known) {
  const auto at = std::find(known.begin(), known.end(), file.field(column));
  if (at == known.end()) {
    file.refuse(
        fmt::format("{} = {}: one of {} is wanted", name, file.field(column), fmt::join(known, ", ")));
  }
  return static_cast<std::size_t>(at - known.begin());
}

}  // namespace

std::string_view wigley_numeral(int hull) {
  return kHullNames[static_cast<std::size_t>(hull - 1)];
}

std::string_view name_of(TankQuantity quantity) {
  return kQuantityNames[static_cast<std::size_t>(quantity)];
}

std::vector<TankFigure> read_tank_file(const std::string& path) {
  CsvFile file(path);
  const std::size_t hull = file.column({"hull"});
  const std::size_t fn = file.column({"fn"});
  const std::size_t quantity = file.column({"quantity"});
  const std::size_t abscissa = file.column({"abscissa"});
  const std::size_t measured = file.column({"measured"});
  for (const std::size_t column : {hull, fn, quantity, abscissa, measured}) {
    if (column == CsvFile::kNone) {
      file.refuse("the header names its columns: hull, fn, quantity, abscissa, measured");
    }
  }
  std::vector<TankFigure> figures;
  while (file.next_line()) {
    TankFigure figure;
    figure.hull = static_cast<int>(index_of(file, hull, "hull", kHullNames)) + 1;
    figure.fn = file.number(fn, "fn", {0.0, 0.5});
    figure.quantity = static_cast<TankQuantity>(index_of(file, quantity, "quantity", kQuantityNames));
    if (figure.quantity != TankQuantity::kAddedResistance) {
      figure.abscissa = file.number(abscissa, "abscissa", {0.1, 20.0});
    }
    figure.measured = file.number(measured, "measured", {1e-6, 1000.0});
    figures.push_back(figure);
  }
  if (figures.empty()) {
    throw InputError{path + ": holds no figure"};
  }
  return figures;
}

void load_wigley(int which, const StripMethod& method, LoadedHull& out) {
  const auto hull = std::make_unique<Hull>();
  static_cast<void>(make_parametric_ship(kParametricShips[static_cast<std::size_t>(which) + 1], *hull));
  hull->loading.gravity = kTankGravity;
  const Status status = load(*hull, hull->loading, method, out);
  if (!status) {
    throw InputError{fmt::format("{}: {}", hull->name.view(), message(status.error()))};
  }
}

double computed_figure(const LoadedHull& hull, const TankFigure& figure) {
  if (figure.quantity <= TankQuantity::kB55) {
    return coefficient(hull, figure);
  }
  if (figure.quantity == TankQuantity::kAddedResistance) {
    return largest_added_resistance(hull, figure.fn);
  }
  const HeadWave wave = head_wave(hull, *figure.abscissa, figure.fn);
  switch (figure.quantity) {
    case TankQuantity::kX3:
      return std::abs(head_loads(hull, wave)[2]) / hull.restoring.c33;
    case TankQuantity::kX5:
      return std::abs(head_loads(hull, wave)[4]) / (wave.k * hull.restoring.c55);
    default:
      break;
  }
  const auto motion = motion_transfer(hull, wave.omega, EncounterAngle{kPi}, wave.speed).motion;
  return figure.quantity == TankQuantity::kHeave ? std::abs(motion[2])
                                                 : std::abs(motion[4]) * hull.lpp / kTwoPi;
}

}  // namespace quickstrip::hull_tool
