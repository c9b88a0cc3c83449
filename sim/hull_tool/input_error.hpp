// What stops a command: bad input or data (exit 1). One line that names file, field, value and what would be
// right. Wrong use (exit 2) is CLI11's own ParseError.
#pragma once

#include <string>

namespace quickstrip::hull_tool {

struct InputError {
  std::string line;
};

}  // namespace quickstrip::hull_tool
