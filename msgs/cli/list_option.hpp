// LIST of the command line: `10`, `0,5,10` or `from:to:step` (both ends included: when the step does not
// divide the range, the last interval is shorter); these may be mixed, `0,10:20:5`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quickstrip {

struct ListRange {
  double from = 0.0;
  double to = 0.0;
  bool from_excluded = false;
};

/// Directions on a command line (contract §3); given back as they were given.
inline constexpr ListRange kDirections_deg{-360.0, 360.0, true};

/// Every value finite and inside `range`; at most 10,000 values. Throws CLI::ValidationError (wrong use).
std::vector<double> parse_list(std::string_view option, std::string_view text, ListRange range);

/// An option that takes a LIST: add_list(app, "--omega", omega, {0.01, 10.0}, "wave frequency [rad/s]").
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<double>& values, ListRange range,
                      const std::string& description);

/// At most a million rows of output from lists that are combined; throws CLI::ValidationError.
void refuse_too_many(const char* options, std::initializer_list<std::size_t> counts);

/// An option that takes one finite number inside `range`.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, ListRange range,
                        const std::string& description);
/// The same, left empty when the option is not given.
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, ListRange range,
                        const std::string& description);

}  // namespace quickstrip
