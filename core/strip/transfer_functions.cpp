#include "core/strip/transfer_functions.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/static_vector.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/boundary_value.hpp"
#include "core/strip/empirical_added_resistance.hpp"
#include "core/strip/equations_of_motion.hpp"

namespace quickstrip {
namespace {

// Range of wave frequencies. Below 0.7 sqrt(g/L) (wave length 13 L) the ship follows the wave, and no sea of
// Tp below 25 s holds more than 1 % there for ships above 60 m; the upper end, wave length L/6 or 2.2 rad/s,
// keeps the wind sea of small ships' relative motion. What a sea holds outside is counted by place_on_grid().
constexpr double kLowestOmega = 0.19;   // rad/s, upper bound of the lower end
constexpr double kLowestFroude = 0.7;   // sqrt(g/L)
constexpr double kHighestOmega = 2.2;   // rad/s, lower bound of the upper end
constexpr double kHighestFroude = 6.0;  // sqrt(g/L)

// Nodes a rad/s, but for a factor. Even in ln(omega) they would lie closer than any response needs where the
// ship follows the wave, and too wide where waves of a third to the whole of her length make her loads swing:
// there they are even in omega.
constexpr double kDensityOfMiddle = 1.0;  // per froude frequency
constexpr double kEndOfMiddle = 5.5;      // froude frequencies: wave length L/5

double node_density(double omega, double froude_frequency) {
  const double x = omega / (kEndOfMiddle * froude_frequency);
  return 1.0 / omega + kDensityOfMiddle / froude_frequency / (1.0 + x * x * x * x);
}

// One wave at every speed, two at a time.
Status solve_wave(const LoadedHull& hull, std::size_t m, std::size_t f, TransferWorkspace& work,
                  TransferFunctions& out) {
  for (std::size_t first = 0; first < out.num_speeds; first += 2) {
    const std::array<std::size_t, 2> pair = {first, std::min(first + 1, out.num_speeds - 1)};
    const auto solved = solve_speeds(hull, work.ship, {work.terms[pair[0]], work.terms[pair[1]]}, work.wave);
    for (std::size_t l = 0; l < 2; ++l) {
      const std::size_t v = pair[l];
      const MotionTransfer& transfer = solved[l].transfer;
      if (!is_finite(transfer)) {
        return Error::kSingular;
      }
      store_motions(transfer.motion, f, out.row[v][m]);
      out.added_resistance[v][m][f] = static_cast<float>(solved[l].added_resistance);
      work.load[v][f] = solved[l].load;
      work.encounter[v][f] = {transfer.encounter_frequency, transfer.low_encounter};
    }
  }
  return {};
}

Status solve_peaks(const LoadedHull& hull, std::size_t m, TransferWorkspace& work, TransferFunctions& out) {
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    out.peak[v][m].clear();
  }
  if (m == 0 || m + 1 == kNumSolvedDirections) {
    return {};  // waves from astern and ahead do not roll her
  }
  const std::size_t n = out.num_frequencies;
  const bool has_diffraction = hull.method.loads != DiffractionLoads::kClassic;
  const DirectionWaves waves{std::span(out.omega).first(n), std::span(work.sections).first(n),
                             std::span(work.diffraction).first(has_diffraction ? n : 0)};
  StaticVector<PeakSpeed, kMaxSpeeds> speeds;
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    QS_CHECK(speeds.push_back({work.terms[v], work.resonance[v], std::span(work.encounter[v]).first(n),
                               std::span(work.load[v]).first(n), work.peak_load[v], &out.peak[v][m]}));
  }
  const bool solved = solve_roll_peaks(hull, work.ship, solved_angle(m), waves, speeds.span(), work.wave);
  return solved ? Status{} : Status{Error::kSingular};
}

Status solve_direction(const LoadedHull& hull, std::size_t m, TransferWorkspace& work,
                       TransferFunctions& out) {
  const EncounterAngle mu = solved_angle(m);
  const bool has_diffraction = hull.method.loads != DiffractionLoads::kClassic;
  const std::size_t n = out.num_frequencies;
  for (std::size_t f = 0; f < n; ++f) {
    set_wave(hull, out.omega[f], mu, work.sections[f], has_diffraction ? &work.diffraction[f] : nullptr,
             work.wave);
    if (const Status solved = solve_wave(hull, m, f, work, out); !solved) {
      return solved;
    }
  }
  return solve_peaks(hull, m, work, out);
}

// A direction and the one that mirrors it fore and aft, m and the last less m: what a wave is to a section
// depends on sin mu, but for the sign of surge.
Status solve_directions(const LoadedHull& hull, std::size_t m, TransferWorkspace& work,
                        TransferFunctions& out) {
  const EncounterAngle mu = solved_angle(m);
  const std::size_t n = out.num_frequencies;
  if (hull.method.loads == DiffractionLoads::kBoundaryValue) {
    boundary_value_motions(hull, std::span(out.omega).first(n), mu, work.diffraction);
  }
  for (std::size_t f = 0; f < n; ++f) {
    section_waves(hull, out.omega[f], mu, f, work.decays, work.sections[f]);
  }
  work.decays.is_filled = true;
  if (const Status solved = solve_direction(hull, m, work, out); !solved) {
    return solved;
  }
  const std::size_t mirrored = kNumSolvedDirections - 1 - m;
  if (mirrored == m) {
    return {};
  }
  for (SectionWaves& sections : std::span(work.sections).first(n)) {
    for (Held& surge : std::span(sections.surge).first(hull.num_sections)) {
      surge = -surge;
    }
  }
  return solve_direction(hull, mirrored, work, out);
}

