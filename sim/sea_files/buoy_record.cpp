#include "sim/sea_files/buoy_record.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace quickstrip {

std::vector<double> band_energies_m2(const std::vector<double>& frequencies_hz,
                                     const std::vector<double>& density_m2_hz) {
  std::vector<double> energies(frequencies_hz.size(), 0.0);
  for (std::size_t b = 0; b + 1 < frequencies_hz.size(); ++b) {
    const double half = 0.5 * (frequencies_hz[b + 1] - frequencies_hz[b]);
    energies[b] += half * density_m2_hz[b];
    energies[b + 1] += half * density_m2_hz[b + 1];
  }
  return energies;
}

double significant_wave_height_m(const std::vector<double>& frequencies_hz,
                                 const std::vector<double>& density_m2_hz) {
  const std::vector<double> energies = band_energies_m2(frequencies_hz, density_m2_hz);
  return 4.0 * std::sqrt(std::accumulate(energies.begin(), energies.end(), 0.0));
}

}  // namespace quickstrip
