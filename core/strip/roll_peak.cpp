#include "core/strip/roll_peak.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "core/strip/roll_admittance.hpp"

namespace quickstrip {
namespace {

constexpr double kPanelWidth = 1.5;  // of half width + distance: Gauss with three points errs below 1e-3
// Error of a straight line relative to the peak. Where none exceeds the first (0.7 half widths between
// frequencies at resonance), errors of one sign and the other cancel, as a trapezoidal sum over a smooth peak
// does, to 2 exp(-2 pi/0.7) = 3e-4, and correcting a part of them would do harm.
constexpr double kWorthwhile = 0.5;
constexpr double kLeastGain = 1e-4;  // of the largest
constexpr std::size_t kPointsOfPanel = 3;
constexpr std::array<double, kPointsOfPanel> kPlace = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, kPointsOfPanel> kShare = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
// Of the wave at the ship's ends between frequencies [rad]: beyond it the load is no polynomial. Measured on
// the S-175: below, Lagrange through six errs by 0.1 % of the largest roll.
constexpr double kMostTurn = 0.7;
constexpr double kLeastHalfWidth = 1e-3;  // of the resonance: an undamped hull stays finite

double real_impedance(const LoadedHull& hull, double omega_e, double speed) {
  return roll_admittance(hull, omega_e, speed).impedance.real();
}

// Of one interval between wave frequencies, lengths in half widths of the peak.
struct Sight {
  double width = 0.0;
  double distance = 0.0;
  double error = 0.0;  // of a straight line, relative to the peak
  double gain = 0.0;   // area of that error times the share of roll that may come from here
};
using Sights = std::array<Sight, kMaxFrequencies>;

// omega_e is a parabola of omega, its slope 1 - bend omega: steepest at an end, its extreme may lie between.
Sight sight_of(const RollResonance& resonance, double bend, double from, double to, const Encounter& at_from,
               const Encounter& at_to) {
  const double we0 = at_from.frequency;
  const double we1 = at_to.frequency;
  if (at_from.is_low || at_to.is_low || (we0 < 0.0) != (we1 < 0.0)) {
    return {};
  }
  const double slope0 = 1.0 - bend * from;
  const double slope1 = 1.0 - bend * to;
  double lowest = std::min(std::fabs(we0), std::fabs(we1));
  double highest = std::max(std::fabs(we0), std::fabs(we1));
  if (slope0 * slope1 < 0.0) {
    const double extreme = std::fabs(0.5 / bend);
    lowest = std::min(lowest, extreme);
    highest = std::max(highest, extreme);
  }
  Sight sight;
  sight.width = std::max(std::fabs(slope0), std::fabs(slope1)) * (to - from) / resonance.half_width;
  sight.distance =
      std::max({0.0, lowest - resonance.omega, resonance.omega - highest}) / resonance.half_width;
  const double nearness = 1.0 + sight.distance * sight.distance;
  sight.error = sight.width * sight.width / (nearness * nearness);
  return sight;
}

std::size_t panels_of(const Sight& sight) {
  constexpr std::size_t kMostPanels = kMaxPeakPoints / kPointsOfPanel;
  constexpr auto kMost = static_cast<double>(kMostPanels);
  const double panels = std::ceil(sight.width / (kPanelWidth * (1.0 + sight.distance)));
  return static_cast<std::size_t>(std::clamp(panels, 1.0, kMost));
}

// Of the error over an interval of `width` rad/s, in rad/s times the peak. A straight line over a curve of
// curvature 1: width^3 / 12; at most it misses the whole peak, pi/2.
double area_of_error(const Sight& sight, double width) {
  const double in_half_widths = std::min(0.5 * kPi, sight.width * sight.error / 12.0);
  return sight.width > 0.0 ? in_half_widths * width / sight.width : 0.0;
}

// How much roll each frequency may make: of a sea's slope what reaches roll, relative to the largest. So the
// points go where roll is, in seas long and short: a spectrum of slopes is flat to begin with.
std::array<double, kMaxFrequencies> roll_shares(std::span<const double> omega,
                                                std::span<const LateralLoad> loads) {
  std::array<double, kMaxFrequencies> out{};
  for (std::size_t f = 0; f < omega.size(); ++f) {
    const double slope = omega[f] * omega[f];
    out[f] = std::norm(loads[f][1]) / (slope * slope);
  }
  const double largest = *std::max_element(out.begin(), out.end());
  for (std::size_t f = 0; f < omega.size(); ++f) {
    out[f] *= largest > 0.0 ? 1.0 / largest : 0.0;
  }
  return out;
}

// Around an interval: in short waves the load passes through zero every few frequencies, and both ends of the
// interval may lie there.
double largest_near(std::span<const double> share, std::size_t j) {
  const std::size_t first = j > 1 ? j - 2 : 0;
  const std::size_t last = std::min(j + 3, share.size() - 1);
  double out = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    out = std::max(out, share[i]);
  }
  return out;
}

// The intervals that gain most, within the capacities.
using Panels = std::array<std::size_t, kMaxFrequencies>;

Panels choose_panels(Sights& sights) {
  Panels panels{};
  double least = 0.0;
  std::size_t left = kMaxPeakPoints / kPointsOfPanel;
  for (std::size_t n = 0; n < kMaxPeakIntervals && left > 0; ++n) {
    auto* const best = std::max_element(sights.begin(), sights.end(),
                                        [](const Sight& a, const Sight& b) { return a.gain < b.gain; });
    if (!(best->gain > least)) {
      break;
    }
    least = std::max(least, kLeastGain * best->gain);
    const std::size_t taken = std::min(panels_of(*best), left);
    panels[static_cast<std::size_t>(best - sights.begin())] = taken;
    left -= taken;
    best->gain = 0.0;
  }
  return panels;
}

void place_points(std::span<const double> omega, const Panels& panels, RollPeak& out) {
  for (std::size_t j = 0; j + 1 < omega.size(); ++j) {
    if (panels[j] == 0) {
      continue;
    }
    QS_CHECK(out.intervals.push_back({static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(out.num_points),
                                      static_cast<std::uint8_t>(panels[j] * kPointsOfPanel)}));
    const double width = (omega[j + 1] - omega[j]) / static_cast<double>(panels[j]);
    for (std::size_t p = 0; p < panels[j]; ++p) {
      for (std::size_t i = 0; i < kPointsOfPanel; ++i) {
        out.omega[out.num_points] =
            static_cast<float>(omega[j] + width * (static_cast<double>(p) + kPlace[i]));
        out.weight[out.num_points] = static_cast<float>(width * kShare[i]);
        ++out.num_points;
      }
    }
  }
}

void place_peak(const LoadedHull& hull, EncounterAngle mu, std::span<const double> omega,
                const PeakSpeed& speed) {
  QS_CHECK(speed.encounters.size() == omega.size() && speed.loads.size() == omega.size());
  speed.out->clear();
  const double bend = 2.0 * speed.terms.speed * std::cos(mu.radians) / hull.gravity;
  Sights sights{};
  bool is_worthwhile = false;
  for (std::size_t j = 0; j + 1 < omega.size(); ++j) {
    sights[j] =
        sight_of(speed.resonance, bend, omega[j], omega[j + 1], speed.encounters[j], speed.encounters[j + 1]);
    is_worthwhile = is_worthwhile || sights[j].error > kWorthwhile;
  }
  if (!is_worthwhile) {
    return;
  }
  const std::array<double, kMaxFrequencies> share = roll_shares(omega, speed.loads);
  for (std::size_t j = 0; j + 1 < omega.size(); ++j) {
    sights[j].gain = area_of_error(sights[j], omega[j + 1] - omega[j]) *
                     largest_near(std::span(share).first(omega.size()), j);
  }
  place_points(omega, choose_panels(sights), *speed.out);
}

// Frequencies first ... first + count - 1 around the interval from j: up to six, all on its side of the
// encounter-frequency floor, where the loads have a kink.
constexpr std::size_t kMostNodes = 6;
struct Stencil {
  std::size_t first = 0;
  std::size_t count = 2;
};

Stencil stencil_around(std::span<const Encounter> row, std::size_t j) {
  const auto is_alike = [&](std::size_t i) {
    return !row[i].is_low && (row[i].frequency < 0.0) == (row[j].frequency < 0.0);
  };
  std::size_t first = j;
  std::size_t last = j + 1;
  for (std::size_t n = 2; n < kMostNodes; ++n) {
    const bool can_go_down = first > 0 && is_alike(first - 1);
    const bool can_go_up = last + 1 < row.size() && is_alike(last + 1);
    if (can_go_down && (!can_go_up || j - first <= last - j - 1)) {
      --first;
    } else if (can_go_up) {
      ++last;
    }
  }
  return {first, last - first + 1};
}

// Loads at the points of an interval: Lagrange through the frequencies of the stencil.
void interpolate_loads(std::span<const double> omega, const PeakSpeed& speed, const PeakInterval& interval) {
  const Stencil stencil = stencil_around(speed.encounters, interval.node);
  std::array<double, kMostNodes> by_distances{};
  for (std::size_t i = 0; i < stencil.count; ++i) {
    double product = 1.0;
    for (std::size_t n = 0; n < stencil.count; ++n) {
      product *= n == i ? 1.0 : omega[stencil.first + i] - omega[stencil.first + n];
    }
    by_distances[i] = 1.0 / product;
  }
  for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
    const auto at = static_cast<double>(speed.out->omega[p]);
    LateralLoad load{};
    for (std::size_t i = 0; i < stencil.count; ++i) {
      double weight = by_distances[i];
      for (std::size_t n = 0; n < stencil.count; ++n) {
        weight *= n == i ? 1.0 : at - omega[stencil.first + n];
      }
      for (std::size_t k = 0; k < load.size(); ++k) {
        load[k] += weight * speed.loads[stencil.first + i][k];
      }
    }
    speed.at_points[p] = load;
  }
}

