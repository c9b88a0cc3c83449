#include "sim/hull_tool/local_options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_file_places.hpp"
#include "sim/hull_tool/quantity_name.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr std::size_t kMostPoints = 16;

// The whole text, dot as decimal mark, finite.
std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value) ? std::optional<double>(value)
                                                                           : std::nullopt;
}

GivenPoint point_in(const std::string& text) {
  std::array<double, 3> values{};
  std::size_t from = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t to = text.find(',', from);
    const bool ends_well = (to == std::string::npos) == (i + 1 == values.size());
    const std::optional<double> value = number_in(text.substr(from, to - from));
    if (!ends_well || !value) {
      throw CLI::ValidationError("--point", text + ": three numbers x,y,z in metres are wanted, as 30,0,35");
    }
    values[i] = *value;
    from = to + 1;
  }
  return {text, values[0], values[1], values[2]};
}

GivenLevel level_in(const std::string& text) {
  const std::size_t mark = text.find('=');
  const std::optional<Quantity> quantity = quantity_of(text.substr(0, mark));
  const std::optional<double> level =
      mark == std::string::npos ? std::nullopt : number_in(text.substr(mark + 1));
  if (!quantity) {
    throw CLI::ValidationError("--level",
                               text + ": QUANTITY=VALUE is wanted with one of " + quantity_names());
  }
  if (!level || !(*level > 0.0)) {
    throw CLI::ValidationError("--level", fmt::format("{}: a value above 0 {} is wanted, as {}=0.2", text,
                                                      name_of(*quantity).unit, name_of(*quantity).name));
  }
  return {*quantity, *level};
}

void refuse_outside(const GivenPoint& point, const char* axis, double value, const NumberRange& range) {
  if (!(value >= range.from && value <= range.to)) {
    throw InputError{fmt::format("--point {}: {} = {:g}: a number from {:g} to {:g} {} is wanted", point.name,
                                 axis, value, range.from, range.to, range.unit)};
  }
}

}  // namespace

std::optional<double> LocalOptions::level_of(Quantity quantity) const {
  for (const GivenLevel& given : levels) {
    if (given.quantity == quantity) {
      return given.level;
    }
  }
  return std::nullopt;
}

void add_local_options(CLI::App& command, LocalOptions& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--point",
          [&options](const std::vector<std::string>& texts) {
            if (texts.size() > kMostPoints) {
              throw CLI::ValidationError("--point", fmt::format("at most {} points", kMostPoints));
            }
            for (const std::string& text : texts) {
              options.points.push_back(point_in(text));
            }
          },
          "x,y,z of a point as in the hull file [m]: its motions, velocities and accelerations; repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("X,Y,Z");
  command
      .add_option_function<std::vector<std::string>>(
          "--level",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              options.levels.push_back(level_in(text));
            }
          },
          "QUANTITY=VALUE in the unit of its rows: how often its amplitude exceeds that; repeatable")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME=X");
}

void check_points(const LocalOptions& options, const Hull& hull) {
  for (const GivenPoint& point : options.points) {
    refuse_outside(point, "x", point.x, on_the_ship(hull));
    refuse_outside(point, "y", point.y, across_the_ship(hull));
    refuse_outside(point, "z", point.z, above_the_base(hull));
  }
}

}  // namespace quickstrip::hull_tool
