#include "sim/sea_files/sea_file.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/base/capacity.hpp"
#include "msgs/convert/ranges.hpp"
#include "msgs/files/printable.hpp"
#include "msgs/files/text_file.hpp"
#include "sim/sea_files/number_list.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip {
namespace {

constexpr std::string_view kTitle = "quickstrip-sea 1";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors begin UTF-8 with it
// A year of hourly spectra; each is 37 kB as a directional spectrum in memory.
constexpr std::size_t kMaxHours = 10'000;
constexpr std::size_t kMaxSeaFileBytes = 40'000'000;  // 10,000 hours of 64 bands take some 25 MB

struct Row {
  std::string_view name;
  std::vector<double> BuoyHour::*values;
  double high;
};

// In the order of the file.
constexpr std::array<Row, 5> kRows = {{{"density_m2_hz", &BuoyHour::density_m2_hz, 1e6},
                                       {"alpha1_deg", &BuoyHour::alpha1_deg, 360.0},
                                       {"alpha2_deg", &BuoyHour::alpha2_deg, 360.0},
                                       {"r1_percent", &BuoyHour::r1_percent, 100.0},
                                       {"r2_percent", &BuoyHour::r2_percent, 100.0}}};

class Parser {
 public:
  Parser(std::string_view text, std::string_view file) : rest_(text), file_(file) {}

  FileStatus parse(BuoyRecord& out);

 private:
  // The next line that is neither empty nor a comment, in words; false at the end.
  bool next_line();
  [[nodiscard]] FileError refusal(std::string_view field, std::string_view value,
                                  std::string_view right) const {
    return {fmt::format("{}:{}: {} = {}: {}", file_, number_, field, printable(value), right)};
  }
  FileStatus parse_frequencies(BuoyRecord& record);
  FileStatus parse_hour(BuoyRecord& record);
  FileStatus parse_row(const Row& row, std::size_t num_bands, BuoyHour& hour);

  std::string_view rest_;
  std::string_view file_;
  std::size_t number_ = 0;
  std::string_view line_;
  std::vector<std::string_view> words_;
};

bool Parser::next_line() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    ++number_;
    words_ = words_of(line_);
    if (!words_.empty() && !words_[0].starts_with('#')) {
      return true;
    }
  }
  line_ = "end of file";
  words_ = {line_};
  return false;
}

FileStatus Parser::parse_frequencies(BuoyRecord& record) {
  if (!next_line() || words_[0] != "frequencies_hz") {
    return refusal("line", words_[0], "the line frequencies_hz is needed here");
  }
  if (words_.size() < 4 || words_.size() > kMaxSpectrumFrequencies + 1) {
    return refusal("frequencies_hz", fmt::format("{} numbers", words_.size() - 1),
                   fmt::format("3 to {} are needed", kMaxSpectrumFrequencies));
  }
  double last = 0.0;
  for (std::size_t i = 1; i < words_.size(); ++i) {
    const auto value = parse_number(words_[i]);
    if (!value || !(*value > last && kWaveFrequency_hz.holds(*value))) {
      return refusal("frequencies_hz", words_[i],
                     fmt::format("a number from {} to {}, above the one before, {}, is needed",
                                 kWaveFrequency_hz.from, kWaveFrequency_hz.to, last));
    }
    last = *value;
    record.frequencies_hz.push_back(last);
  }
  return {};
}

FileStatus Parser::parse_row(const Row& row, std::size_t num_bands, BuoyHour& hour) {
  if (!next_line() || words_[0] != row.name) {
    return refusal("line", words_[0], fmt::format("the line {} is needed here", row.name));
  }
  if (words_.size() != num_bands + 1) {
    return refusal(row.name, fmt::format("{} numbers", words_.size() - 1),
                   fmt::format("{} are needed, one a band", num_bands));
  }
  for (std::size_t i = 1; i < words_.size(); ++i) {
    const auto value = parse_number(words_[i]);
    if (!value || !(*value >= 0.0 && *value <= row.high)) {
      return refusal(row.name, words_[i], fmt::format("a number from 0 to {} is needed", row.high));
    }
    (hour.*row.values).push_back(*value);
  }
  return {};
}

