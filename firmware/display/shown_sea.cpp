#include "firmware/display/shown_sea.hpp"

#include <cmath>
#include <memory>

#include "core/sea/partition.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {

ShownSea shown_sea(const sea_state_t& message) {
  SeaState sea;
  std::uint32_t assumed = 0;
  ShownSea shown;
  shown.utime = message.utime;
  shown.source_kind = message.source_kind;
  if (!to_sea_state(message, sea, assumed).ok()) {
    return shown;
  }
  double square_sum = 0.0;
  for (int i = 0; i < message.num_systems; ++i) {
    shown.systems.push_back({message.hs_m[i], message.period_s[i], message.period_kind[i],
                             message.dir_from_deg[i], message.system_kind[i]});
    square_sum += message.hs_m[i] * message.hs_m[i];
  }
  shown.hs_m = std::sqrt(square_sum);
  return shown;
}

ShownSea shown_sea(const wave_spectrum_t& message) {
  ShownSea shown;
  shown.utime = message.utime;
  shown.source_kind = message.source_kind;
  const auto spectrum = std::make_unique<DirectionalSpectrum>();
  const auto work = std::make_unique<PartitionWorkspace>();
  const auto parts = std::make_unique<WavePartition>();
  if (!to_directional_spectrum(message, *spectrum).ok() ||
      !divide_into_systems(*spectrum, *work, *parts).ok()) {
    return shown;
  }
  double square_sum = 0.0;
  for (std::size_t i = 0; i < parts->num_systems; ++i) {
    const WaveSystem& system = parts->system[i];
    shown.systems.push_back({system.hs, system.period, sea_state_t::PERIOD_TP,
                             degrees(wrap_two_pi(system.from.radians)), sea_state_t::SYSTEM_NOT_KNOWN});
    square_sum += system.hs * system.hs;
  }
  shown.hs_m = std::sqrt(square_sum);
  return shown;
}

}  // namespace quickstrip
