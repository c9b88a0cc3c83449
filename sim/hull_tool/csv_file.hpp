// A CSV file read line by line: '#' begins a comment line, blank lines are skipped, the first line left names
// the columns. Refusals name file and line. No quoting: numbers and words only.
#pragma once

#include <cstddef>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/cli/list_option.hpp"

namespace quickstrip::hull_tool {

class CsvFile {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Opens, and reads the header. Throws InputError, as do all below.
  explicit CsvFile(const std::string& path);

  /// The first column of the header that has one of these names; kNone without.
  [[nodiscard]] std::size_t column(std::initializer_list<std::string_view> names) const;

  /// The next line, as many fields as the header; false at the end.
  bool next_line();

  [[nodiscard]] std::string_view field(std::size_t column) const { return fields_[column]; }
  /// `name` is what refusals call it.
  [[nodiscard]] double number(std::size_t column, std::string_view name, ListRange range) const;

  [[noreturn]] void refuse(const std::string& what) const;

 private:
  bool read_line();

  std::string path_;
  std::ifstream stream_;
  std::string line_;
  std::string header_;
  std::size_t number_ = 0;
  std::vector<std::string_view> fields_;
  std::vector<std::string_view> names_;
};

}  // namespace quickstrip::hull_tool
