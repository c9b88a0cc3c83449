#include "core/strip/transfer_functions.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"
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

bool is_finite(const MotionTransfer& t) {
  return std::all_of(t.motion.begin(), t.motion.end(),
                     [](const Complex& m) { return std::isfinite(m.real()) && std::isfinite(m.imag()); });
}

EncounterAngle solved_angle(std::size_t m) {
  return {kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1)};
}

Status solve_direction(const LoadedHull& hull, std::size_t m,
                       std::span<const RollResonance, kMaxSpeeds> resonances, TransferFunctions& out) {
  const EncounterAngle mu = solved_angle(m);
  const bool haskind = hull.method.loads == DiffractionLoads::kHaskind;
  TransferWorkspace& work = out.workspace;
  WaveField field;
  for (std::size_t f = 0; f < out.num_frequencies; ++f) {
    wave_field(hull, out.omega[f], mu, haskind ? &work.correction[f] : nullptr, field);
    for (std::size_t v = 0; v < out.num_speeds; ++v) {
      const MotionTransfer solved = motion_transfer(hull, field, out.speeds[v], work.load[v][f]);
      if (!is_finite(solved)) {
        return Error::kSingular;
      }
      store_motions(solved.motion, f, out.row[v][m]);
      work.encounter[v][f] = {solved.encounter_frequency, solved.low_encounter};
    }
  }
  const std::size_t n = out.num_frequencies;
  const bool rolls = m > 0 && m + 1 < kNumSolvedDirections;  // waves from astern and ahead do not
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    out.peak[v][m].clear();
    if (rolls && !solve_roll_peak(hull, resonances[v], out.speeds[v], mu, std::span(out.omega).first(n),
                                  std::span(work.encounter[v]).first(n), std::span(work.load[v]).first(n),
                                  out.peak[v][m])) {
      return Error::kSingular;
    }
  }
  return {};
}

void set_frequency(const LoadedHull& hull, std::size_t f, double omega, TransferFunctions& out) {
  out.omega[f] = omega;
  out.wave_number[f] = wave_number(omega, hull.gravity);
  out.encounter_floor[f] = encounter_floor(hull, omega);
}

Status solve_at_chosen_frequencies(const LoadedHull& hull, std::span<const double> speeds,
                                   TransferFunctions& out) {
  if (speeds.empty() || speeds.size() > kMaxSpeeds) {
    return Error::kTooMany;
  }
  out.num_speeds = speeds.size();
  out.gravity = hull.gravity;
  std::copy(speeds.begin(), speeds.end(), out.speeds.begin());
  std::array<RollResonance, kMaxSpeeds> resonances{};
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    resonances[v] = roll_resonance(hull, out.speeds[v]);
  }
  if (hull.method.loads == DiffractionLoads::kHaskind) {
    for (std::size_t f = 0; f < out.num_frequencies; ++f) {
      beam_sea_correction(hull, out.omega[f], out.workspace.correction[f]);
    }
  }
  for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
    if (const Status solved = solve_direction(hull, m, resonances, out); !solved) {
      return solved;
    }
  }
  return {};
}

}  // namespace

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
  for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
    const double t = static_cast<double>(f) / static_cast<double>(kMaxFrequencies - 1);
    set_frequency(hull, f, lowest * std::pow(highest / lowest, t), out);
  }
}

Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                TransferFunctions& out) {
  choose_frequencies(hull, out);
  return solve_at_chosen_frequencies(hull, speeds, out);
}

Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                std::span<const double> omega, TransferFunctions& out) {
  if (omega.size() < 4 || omega.size() > kMaxFrequencies) {
    return Error::kTooMany;
  }
  out.num_frequencies = omega.size();
  for (std::size_t f = 0; f < omega.size(); ++f) {
    set_frequency(hull, f, omega[f], out);
  }
  return solve_at_chosen_frequencies(hull, speeds, out);
}

}  // namespace quickstrip
