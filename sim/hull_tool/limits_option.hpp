// --limits FILE: the criteria that a command judges by.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "msgs/files/limits_file.hpp"
#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {

void add_limits_option(CLI::App& command, std::string& limits);

/// Empty `limits`: NORDFORSK 1987 for merchant ships, as on board. Throws InputError.
LimitsProfile limits_of(const std::string& limits, const FloatingHull& ship);

}  // namespace quickstrip::hull_tool