void list_empirical_resistance(const LoadedHull& hull, TransferFunctions& out) {
  const EmpiricalShip ship = empirical_ship(hull);
  std::array<EmpiricalWave, kMaxFrequencies> waves{};
  for (std::size_t f = 0; f < out.num_frequencies; ++f) {
    waves[f] = empirical_wave(ship, out.omega[f]);
  }
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    out.has_empirical_resistance[v] = kKeepsEmpiricalResistance && is_in_range(ship, out.speeds[v]);
    for (std::size_t m = 0; m < kNumSolvedDirections && out.has_empirical_resistance[v]; ++m) {
      const EmpiricalResistance resistance(ship, solved_angle(m), out.speeds[v]);
      for (std::size_t f = 0; f < out.num_frequencies; ++f) {
        out.empirical_resistance[v][m][f] = static_cast<float>(resistance.at(waves[f]));
      }
    }
  }
}

void set_frequency(const LoadedHull& hull, std::size_t f, double omega, TransferFunctions& out) {
  out.omega[f] = omega;
  out.wave_number[f] = wave_number(omega, hull.gravity);
  out.encounter_floor[f] = encounter_floor(hull, omega);
}

Status solve_at_chosen_frequencies(const LoadedHull& hull, std::span<const double> speeds,
                                   TransferWorkspace& work, TransferFunctions& out) {
  if (speeds.empty() || speeds.size() > kMaxSpeeds) {
    return Error::kTooMany;
  }
  out.num_speeds = speeds.size();
  out.gravity = hull.gravity;
  out.roll_damping = hull.roll_damping;
  out.critical_roll_damping = 2.0 * hull.restoring.c44 / hull.roll_natural_frequency;
  std::copy(speeds.begin(), speeds.end(), out.speeds.begin());
  work.ship = ship_terms(hull);
  work.decays = {work.decay_room, work.decay_room.size() / kMaxFrequencies, false};
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    work.terms[v] = {out.speeds[v], reference_roll_damping(hull.roll_damping, out.speeds[v])};
    work.resonance[v] = roll_resonance(hull, out.speeds[v]);
    out.roll_update[v] = roll_update(hull, out.speeds[v], out.encounter_floor[0]);
  }
  if (hull.method.loads == DiffractionLoads::kHaskind) {
    for (std::size_t f = 0; f < out.num_frequencies; ++f) {
      beam_sea_correction(hull, out.omega[f], work.diffraction[f]);
    }
  }
  list_empirical_resistance(hull, out);
  for (std::size_t m = 0; m <= kNumSolvedDirections / 2; ++m) {
    if (const Status solved = solve_directions(hull, m, work, out); !solved) {
      return solved;
    }
  }
  return {};
}

}  // namespace

EncounterAngle solved_angle(std::size_t m) {
  return {kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1)};
}

void store_motions(const std::array<Complex, 6>& motion, std::size_t f, MotionRow& row) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    row.re[i][f] = static_cast<float>(motion[i].real());
    row.im[i][f] = static_cast<float>(motion[i].imag());
  }
}

void choose_frequencies(const LoadedHull& hull, TransferFunctions& out) {
  const double froude_frequency = std::sqrt(hull.gravity / hull.lpp);
  const double lowest = std::min(kLowestOmega, kLowestFroude * froude_frequency);
  const double highest = std::max(kHighestOmega, kHighestFroude * froude_frequency);
  out.num_frequencies = kMaxFrequencies;
  // Nodes at equal shares of the integral of their density, by the trapezoidal rule in ln(omega).
  constexpr std::size_t kSteps = 4096;
  const double step = std::log(highest / lowest) / static_cast<double>(kSteps);
  const auto omega_at = [&](std::size_t i) { return lowest * std::exp(step * static_cast<double>(i)); };
  const auto share_of = [&](std::size_t i) {
    return 0.5 * step *
           (omega_at(i) * node_density(omega_at(i), froude_frequency) +
            omega_at(i + 1) * node_density(omega_at(i + 1), froude_frequency));
  };
  double whole = 0.0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    whole += share_of(i);
  }
  set_frequency(hull, 0, lowest, out);
  std::size_t f = 1;
  double sum = 0.0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double share = share_of(i);
    for (; f + 1 < kMaxFrequencies; ++f) {  // bounded: f only grows
      const double wanted = whole * static_cast<double>(f) / static_cast<double>(kMaxFrequencies - 1);
      if (wanted > sum + share) {
        break;
      }
      const double part = (wanted - sum) / share;
      set_frequency(hull, f, omega_at(i) * std::exp(step * part), out);
    }
    sum += share;
  }
  set_frequency(hull, kMaxFrequencies - 1, highest, out);
}

Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                TransferWorkspace& work, TransferFunctions& out) {
  choose_frequencies(hull, out);
  return solve_at_chosen_frequencies(hull, speeds, work, out);
}

Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                std::span<const double> omega, TransferWorkspace& work,
                                TransferFunctions& out) {
  if (omega.size() < 4 || omega.size() > kMaxFrequencies) {
    return Error::kTooMany;
  }
  out.num_frequencies = omega.size();
  for (std::size_t f = 0; f < omega.size(); ++f) {
    set_frequency(hull, f, omega[f], out);
  }
  return solve_at_chosen_frequencies(hull, speeds, work, out);
}

}  // namespace quickstrip
