#include "core/response/incident_waves.hpp"

#include <complex>

#include "core/base/check.hpp"
#include "core/response/relative_motion.hpp"

namespace quickstrip {

WaveThere wave_from(const WavesOfQuarter& waves, std::size_t solved_m) {
  constexpr std::size_t kHalf = kNumDirections / 2;
  static_assert(kHalf % 2 == 0);
  const bool is_ahead = solved_m > kHalf / 2;
  return {waves[is_ahead ? kHalf - solved_m : solved_m], is_ahead};
}

void list_incident_wave(const TransferFunctions& transfer, std::size_t solved_m, const Position& position,
                        IncidentWave& out) {
  QS_CHECK(position.y == 0.0);
  const EncounterAngle mu = relative_direction(solved_m);
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    const std::complex<double> wave = incident_wave(position, transfer.wave_number[f], mu);
    out.re[f] = static_cast<float>(wave.real());
    out.im[f] = static_cast<float>(wave.imag());
  }
}

void list_incident_waves(const TransferFunctions& transfer, const Watch& watch, IncidentWaves& out) {
  std::size_t num_waves = 0;
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    out.place[c] = 0;
    if (!(watch.channels[c].form.wave > 0.0)) {
      continue;
    }
    QS_CHECK(num_waves < out.wave.size());
    out.place[c] = num_waves;
    WavesOfQuarter& waves = out.wave[num_waves];
    for (std::size_t m = 0; m < waves.size(); ++m) {
      list_incident_wave(transfer, m, watch.channels[c].position, waves[m]);
    }
    ++num_waves;
  }
}

}  // namespace quickstrip
