#include "core/strip/ikeda_damping.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"
#include "core/strip/hydrodynamic_coefficients.hpp"
#include "core/strip/ikeda_section.hpp"

namespace quickstrip {
namespace {

constexpr double kMostBroughtIn = 0.5;  // of the eddies' damping

// The ship's measures in the source's signs.
struct Measures {
  double length = 0.0;
  double breadth = 0.0;
  double draught = 0.0;
  double cb = 0.0;
  double cm = 0.0;
  double og_down = 0.0;
};

Measures measures(const LoadedHull& hull) {
  const auto first = hull.half_breadth.begin();
  const auto last = first + static_cast<std::ptrdiff_t>(hull.num_sections);
  return {.length = hull.lpp,
          .breadth = 2.0 * *std::max_element(first, last),
          .draught = hull.hydrostatics.draught_at_lcb,
          .cb = hull.hydrostatics.cb,
          .cm = hull.hydrostatics.cm,
          .og_down = -hull.g_height};  // NOTATION.md: OG up +
}

// Kato: C_F = 1.328 Re^-1/2, Re = 0.512 (r amplitude)^2 omega / nu, so the amplitude drops out.
double friction(const Measures& ship, double density, double viscosity) {
  const double surface = ship.length * (1.7 * ship.draught + ship.cb * ship.breadth);
  const double radius = ((0.887 + 0.145 * ship.cb) * surface / ship.length - 2.0 * ship.og_down) / kPi;
  return 4.0 / (3.0 * kPi) * density * surface * radius * radius * 1.328 * std::sqrt(viscosity / 0.512);
}

double lift(const Measures& ship, double density) {
  const double l0 = 0.3 * ship.draught;
  const double lr = 0.5 * ship.draught;
  const double slope =
      kTwoPi * ship.draught / ship.length + lift_kappa(ship.cm) * (4.1 * ship.breadth / ship.length - 0.045);
  const double og = ship.og_down;
  return 0.5 * density * ship.length * ship.draught * slope * l0 * lr *
         (1.0 - 1.4 * og / lr + 0.7 * og * og / (l0 * lr));
}

struct Eddies {
  double all = 0.0;
  double brought_in = 0.0;  // of sections that were
};

Eddies eddies(const LoadedHull& hull, double og_down) {
  Eddies out;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const ImmersedSection& s = hull.immersed[i];
    const IkedaSection section = ikeda_section(s.breadth, s.draught, s.area, og_down);
    const double part = hull.weight[i] * eddy_damping(section, hull.density);
    out.all += part;
    out.brought_in += section.brought_into_range ? part : 0.0;
  }
  return out;
}

// Calls f(section, keel, length) along the keel. Breadth, draught and area run straight between stations, and
// four places a panel are taken: the pressure is no straight line of them. Beyond the stations is no keel.
template <typename F>
void along_the_keel(const LoadedHull& hull, const BilgeKeel& keel, F&& f) {
  constexpr int kPlaces = 4;
  for (std::size_t i = 0; i + 1 < hull.num_sections; ++i) {
    const ImmersedSection& aft = hull.immersed[i];
    const ImmersedSection& fore = hull.immersed[i + 1];
    const double from = std::max(aft.x, keel.x_aft);
    const double to = std::min(fore.x, keel.x_fwd);
    if (!(to > from)) {
      continue;
    }
    const double length = (to - from) / kPlaces;
    for (int n = 0; n < kPlaces; ++n) {
      const double t = (from + (n + 0.5) * length - aft.x) / (fore.x - aft.x);
      const auto between = [t](double a, double b) { return a + t * (b - a); };
      const IkedaSection section =
          ikeda_section(between(aft.breadth, fore.breadth), between(aft.draught, fore.draught),
                        between(aft.area, fore.area), -hull.g_height);
      f(section, ikeda_keel(section, keel.breadth), length);
    }
  }
}

void set_keel(const LoadedHull& hull, const BilgeKeel& keel, RollDampingModel& model) {
  along_the_keel(hull, keel, [&](const IkedaSection& section, const IkedaKeel& at, double length) {
    const KeelNormalDamping normal = keel_normal_damping(at, hull.density);
    model.keel_normal_0 += length * normal.constant;
    model.keel_normal_1 += length * normal.per_amplitude;
    for (std::size_t n = 0; n < RollAmplitudeNodes::kCount; ++n) {
      const double amplitude = RollAmplitudeNodes::kStep * static_cast<double>(n);
      model.keel_pressure[n] += length * keel_pressure_damping(section, at, amplitude, hull.density);
    }
  });
}

// E[a^2 P(a)] / E[a^2] over Rayleigh-distributed amplitudes a = rms r: weight r^3/2 exp(-r^2/2), by Simpson's
// rule to r = 6, beyond which 3e-7 of it lies.
void set_gaussian_pressure(RollDampingModel& model) {
  constexpr int kPanels = 48;
  constexpr double kStep = 6.0 / kPanels;
  for (std::size_t n = 0; n < RollAmplitudeNodes::kCount; ++n) {
    const double rms = 0.5 * RollAmplitudeNodes::kStep * static_cast<double>(n);
    double sum = 0.0;
    for (int i = 1; i <= kPanels; ++i) {
      const double r = kStep * i;
      const double simpson = i == kPanels ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      const double pressure = roll_damping_components(model, 0.0, rms * r, 1.0).keel_pressure;
      sum += simpson * kStep / 3.0 * 0.5 * r * r * r * std::exp(-0.5 * r * r) * pressure;
    }
    model.keel_pressure_gaussian[n] = sum;
  }
}

void set_wave_damping(const LoadedHull& hull, const Measures& ship, RollDampingModel& model) {
  model.draught = ship.draught;
  model.gravity = hull.gravity;
  for (std::size_t n = 1; n < RollAmplitudeNodes::kCount; ++n) {
    const double omega = kWaveNodeStep * static_cast<double>(n) * model.natural_frequency;
    const double still = hydrodynamic_coefficients(hull, omega, 0.0).b[3][3];
    model.wave_still[n] = still;
    model.wave_per_speed[n] = hydrodynamic_coefficients(hull, omega, 1.0).b[3][3] - still;  // linear in V
  }
}

bool is_between(double value, double least, double most) {
  return value >= least && value <= most;
}

// [Kawahara2009]
std::uint16_t outside_range(const Measures& ship, const std::optional<BilgeKeel>& keel, const Eddies& eddy) {
  unsigned out = 0;
  const auto flag_unless = [&out](bool inside, RollDampingRange bit) { out |= inside ? 0u : unsigned{bit}; };
  flag_unless(is_between(ship.cb, 0.5, 0.85), kOutsideBlockCoefficient);
  flag_unless(is_between(ship.cm, 0.9, 0.99), kOutsideMidshipCoefficient);
  flag_unless(is_between(ship.breadth / ship.draught, 2.5, 4.5), kOutsideBreadthDraught);
  flag_unless(is_between(ship.og_down / ship.draught, -1.5, 0.2), kOutsideCentreOfGravity);
  flag_unless(eddy.brought_in <= kMostBroughtIn * eddy.all, kOutsideSectionFullness);
  if (keel) {
    const double length = keel->x_fwd - keel->x_aft;
    flag_unless(is_between(keel->breadth / ship.breadth, 0.01, 0.06), kOutsideKeelBreadth);
    flag_unless(is_between(length / ship.length, 0.05, 0.4), kOutsideKeelLength);
  }
  return static_cast<std::uint16_t>(out);
}

}  // namespace

