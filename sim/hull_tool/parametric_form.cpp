#include "sim/hull_tool/parametric_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip::hull_tool {
namespace {

// Of lpp: tenths and twentieths, closer at the ends.
constexpr std::array kStations = {0.0,  0.0125, 0.025, 0.05, 0.075, 0.1,  0.15,  0.2,    0.25,
                                  0.3,  0.35,   0.4,   0.45, 0.5,   0.55, 0.6,   0.65,   0.7,
                                  0.75, 0.8,    0.85,  0.9,  0.925, 0.95, 0.975, 0.9875, 1.0};
constexpr double kFinestSection = 0.55;  // above the re-entrant limit of Lewis forms for H0 up to 6
constexpr int kCurvePoints = 20;         // on the curved part of a section
constexpr int kMaxSteps = 40;
constexpr double kDone = 1.0e-7;
constexpr double kDifference = 1.0e-4;
constexpr double kRound = 1000.0;  // offsets to the millimetre

double rounded(double metres) {
  return std::round(kRound * metres) / kRound;
}

/// Distance from the full part, 0 ... 1 at the perpendicular; aft negative.
double from_full_part(const ParametricForm& form, double part) {
  return part < form.full_from ? (part - form.full_from) / form.full_from
         : part > form.full_to ? (part - form.full_to) / (1.0 - form.full_to)
                               : 0.0;
}

double curve(double t, double end_aft, double end_fore, double power_aft, double power_fore) {
  return t < 0.0 ? 1.0 - (1.0 - end_aft) * std::pow(-t, power_aft)
                 : 1.0 - (1.0 - end_fore) * std::pow(t, power_fore);
}

double half_breadth(const ParametricForm& form, const CurveOfBreadth& of, double part) {
  const double t = from_full_part(form, part);
  return 0.5 * form.breadth * curve(t, of.end_aft, of.end_fore, of.power_aft, of.power_fore);
}

/// Area under a superellipse, of the rectangle around it.
double superellipse_fullness(double p) {
  const double g = std::tgamma(1.0 + 1.0 / p);
  return g * g / std::tgamma(1.0 + 2.0 / p);
}

double superellipse_power(double fullness) {
  double low = 0.3;
  double high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    (superellipse_fullness(p) < fullness ? low : high) = p;
  }
  return 0.5 * (low + high);
}

void add(Station& station, double y, double z) {
  QS_CHECK(station.offsets.push_back({y, z}));
}

/// From (0, keel) to (y, draught) with this share of the rectangle.
void add_immersed(Station& station, double y, double keel, double draught, double fullness) {
  const double t = draught - keel;
  constexpr double kEllipse = kPi / 4.0;
  const bool has_flat = fullness > kEllipse;

  const double bilge = has_flat ? std::sqrt(std::max(0.0, 1.0 - fullness) / (1.0 - kEllipse)) : 1.0;
  const double power = has_flat ? 2.0 : superellipse_power(fullness);
  if (has_flat) {
    add(station, 0.0, keel);
  }
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double angle = 0.5 * kPi * i / kCurvePoints;
    const double across = i == kCurvePoints ? 1.0 : std::pow(std::sin(angle), 2.0 / power);
    const double up = i == kCurvePoints ? 1.0 : 1.0 - std::pow(std::cos(angle), 2.0 / power);
    add(station, y * (1.0 - bilge + bilge * across), keel + t * bilge * up);
  }
  if (has_flat) {
    add(station, y, draught);
  }
}

void round_all(Hull& hull) {
  for (Station& station : hull.stations) {
    station.x = rounded(station.x);
    for (Offset& point : station.offsets) {
      point = {rounded(point.y), rounded(point.z)};
    }
  }
}

Station station_at(const ParametricForm& form, double part, double area_aft, double area_fore) {
  Station station;
  station.x = part * form.lpp;
  const double y = half_breadth(form, form.waterline, part);
  const double area = form.cm * form.breadth * form.draught *
                      curve(from_full_part(form, part), form.area_end_aft, 0.0, area_aft, area_fore);
  const double deck_y = std::max(y, half_breadth(form, form.deck, part));
  const double s = 2.0 * part - 1.0;
  const double deck_z = form.depth + (s < 0.0 ? form.sheer_aft : form.sheer_fore) * s * s;
  if (y > 1.0e-9 * form.breadth) {
    const double t = std::min(form.draught, area / (kFinestSection * 2.0 * y));
    add_immersed(station, y, form.draught - t, form.draught, area / (2.0 * y * t));
  } else {
    add(station, 0.0, 0.0);  // the stem
    add(station, 0.0, form.draught);
  }
  add(station, deck_y, deck_z);
  return station;
}

Status float_form(const ParametricForm& form, std::array<double, 2> powers, Hull& hull,
                  ImmersedSections& sections, std::array<double, 2>& miss) {
  hull.stations.clear();
  for (const double part : kStations) {
    QS_CHECK(hull.stations.push_back(station_at(form, part, powers[0], powers[1])));
  }
  if (const Status cut = immerse(hull, hull.loading, sections); !cut) {
    return cut;
  }
  const auto floated = hydrostatics(hull, hull.loading, sections);
  if (!floated) {
    return floated.error();
  }
  miss = {floated->cb - form.cb, (floated->lcb - form.lcb) / form.lpp};
  return {};
}

}  // namespace

Status shape_hull(const ParametricForm& form, Hull& out) {
  out.lpp = form.lpp;
  out.breadth = form.breadth;
  out.loading.draught_aft = form.draught;
  out.loading.draught_fwd = form.draught;
  const auto sections = std::make_unique<ImmersedSections>();
  std::array<double, 2> powers = {2.0, 2.5};
  for (int step = 0; step < kMaxSteps; ++step) {
    std::array<double, 2> miss{};
    std::array<double, 2> aft{};
    std::array<double, 2> fore{};
    const std::array<double, 2> more_aft = {powers[0] + kDifference, powers[1]};
    const std::array<double, 2> more_fore = {powers[0], powers[1] + kDifference};
    for (const auto& [at, result] : {std::pair{more_aft, &aft}, {more_fore, &fore}, {powers, &miss}}) {
      if (const Status floated = float_form(form, at, out, *sections, *result); !floated) {
        return floated;
      }
    }
    const double a = (aft[0] - miss[0]) / kDifference;
    const double b = (fore[0] - miss[0]) / kDifference;
    const double d = (aft[1] - miss[1]) / kDifference;
    const double e = (fore[1] - miss[1]) / kDifference;
    const double determinant = a * e - b * d;
    const double change_aft = (miss[0] * e - b * miss[1]) / determinant;
    const double change_fore = (a * miss[1] - d * miss[0]) / determinant;
    if (std::fabs(miss[0]) < kDone && std::fabs(miss[1]) < kDone) {
      round_all(out);
      return {};
    }
    powers[0] = std::clamp(powers[0] - change_aft, 0.5, 8.0);
    powers[1] = std::clamp(powers[1] - change_fore, 0.5, 8.0);
  }
  return Error::kOutOfRange;
}

}  // namespace quickstrip::hull_tool