FileStatus Parser::parse_hour(BuoyRecord& record) {
  const auto time = words_.size() == 2 && words_[0] == "hour" ? parse_utc(words_[1]) : std::nullopt;
  if (!time) {
    return refusal("hour", line_, "\"hour 2019-09-04T12:40:00Z\" is needed here");
  }
  if (!record.hours.empty() && *time <= record.hours.back().utime_us) {
    return refusal("hour", words_[1],
                   fmt::format("a time after {} is needed", format_utc(record.hours.back().utime_us)));
  }
  BuoyHour hour;
  hour.utime_us = *time;
  for (const Row& row : kRows) {
    if (const FileStatus parsed = parse_row(row, record.frequencies_hz.size(), hour); !parsed) {
      return parsed;
    }
  }
  const double hs = significant_wave_height_m(record.frequencies_hz, hour.density_m2_hz);
  if (!(hs <= kMaxWaveHeight_m)) {  // the advisor would refuse the message made of it
    return refusal("density_m2_hz", fmt::format("Hs {:.3g} m at {}", hs, format_utc(*time)),
                   fmt::format("at most {} m in all is needed", kMaxWaveHeight_m));
  }
  if (!(hs > 0.0)) {
    return refusal("hour", format_utc(*time), "some energy is needed; leave an hour without a spectrum out");
  }
  record.hours.push_back(std::move(hour));
  return {};
}

FileStatus Parser::parse(BuoyRecord& out) {
  BuoyRecord record;
  if (rest_.starts_with(kByteOrderMark)) {
    rest_.remove_prefix(kByteOrderMark.size());
  }
  if (!next_line() || words_.size() != 2 || words_[0] != "quickstrip-sea" || words_[1] != "1") {
    return refusal("title", line_, fmt::format("\"{}\" is needed in the first line", kTitle));
  }
  if (!next_line() || words_[0] != "source" || words_.size() < 2) {
    return refusal("line", words_[0], "the line source, with a name, is needed here");
  }
  for (std::size_t i = 1; i < words_.size(); ++i) {
    record.source += (i == 1 ? "" : " ") + std::string(words_[i]);
  }
  if (const FileStatus parsed = parse_frequencies(record); !parsed) {
    return parsed;
  }
  while (next_line()) {
    if (record.hours.size() == kMaxHours) {
      return refusal("hours", fmt::format("more than {}", kMaxHours),
                     "fewer are needed: cut the file with make_sea_file");
    }
    if (const FileStatus parsed = parse_hour(record); !parsed) {
      return parsed;
    }
  }
  if (record.hours.empty()) {
    return refusal("hours", "0", "at least one hour is needed");
  }
  out = std::move(record);
  return {};
}

void append_row(std::string& text, std::string_view name, const std::vector<double>& values) {
  text += name;
  for (const double value : values) {
    fmt::format_to(std::back_inserter(text), " {}", value);
  }
  text += '\n';
}

}  // namespace

FileStatus parse_sea_file(std::string_view text, std::string_view file, BuoyRecord& out) {
  return Parser(text, file).parse(out);
}

FileStatus read_sea_file(const std::filesystem::path& path, BuoyRecord& out) {
  try {
    return parse_sea_file(read_text_file(path, kMaxSeaFileBytes), path.string(), out);
  } catch (const FileError& error) {
    return error;
  }
}

std::string sea_file_text(const BuoyRecord& record) {
  std::string text = fmt::format("{}\nsource {}\n", kTitle, record.source);
  append_row(text, "frequencies_hz", record.frequencies_hz);
  for (const BuoyHour& hour : record.hours) {
    text += fmt::format("hour {}\n", format_utc(hour.utime_us));
    for (const Row& row : kRows) {
      append_row(text, row.name, hour.*row.values);
    }
  }
  return text;
}

FileStatus write_sea_file(const BuoyRecord& record, const std::filesystem::path& path) {
  const std::filesystem::path beside = path.string() + ".part";
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file << sea_file_text(record);
  file.close();
  std::error_code failed;
  if (file) {
    std::filesystem::rename(beside, path, failed);
  }
  if (!file || failed) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    return FileError{fmt::format("{}: file = unwritable: a writable place is needed", path.string())};
  }
  return {};
}

}  // namespace quickstrip
