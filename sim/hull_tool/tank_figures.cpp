#include "sim/hull_tool/tank_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sea/dispersion.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/csv_file.hpp"
#include "sim/hull_tool/measured_file.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr std::array<std::string_view, 9> kQuantityNames = {
    "a33", "b33", "b55", "x3", "x5", "heave", "pitch", "pitch_slope", "added_resistance"};

/// A regular wave of one length and direction, met at one speed.
struct TankWave {
  double k = 0.0;
  double omega = 0.0;
  double omega_e = 0.0;
  double speed = 0.0;
  EncounterAngle mu{kPi};
};

TankWave tank_wave(const LoadedHull& hull, double lambda_over_length, double fn, double mu_deg) {
  TankWave wave;
  wave.k = kTwoPi / (lambda_over_length * hull.lpp);
  wave.omega = std::sqrt(hull.gravity * wave.k);
  wave.speed = fn * std::sqrt(hull.gravity * hull.lpp);
  wave.mu = EncounterAngle{wrap_pi(radians(mu_deg))};
  wave.omega_e = encounter_frequency(wave.omega, wave.k, wave.speed, wave.mu);
  return wave;
}

std::array<Complex, 6> loads_of(const LoadedHull& hull, const TankWave& wave) {
  WaveField field;
  wave_field(hull, wave.omega, wave.mu, field);
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

double largest_added_resistance(const LoadedHull& hull, double fn, double mu_deg) {
  constexpr int kLengths = 240;
  constexpr double kFrom = 0.6;
  constexpr double kStep = 0.01;  // of L: 0.1 % of a peak that is a tenth of L wide
  double largest = 0.0;
  for (int i = 0; i <= kLengths; ++i) {
    const TankWave wave = tank_wave(hull, kFrom + kStep * i, fn, mu_deg);
    const MotionTransfer motion = motion_transfer(hull, wave.omega, wave.mu, wave.speed);
    largest = std::max(largest, added_resistance(hull, wave.omega, wave.mu, wave.speed, motion));
  }
  return largest / (hull.density * hull.gravity * hull.breadth * hull.breadth / hull.lpp);
}

TankQuantity quantity_of(const CsvFile& file, std::string_view name) {
  const auto at = std::find(kQuantityNames.begin(), kQuantityNames.end(), name);
  if (at == kQuantityNames.end()) {
    file.refuse(fmt::format("quantity = {}: one of {} is wanted", name, fmt::join(kQuantityNames, ", ")));
  }
  return static_cast<TankQuantity>(at - kQuantityNames.begin());
}

struct Columns {
  std::size_t fn = CsvFile::kNone;
  std::size_t mu = CsvFile::kNone;
  std::size_t quantity = CsvFile::kNone;
  std::size_t abscissa = CsvFile::kNone;
  std::size_t measured = CsvFile::kNone;
};

Columns find_columns(const CsvFile& file) {
  Columns c;
  c.fn = file.column({"fn"});
  c.mu = file.column({"mu_deg"});
  c.quantity = file.column({"quantity"});
  c.abscissa = file.column({"abscissa"});
  c.measured = file.column({"measured"});
  for (const std::size_t column : {c.fn, c.quantity, c.abscissa, c.measured}) {
    if (column == CsvFile::kNone) {
      file.refuse("the header names its columns: fn, quantity, abscissa, measured, and perhaps hull, mu_deg");
    }
  }
  return c;
}

TankFigure figure_of(const CsvFile& file, const Columns& c) {
  TankFigure figure;
  figure.fn = file.number(c.fn, "fn", {0.0, 1.0});
  if (c.mu != CsvFile::kNone) {
    figure.mu_deg = file.number(c.mu, "mu_deg", {-360.0, 360.0});
  }
  figure.quantity = quantity_of(file, file.field(c.quantity));
  if (figure.quantity != TankQuantity::kAddedResistance) {
    figure.abscissa = file.number(c.abscissa, "abscissa", {0.1, 20.0});
  }
  figure.measured = file.number(c.measured, "measured", {1e-6, 1000.0});
  return figure;
}

}  // namespace

std::string_view name_of(TankQuantity quantity) {
  return kQuantityNames[static_cast<std::size_t>(quantity)];
}

std::vector<TankFigure> read_tank_file(const std::string& path, const std::string& model) {
  CsvFile file(path);
  const Columns columns = find_columns(file);
  return figures_of_model<TankFigure>(file, path, "hull", model,
                                      [&](const CsvFile& line) { return figure_of(line, columns); });
}

double computed_figure(const LoadedHull& hull, const TankFigure& figure) {
  if (figure.quantity <= TankQuantity::kB55) {
    return coefficient(hull, figure);
  }
  if (figure.quantity == TankQuantity::kAddedResistance) {
    return largest_added_resistance(hull, figure.fn, figure.mu_deg);
  }
  const TankWave wave = tank_wave(hull, *figure.abscissa, figure.fn, figure.mu_deg);
  switch (figure.quantity) {
    case TankQuantity::kX3:
      return std::abs(loads_of(hull, wave)[2]) / hull.restoring.c33;
    case TankQuantity::kX5:
      return std::abs(loads_of(hull, wave)[4]) / (wave.k * hull.restoring.c55);
    default:
      break;
  }
  const auto motion = motion_transfer(hull, wave.omega, wave.mu, wave.speed).motion;
  switch (figure.quantity) {
    case TankQuantity::kHeave:
      return std::abs(motion[2]);
    case TankQuantity::kPitchSlope:
      return std::abs(motion[4]) / wave.k;
    default:
      return std::abs(motion[4]) * hull.lpp / kTwoPi;
  }
}

std::vector<TankCurve> tank_curves(const std::vector<TankFigure>& figures,
                                   const std::vector<double>& computed) {
  std::vector<TankCurve> curves;
  const auto curve_of = [&](const TankFigure& f) {
    const auto same = [&](const TankCurve& c) {
      return c.fn == f.fn && c.mu_deg == f.mu_deg && c.quantity == f.quantity;
    };
    const auto at = std::find_if(curves.begin(), curves.end(), same);
    if (at != curves.end()) {
      return at;
    }
    curves.push_back({.fn = f.fn, .mu_deg = f.mu_deg, .quantity = f.quantity});
    return curves.end() - 1;
  };
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto curve = curve_of(figures[i]);
    ++curve->num_figures;
    if (figures[i].measured > curve->peak_measured) {
      curve->peak_abscissa = figures[i].abscissa;
      curve->peak_measured = figures[i].measured;
    }
    curve->peak_computed = std::max(curve->peak_computed, computed[i]);
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto curve = curve_of(figures[i]);
    const double percent = 100.0 * (computed[i] - figures[i].measured) / curve->peak_measured;
    curve->rms_percent += percent * percent / curve->num_figures;
    if (std::fabs(percent) >= std::fabs(curve->worst_percent)) {
      curve->worst_percent = percent;
    }
  }
  for (TankCurve& curve : curves) {
    curve.rms_percent = std::sqrt(curve.rms_percent);
    curve.peak_miss_percent = 100.0 * (curve.peak_computed / curve.peak_measured - 1.0);
  }
  return curves;
}

}  // namespace quickstrip::hull_tool
