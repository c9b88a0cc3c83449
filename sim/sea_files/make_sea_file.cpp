// Makes a sea file from NDBC's five files, or a part of a sea file: how the files in sim/storms were made.
//   make_sea_file SOURCE OUT NAME [FROM TO]     SOURCE: ndbc:PREFIX or FILE; FROM, TO: 2019-09-04T12:40Z
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "sim/sea_files/ndbc_import.hpp"
#include "sim/sea_files/sea_file.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace {

int refuse(int code, const std::string& line) {
  fmt::print(stderr, "{}\n", line);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace quickstrip;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() != 3 && words.size() != 5) {
    return refuse(2, "make_sea_file: usage: make_sea_file ndbc:PREFIX|FILE OUT NAME [FROM TO]");
  }
  BuoyRecord record;
  NdbcNotes notes;
  const FileStatus read = words[0].starts_with("ndbc:") ? import_ndbc(words[0].substr(5), record, notes)
                                                        : read_sea_file(words[0], record);
  if (!read) {
    return refuse(1, read.line());
  }
  record.source = words[2];
  if (words.size() == 5) {
    const auto from = parse_utc(words[3]);
    const auto to = parse_utc(words[4]);
    if (!from || !to) {
      return refuse(2, "make_sea_file: FROM, TO: times like 2019-09-04T12:40Z are needed");
    }
    std::erase_if(record.hours,
                  [&](const BuoyHour& hour) { return hour.utime_us < *from || hour.utime_us > *to; });
  }
  if (record.hours.empty()) {
    return refuse(1, "make_sea_file: hours = 0: at least one hour between FROM and TO is needed");
  }
  if (const FileStatus written = write_sea_file(record, words[1]); !written) {
    return refuse(1, written.line());
  }
  fmt::print(stderr, "{}: {} hours, {} left out as gaps, {} bands without direction\n", words[1],
             record.hours.size(), notes.num_gaps, notes.num_isotropic_bands);
  return 0;
}
