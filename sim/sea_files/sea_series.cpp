#include "sim/sea_files/sea_series.hpp"

#include <algorithm>
#include <complex>
#include <string_view>

#include "core/base/angles.hpp"
#include "core/base/check.hpp"
#include "core/sea/directional_spectrum.hpp"
#include "core/sea/moments.hpp"
#include "sim/sea_files/maximum_entropy.hpp"
#include "sim/sea_files/ndbc_import.hpp"
#include "sim/sea_files/sea_file.hpp"

namespace quickstrip {
namespace {

constexpr std::string_view kNdbc = "ndbc:";

struct ClampCount {
  std::size_t bands = 0;
  double energy = 0.0;
};

SeaRecord sea_record(const std::vector<double>& frequencies_hz, const BuoyHour& hour, ClampCount& clamps) {
  SeaRecord record;
  record.utime_us = hour.utime_us;
  DirectionalSpectrum& spectrum = record.spectrum;
  QS_CHECK(spectrum.frequencies.resize(frequencies_hz.size()) && spectrum.directions.resize(kNumDirections));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    spectrum.directions[d] = kTwoPi * static_cast<double>(d) / static_cast<double>(kNumDirections);
  }
  const std::vector<double> energies = band_energies_m2(frequencies_hz, hour.density_m2_hz);
  for (std::size_t b = 0; b < frequencies_hz.size(); ++b) {
    spectrum.frequencies[b] = kTwoPi * frequencies_hz[b];
    const DirectionalDistribution distribution =
        maximum_entropy(std::polar(hour.r1_percent[b] / 100.0, radians(hour.alpha1_deg[b])),
                        std::polar(hour.r2_percent[b] / 100.0, 2.0 * radians(hour.alpha2_deg[b])));
    if (distribution.clamped) {
      ++clamps.bands;
      clamps.energy += energies[b];
    }
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      spectrum.density[b][d] = hour.density_m2_hz[b] / kTwoPi * distribution.density[d];
    }
  }
  record.hs = significant_wave_height(zeroth_moment(spectrum));
  return record;
}

}  // namespace

SeaSeries sea_series(const BuoyRecord& record) {
  SeaSeries series;
  series.source = record.source;
  series.records.reserve(record.hours.size());
  ClampCount clamps;
  double energy = 0.0;
  for (const BuoyHour& hour : record.hours) {
    series.records.push_back(sea_record(record.frequencies_hz, hour, clamps));
    energy += series.records.back().hs * series.records.back().hs / 16.0;
  }
  series.num_clamped_bands = clamps.bands;
  series.clamped_energy_share = energy > 0.0 ? clamps.energy / energy : 0.0;
  return series;
}

FileStatus load_sea(const std::string& source, SeaSeries& out) {
  BuoyRecord record;
  NdbcNotes notes;
  const FileStatus read = source.starts_with(kNdbc) ? import_ndbc(source.substr(kNdbc.size()), record, notes)
                                                    : read_sea_file(source, record);
  if (!read) {
    return read;
  }
  out = sea_series(record);
  out.num_gaps = notes.num_gaps;
  out.num_isotropic_bands = notes.num_isotropic_bands;
  return {};
}

const SeaRecord* record_at(const SeaSeries& series, std::int64_t utime_us, std::int64_t stale_after_us) {
  const auto after =
      std::upper_bound(series.records.begin(), series.records.end(), utime_us,
                       [](std::int64_t time, const SeaRecord& record) { return time < record.utime_us; });
  if (after == series.records.begin()) {
    return nullptr;
  }
  const SeaRecord& newest = *(after - 1);
  return utime_us - newest.utime_us <= stale_after_us ? &newest : nullptr;
}

}  // namespace quickstrip