// The interval from wave frequency j, or null.
const PeakInterval* interval_at(const RollPeak& peak, std::size_t j) {
  const auto* const found = std::find_if(peak.intervals.begin(), peak.intervals.end(),
                                         [j](const PeakInterval& i) { return i.node == j; });
  return found == peak.intervals.end() ? nullptr : found;
}

// Loads at the points of the intervals from wave frequency j, section by section. Speeds that have as many
// panels there have their points at the same frequencies: each is one wave.
void sum_loads(const LoadedHull& hull, const DirectionWaves& waves, EncounterAngle mu, std::size_t j,
               std::span<const PeakSpeed> speeds, WaveWork& work) {
  std::array<const PeakInterval*, kMaxSpeeds> interval{};
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    interval[v] = interval_at(*speeds[v].out, j);
  }
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    if (interval[v] == nullptr) {
      continue;
    }
    const std::size_t count = interval[v]->count;
    for (std::size_t p = 0; p < count; ++p) {
      const auto omega = static_cast<double>(speeds[v].out->omega[interval[v]->first + p]);
      set_lateral_wave_between(hull, waves, mu, j, omega, work);
      const double k_cos_mu = wave_number(omega, hull.gravity) * std::cos(mu.radians);
      for (std::size_t u = v; u < speeds.size(); ++u) {
        if (interval[u] != nullptr && interval[u]->count == count) {
          const double speed = speeds[u].terms.speed;
          speeds[u].at_points[interval[u]->first + p] =
              lateral_load(hull, omega - k_cos_mu * speed, speed, work);
        }
      }
    }
    for (std::size_t u = v + 1; u < speeds.size(); ++u) {  // done
      if (interval[u] != nullptr && interval[u]->count == count) {
        interval[u] = nullptr;
      }
    }
  }
}

