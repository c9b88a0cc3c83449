// What a directional buoy reports each hour: per band the density and the first two pairs of Fourier
// coefficients of the directional distribution, as direction and length (NDBC Technical Document 96-01):
//   D(theta) = 1/pi [1/2 + r1 cos(theta - alpha1) + r2 cos 2(theta - alpha2)]   cut after two terms
// with theta the compass direction that waves come from. Hours that are not there are gaps; nothing is
// interpolated over time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace quickstrip {

/// One value a band. Directions [deg], 0 ... 360; r1, r2 [%], 0 ... 100, as they are reported.
struct BuoyHour {
  std::int64_t utime_us = 0;
  std::vector<double> density_m2_hz;
  std::vector<double> alpha1_deg;
  std::vector<double> alpha2_deg;
  std::vector<double> r1_percent;
  std::vector<double> r2_percent;
  bool operator==(const BuoyHour&) const = default;
};

/// Hours in order of time.
struct BuoyRecord {
  std::string source;  // one line: who measured it, where
  std::vector<double> frequencies_hz;
  std::vector<BuoyHour> hours;
  bool operator==(const BuoyRecord&) const = default;
};

/// Hs = 4 sqrt(m0), density linear between bands [m].
double significant_wave_height_m(const std::vector<double>& frequencies_hz,
                                 const std::vector<double>& density_m2_hz);

/// Energy of the bands (trapezoidal rule), m2.
std::vector<double> band_energies_m2(const std::vector<double>& frequencies_hz,
                                     const std::vector<double>& density_m2_hz);

}  // namespace quickstrip
