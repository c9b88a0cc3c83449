#include "sim/replay/sea_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "msgs/convert/sea_message.hpp"

namespace quickstrip {
namespace {

SeaSummary of_systems(std::span<const WaveSystem> systems, double hs) {
  SeaSummary out;
  out.hs_m = hs;
  for (const WaveSystem& system : systems) {
    out.systems.push_back({system.hs, system.period, degrees(wrap_two_pi(system.from.radians))});
  }
  std::stable_sort(out.systems.begin(), out.systems.end(),
                   [](const SummedSystem& a, const SummedSystem& b) { return a.hs_m > b.hs_m; });
  return out;
}

/// 0.2 ... 2.5 rad/s in even ratios: wide enough for any sea that moves a ship.
std::array<double, kMaxFrequencies> wave_frequencies() {
  std::array<double, kMaxFrequencies> omega{};
  for (std::size_t i = 0; i < omega.size(); ++i) {
    omega[i] = 0.2 * std::pow(12.5, static_cast<double>(i) / static_cast<double>(omega.size() - 1));
  }
  return omega;
}

template <typename Sea>
SeaSummary of_sea(const Sea& sea) {
  const auto energy = std::make_unique<SeaEnergy>();
  if (!place_on_grid(sea, wave_frequencies(), *energy).ok()) {
    return {};
  }
  return of_systems(std::span(energy->system).first(energy->num_systems), energy->hs);
}

}  // namespace

SeaSummary summary(const StepOutput& output) {
  return of_systems(std::span(output.systems).first(output.num_systems), output.hs);
}

SeaSummary summary(const wave_spectrum_t& message) {
  const auto spectrum = std::make_unique<DirectionalSpectrum>();
  return to_directional_spectrum(message, *spectrum).ok() ? of_sea(*spectrum) : SeaSummary{};
}

SeaSummary summary(const sea_state_t& message) {
  SeaState sea;
  std::uint32_t assumed = 0;
  return to_sea_state(message, sea, assumed).ok() ? of_sea(sea) : SeaSummary{};
}

}  // namespace quickstrip
