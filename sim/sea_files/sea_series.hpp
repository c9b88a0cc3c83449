// A measured sea in time, as core takes it: directional spectra from a buoy's record, whatever the file.
// Density m2/Hz becomes m2 s / rad: S(omega) = S(f) / 2 pi, times the directional distribution of maximum
// entropy (maximum_entropy.hpp) on the 72 directions. Cost: about 1 ms an hour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/sea/sea_state.hpp"
#include "msgs/files/file_status.hpp"
#include "sim/sea_files/buoy_record.hpp"

namespace quickstrip {

/// One measurement; hs [m]. 37 kB each.
struct SeaRecord {
  std::int64_t utime_us = 0;
  DirectionalSpectrum spectrum;
  double hs = 0.0;
};

/// Records in order of time; what is missing is a gap.
struct SeaSeries {
  std::string source;
  std::vector<SeaRecord> records;
  std::size_t num_clamped_bands = 0;    // whose coefficients were not those of any distribution
  double clamped_energy_share = 0.0;    // of the energy of all hours
  std::size_t num_gaps = 0;             // hours of an NDBC file that could not be used
  std::size_t num_isotropic_bands = 0;  // of an NDBC file
};

/// `source` as on the command line: a sea file, or "ndbc:PREFIX". On refusal `out` is as it was.
FileStatus load_sea(const std::string& source, SeaSeries& out);

/// From a record in memory.
SeaSeries sea_series(const BuoyRecord& record);

/// Default stale-after of the sea, contract §5.
inline constexpr std::int64_t kSeaStaleAfterUs = 90LL * 60 * 1'000'000;

/// The newest record that is not after `utime_us` and not older than `stale_after_us`; nullptr in a gap.
const SeaRecord* record_at(const SeaSeries& series, std::int64_t utime_us,
                           std::int64_t stale_after_us = kSeaStaleAfterUs);

}  // namespace quickstrip
