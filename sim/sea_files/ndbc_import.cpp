#include "sim/sea_files/ndbc_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/capacity.hpp"
#include "msgs/convert/ranges.hpp"
#include "msgs/files/printable.hpp"
#include "sim/sea_files/number_list.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip {
namespace {

constexpr double kMissing = 999.0;
constexpr std::uintmax_t kMaxNdbcFileBytes = 100'000'000;
constexpr double kIsotropicShare = 0.02;  // of the energy
constexpr std::string_view kLetters = "wdijk";
constexpr std::size_t kNumTimeFields = 5;

struct NdbcFile {
  std::vector<double> frequencies_hz;
  std::map<std::int64_t, std::vector<double>> hours;
};

struct ValueRange {
  std::string_view what;
  double low;
  double high;
};

constexpr std::array<ValueRange, 5> kRanges = {{{"density_m2_hz", 0.0, 998.9},
                                                {"alpha1_deg", 0.0, 360.0},
                                                {"alpha2_deg", 0.0, 360.0},
                                                {"r1_percent", 0.0, 100.0},
                                                {"r2_percent", 0.0, 100.0}}};

FileStatus find_file(const std::string& prefix, char letter, std::filesystem::path& out) {
  const std::filesystem::path whole(prefix);
  const std::filesystem::path folder = whole.has_parent_path() ? whole.parent_path() : ".";
  const std::string start = whole.filename().string() + letter;
  std::error_code failed;
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const std::string name = entry.path().filename().string();
    const bool fits =
        name.starts_with(start) &&
        (name.size() == start.size() || std::isalpha(static_cast<unsigned char>(name[start.size()])) == 0);
    if (fits && entry.is_regular_file(failed)) {
      found.push_back(entry.path());
    }
  }
  if (found.size() != 1) {
    return FileError{fmt::format("{}{}*: files = {}: one file whose name goes on without a letter is needed",
                                 prefix, letter, found.size())};
  }
  out = found.front();
  return {};
}

FileStatus read_header(const std::string& where, const std::vector<std::string_view>& words, NdbcFile& out) {
  if (words.size() < kNumTimeFields + 3 || words.size() > kNumTimeFields + kMaxSpectrumFrequencies) {
    return FileError{fmt::format("{}: header = {} words: #YY MM DD hh mm and 3 to {} bands in Hz are needed",
                                 where, words.size(), kMaxSpectrumFrequencies)};
  }
  for (std::size_t i = kNumTimeFields; i < words.size(); ++i) {
    const std::optional<double> value = parse_number(words[i]);
    const double last = out.frequencies_hz.empty() ? 0.0 : out.frequencies_hz.back();
    if (!value || !(*value > last && kWaveFrequency_hz.holds(*value))) {
      return FileError{
          fmt::format("{}: band = {}: a frequency from {} to {} Hz, above the one before, {}, is needed",
                      where, printable(words[i]), kWaveFrequency_hz.from, kWaveFrequency_hz.to, last)};
    }
    out.frequencies_hz.push_back(*value);
  }
  return {};
}

std::optional<std::int64_t> time_of(const std::vector<std::string_view>& words) {
  std::array<int, kNumTimeFields> field{};
  for (std::size_t i = 0; i < kNumTimeFields; ++i) {
    const std::optional<double> value = parse_number(words[i]);
    if (!value || !(*value >= 0.0 && *value <= 9999.0)) {
      return std::nullopt;
    }
    field[i] = static_cast<int>(*value);
  }
  return utime_of(field[0], field[1], field[2], field[3], field[4], 0);
}

FileStatus read_hour(const std::string& where, const std::vector<std::string_view>& words,
                     const ValueRange& range, NdbcFile& out) {
  const std::size_t expected = kNumTimeFields + out.frequencies_hz.size();
  if (words.size() != expected) {
    return FileError{
        fmt::format("{}: hour = {} words: {} are needed, as in the header", where, words.size(), expected)};
  }
  const std::optional<std::int64_t> time = time_of(words);
  if (!time) {
    return FileError{fmt::format("{}: time = {} {} {} {} {}: year, month, day, hour, minute are needed",
                                 where, printable(words[0]), printable(words[1]), printable(words[2]),
                                 printable(words[3]), printable(words[4]))};
  }
  std::vector<double> values;
  for (std::size_t i = kNumTimeFields; i < words.size(); ++i) {
    const std::optional<double> value = parse_number(words[i]);
    if (!value || !((*value >= range.low && *value <= range.high) || *value == kMissing)) {
      return FileError{fmt::format("{}: {} = {}: a number from {} to {}, or 999 for missing, is needed",
                                   where, range.what, printable(words[i]), range.low, range.high)};
    }
    values.push_back(*value);
  }
  if (!out.hours.emplace(*time, std::move(values)).second) {
    return FileError{fmt::format("{}: time = {}: each hour once is needed", where, format_utc(*time))};
  }
  return {};
}

