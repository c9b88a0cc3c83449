#include "sim/hull_tool/csv.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/base/check.hpp"
#include "msgs/cli/run_tool.hpp"

namespace quickstrip::hull_tool {

std::string number_text(double value) {
  QS_CHECK(std::isfinite(value));  // a quantity that is not known is an empty field, never "nan"
  return fmt::format("{:.10g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

Csv& Csv::add(std::string_view value) {
  if (row_begun_) {
    text_ += ',';
  }
  row_begun_ = true;
  if (value.find_first_of(",\"\n\r") == std::string_view::npos) {
    text_ += value;
    return *this;
  }
  text_ += '"';
  for (const char c : value) {
    text_ += c;
    if (c == '"') {
      text_ += '"';
    }
  }
  text_ += '"';
  return *this;
}

void Csv::end_row() {
  text_ += '\n';
  row_begun_ = false;
}

void print_result(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw InputError{fmt::format("standard output: cannot be written: {}", std::strerror(errno))};
  }
}

}  // namespace quickstrip::hull_tool
