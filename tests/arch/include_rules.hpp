// Which file may include which: the arrows of the house as one table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quickstrip::arch {

/// What is wrong with the includes of the file `path` with this `text`: one line each; empty when all is
/// well.
std::vector<std::string> forbidden_includes(const std::string& path, std::string_view text);

}  // namespace quickstrip::arch