FileStatus read_file(const std::filesystem::path& path, const ValueRange& range, NdbcFile& out) {
  std::error_code failed;
  if (const auto size = std::filesystem::file_size(path, failed); !failed && size > kMaxNdbcFileBytes) {
    return FileError{fmt::format("{}: {} bytes: at most {} are needed, ten years of a buoy", path.string(),
                                 size, kMaxNdbcFileBytes)};
  }
  std::ifstream in(path);
  if (!in) {
    return FileError{fmt::format("{}: file = unreadable: a readable NDBC file is needed", path.string())};
  }
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string where = fmt::format("{}:{}", path.string(), number);
    const std::vector<std::string_view> words = words_of(line);
    const bool header = out.frequencies_hz.empty();
    if (words.empty() || (!header && words[0].starts_with('#'))) {
      continue;
    }
    const FileStatus read = header ? read_header(where, words, out) : read_hour(where, words, range, out);
    if (!read) {
      return read;
    }
  }
  return out.hours.empty()
             ? FileStatus{FileError{fmt::format("{}: hours = 0: at least one line is needed", path.string())}}
             : FileStatus{};
}

// Nothing when the hour is a gap.
std::optional<BuoyHour> assemble(std::int64_t time, const std::array<NdbcFile, 5>& files, NdbcNotes& notes) {
  std::array<std::vector<double>, 5> values;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto found = files[i].hours.find(time);
    if (found == files[i].hours.end()) {
      return std::nullopt;
    }
    values[i] = found->second;
  }
  if (std::find(values[0].begin(), values[0].end(), kMissing) != values[0].end()) {
    return std::nullopt;
  }
  const std::vector<double> energies = band_energies_m2(files[0].frequencies_hz, values[0]);
  const double m0 = std::accumulate(energies.begin(), energies.end(), 0.0);
  double without_direction = 0.0;
  std::size_t num_isotropic = 0;
  for (std::size_t b = 0; b < energies.size(); ++b) {
    if (std::any_of(values.begin() + 1, values.end(), [b](const auto& v) { return v[b] == kMissing; })) {
      without_direction += energies[b];
      ++num_isotropic;
      values[1][b] = values[2][b] = values[3][b] = values[4][b] = 0.0;
    }
  }
  if (!(m0 > 0.0) || without_direction > kIsotropicShare * m0) {
    return std::nullopt;
  }
  notes.num_isotropic_bands += num_isotropic;
  return BuoyHour{time, values[0], values[1], values[2], values[3], values[4]};
}

}  // namespace

FileStatus import_ndbc(const std::string& prefix, BuoyRecord& out, NdbcNotes& notes) {
  std::array<NdbcFile, 5> files;
  std::set<std::int64_t> times;
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::filesystem::path path;
    if (const FileStatus found = find_file(prefix, kLetters[i], path); !found) {
      return found;
    }
    if (const FileStatus read = read_file(path, kRanges[i], files[i]); !read) {
      return read;
    }
    if (files[i].frequencies_hz != files[0].frequencies_hz) {
      return FileError{fmt::format("{}:1: bands = {}: the bands of file w are needed", path.string(),
                                   files[i].frequencies_hz.size())};
    }
    for (const auto& hour : files[i].hours) {
      times.insert(hour.first);
    }
  }
  BuoyRecord record;
  record.source = "NOAA/NDBC " + std::filesystem::path(prefix).filename().string();
  record.frequencies_hz = files[0].frequencies_hz;
  NdbcNotes noted;
  for (const std::int64_t time : times) {
    if (std::optional<BuoyHour> hour = assemble(time, files, noted)) {
      const double hs = significant_wave_height_m(record.frequencies_hz, hour->density_m2_hz);
      if (!(hs <= kMaxWaveHeight_m)) {  // the advisor would refuse the message made of it
        return FileError{fmt::format("{}: density_m2_hz = Hs {:.3g} m at {}: at most {} m in all is needed",
                                     prefix, hs, format_utc(time), kMaxWaveHeight_m)};
      }
      record.hours.push_back(std::move(*hour));
    } else {
      ++noted.num_gaps;
    }
  }
  if (record.hours.empty()) {
    return FileError{fmt::format("{}: hours = 0: an hour complete in all five files is needed", prefix)};
  }
  out = std::move(record);
  notes = noted;
  return {};
}

}  // namespace quickstrip
