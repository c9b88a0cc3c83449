#include "sim/hull_tool/csv_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "msgs/cli/run_tool.hpp"
#include "msgs/files/printable.hpp"
#include "sim/sea_files/number_list.hpp"

namespace quickstrip::hull_tool {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  return fields;
}

}  // namespace

CsvFile::CsvFile(const std::string& path) : path_(path), stream_(path) {
  if (!stream_) {
    throw InputError{path + ": cannot be read"};
  }
  if (!read_line()) {
    refuse("holds no header line");
  }
  header_ = line_;
  names_ = fields_of(header_);
}

bool CsvFile::read_line() {
  while (std::getline(stream_, line_)) {
    ++number_;
    if (!line_.empty() && line_.back() == '\r') {
      line_.pop_back();
    }
    if (!line_.empty() && line_.front() != '#') {
      return true;
    }
  }
  return false;
}

bool CsvFile::next_line() {
  if (!read_line()) {
    return false;
  }
  fields_ = fields_of(line_);
  if (fields_.size() != names_.size()) {
    refuse(fmt::format("{} fields, the header names {}", fields_.size(), names_.size()));
  }
  return true;
}

std::size_t CsvFile::column(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at != names_.end()) {
      return static_cast<std::size_t>(at - names_.begin());
    }
  }
  return kNone;
}

double CsvFile::number(std::size_t column, std::string_view name, ListRange range) const {
  const std::optional<double> value = parse_number(fields_[column]);
  if (!value || *value < range.from || *value > range.to) {
    refuse(fmt::format("{} = {}: a number in [{:g}, {:g}] is wanted", name, printable(fields_[column]),
                       range.from, range.to));
  }
  return *value;
}

void CsvFile::refuse(const std::string& what) const {
  constexpr std::size_t kMostBytes = 300;  // what stands in the file may be anything
  throw InputError{fmt::format("{}: line {}: {}", path_, number_, printable(what, kMostBytes))};
}

}  // namespace quickstrip::hull_tool
