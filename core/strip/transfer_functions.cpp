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

}  // namespace

void choose_frequencies(const LoadedHull& hull, TransferFunctions& out) {
  const double froude_frequency = std::sqrt(hull.gravity / hull.lpp);
  const double lowest = std::min(kLowestOmega, kLowestFroude * froude_frequency);
  const double highest = std::max(kHighestOmega, kHighestFroude * froude_frequency);
  out.num_frequencies = kMaxFrequencies;
  for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
    const double t = static_cast<double>(f) / static_cast<double>(kMaxFrequencies - 1);
    out.omega[f] = lowest * std::pow(highest / lowest, t);
    out.wave_number[f] = quickstrip::wave_number(out.omega[f], hull.gravity);
  }
}

Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                TransferFunctions& out) {
  if (speeds.empty() || speeds.size() > kMaxSpeeds) {
    return Error::kTooMany;
  }
  choose_frequencies(hull, out);
  out.num_speeds = speeds.size();
  std::copy(speeds.begin(), speeds.end(), out.speeds.begin());

  const bool haskind = hull.method.loads == DiffractionLoads::kHaskind;
  BeamSeaCorrection correction;
  WaveField field;
  for (std::size_t f = 0; f < out.num_frequencies; ++f) {
    if (haskind) {
      beam_sea_correction(hull, out.omega[f], correction);
    }
    for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
      const EncounterAngle mu{kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1)};
      wave_field(hull, out.omega[f], mu, haskind ? &correction : nullptr, field);
      for (std::size_t v = 0; v < out.num_speeds; ++v) {
        const MotionTransfer solved = motion_transfer(hull, field, out.speeds[v]);
        if (!is_finite(solved)) {
          return Error::kSingular;
        }
        out.solved[v][m][f] = solved;
      }
    }
  }
  return {};
}

}  // namespace quickstrip