// Sway, roll and yaw at every point, two at a time. False: one is not finite.
bool solve_points(const LoadedHull& hull, const ShipTerms& ship, EncounterAngle mu, const PeakSpeed& speed,
                  std::array<LengthIntegrals, 2>& outside) {
  RollPeak& out = *speed.out;
  const double cos_mu = std::cos(mu.radians);
  bool finite = true;
  MotionPair at{};
  at.speed = both(speed.terms.speed);
  for (std::size_t first = 0; first < out.num_points; first += 2) {
    ThreePair load;
    const std::array<std::size_t, 2> points = {first, std::min(first + 1, out.num_points - 1)};
    for (std::size_t l = 0; l < 2; ++l) {
      const auto omega = static_cast<double>(out.omega[points[l]]);
      at.omega_e[l] = met_wave(hull, omega, cos_mu).at(speed.terms.speed).floored;
      for (std::size_t r = 0; r < 3; ++r) {
        load[r].re[l] = speed.at_points[points[l]][r].real();
        load[r].im[l] = speed.at_points[points[l]][r].imag();
      }
    }
    const std::array<NodeStencil, 2> nodes = node_stencils(hull, at.omega_e);
    for (std::size_t l = 0; l < 2; ++l) {
      at.integrals[l] = length_stencil(hull, nodes[l], at.omega_e[l], outside[l]);
    }
    const ThreePair motion = solve_lateral(ship, at, both(speed.terms.roll_damping), load);
    for (std::size_t l = 0; l < 2; ++l) {
      for (std::size_t i = 0; i < kPeakModes.size(); ++i) {
        const Complex value = lane(motion[i], static_cast<int>(l));
        finite = finite && std::isfinite(value.real()) && std::isfinite(value.imag());
        out.re[i][points[l]] = static_cast<float>(value.real());
        out.im[i][points[l]] = static_cast<float>(value.imag());
      }
    }
  }
  return finite;
}

}  // namespace

