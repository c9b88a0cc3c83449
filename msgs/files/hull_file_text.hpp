// The other way of the reader of hull files: the ship as the text of a hull file (TOML). Read again it is the
// same ship, to ten significant digits; comments of a file that it came from, and which of its values were
// left to defaults, are lost.
#pragma once

#include <string>
#include <string_view>

#include "core/hull/hull.hpp"

namespace quickstrip {

/// `comment`: lines without "# ", at the head of the file: where the ship comes from.
std::string hull_file_text(const Hull& hull, std::string_view comment);

/// As the text above writes numbers: ten digits, and a point or an exponent.
std::string toml_number(double value);

}  // namespace quickstrip
