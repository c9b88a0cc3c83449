// Import of the five files in which NDBC gives hourly directional spectra (public domain):
//   w density [m2/Hz], d alpha1 and i alpha2 [deg true, waves come from], j 100 r1, k 100 r2; 999 = missing.
// Each has a header line "#YY MM DD hh mm" followed by the bands [Hz], then a line an hour.
//
// An hour is a gap, and counted, when it is not in all five files, when a density is missing, when it has no
// energy, or when directions are missing in bands that hold more than 2 % of the energy. Directions missing
// in bands below that are taken as isotropic (r1 = r2 = 0) and counted. Nothing is interpolated.
#pragma once

#include <cstddef>
#include <string>

#include "msgs/files/file_status.hpp"
#include "sim/sea_files/buoy_record.hpp"

namespace quickstrip {

struct NdbcNotes {
  std::size_t num_gaps = 0;             // hours in one of the files that are not in the record
  std::size_t num_isotropic_bands = 0;  // bands of all hours without direction
};

/// `prefix`: of the five names, up to the letter: "DIR/dorian_41010" finds
/// DIR/dorian_41010w_20190830_0908.txt and its four sisters. After the letter there must be no other letter.
/// Hours in any order, each once.
FileStatus import_ndbc(const std::string& prefix, BuoyRecord& out, NdbcNotes& notes);

}  // namespace quickstrip