RollResonance roll_resonance(const LoadedHull& hull, double speed) {
  const double natural = hull.roll_natural_frequency;
  double low = 0.5 * natural;
  double high = 2.0 * natural;
  if (real_impedance(hull, low, speed) > 0.0 && real_impedance(hull, high, speed) < 0.0) {
    for (int i = 0; i < 30; ++i) {  // 2 natural / 2^30: far below any width
      const double middle = 0.5 * (low + high);
      (real_impedance(hull, middle, speed) > 0.0 ? low : high) = middle;
    }
  } else {
    low = natural;
    high = natural;
  }
  const double omega = 0.5 * (low + high);
  const double step = 1e-3 * omega;
  const double slope =
      (real_impedance(hull, omega + step, speed) - real_impedance(hull, omega - step, speed)) / (2.0 * step);
  const double width = std::fabs(roll_admittance(hull, omega, speed).impedance.imag() / slope);
  const double widest = omega;
  return {omega, std::isfinite(width) ? std::clamp(width, kLeastHalfWidth * omega, widest) : widest};
}

bool solve_roll_peaks(const LoadedHull& hull, const ShipTerms& ship, EncounterAngle mu,
                      const DirectionWaves& waves, std::span<const PeakSpeed> speeds, WaveWork& work) {
  const std::span<const double> omega = waves.omega;
  QS_CHECK(omega.size() >= 4 && omega.size() <= kMaxFrequencies && speeds.size() <= kMaxSpeeds);
  for (const PeakSpeed& speed : speeds) {
    place_peak(hull, mu, omega, speed);
  }
  for (std::size_t j = 0; j + 1 < omega.size(); ++j) {
    if (turn_between(hull, mu, omega[j], omega[j + 1]) > kMostTurn) {
      sum_loads(hull, waves, mu, j, speeds, work);
      continue;
    }
    for (const PeakSpeed& speed : speeds) {
      if (const PeakInterval* const interval = interval_at(*speed.out, j); interval != nullptr) {
        interpolate_loads(omega, speed, *interval);
      }
    }
  }
  return std::all_of(speeds.begin(), speeds.end(), [&](const PeakSpeed& speed) {
    return solve_points(hull, ship, mu, speed, work.outside);
  });
}

}  // namespace quickstrip
