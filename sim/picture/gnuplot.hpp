// Runs gnuplot (Debian: gnuplot-nox) on a script.
#pragma once

#include <functional>
#include <string>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// `script` gets the name of a file beside `png`, which is renamed to `png` when gnuplot has succeeded: no
/// half-drawn picture is left.
FileStatus draw_with_gnuplot(const std::function<std::string(const std::string& png)>& script,
                             const std::string& png);

}  // namespace quickstrip