double lift_kappa(double midship_coefficient) {
  const double above = std::clamp(midship_coefficient - 0.91, 0.0, 0.09);
  return 106.0 * above * above - 700.0 * above * above * above;
}

double keel_pressure_damping(const LoadedHull& hull, const BilgeKeel& keel, double amplitude) {
  double sum = 0.0;
  along_the_keel(hull, keel, [&](const IkedaSection& section, const IkedaKeel& at, double length) {
    sum += length * keel_pressure_damping(section, at, amplitude, hull.density);
  });
  return sum;
}

Result<RollDampingModel> ikeda_roll_damping(const LoadedHull& hull, const std::optional<BilgeKeel>& keel,
                                            double viscosity) {
  const Measures ship = measures(hull);
  const Eddies eddy = eddies(hull, ship.og_down);
  RollDampingModel model;
  model.natural_frequency = hull.roll_natural_frequency;
  model.lpp = ship.length;
  model.frequency_scale = std::sqrt(ship.breadth / (2.0 * hull.gravity));
  model.friction = friction(ship, hull.density, viscosity);
  model.eddy = eddy.all;
  model.lift = lift(ship, hull.density);
  model.outside_range = outside_range(ship, keel, eddy);
  if (keel) {
    set_keel(hull, *keel, model);
    set_gaussian_pressure(model);
  }
  set_wave_damping(hull, ship, model);
  const double greatest = RollAmplitudeNodes::kLast;
  const double all = added_roll_damping(model, 1.0, greatest, 1.0) +
                     added_roll_damping_gaussian(model, 1.0, 0.5 * greatest, 1.0);
  return std::isfinite(all) && model.friction > 0.0 ? Result<RollDampingModel>(model) : Error::kNotFinite;
}

}  // namespace quickstrip
