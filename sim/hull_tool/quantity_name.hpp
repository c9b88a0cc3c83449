// Names and units of quantities on the command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/hull/hull.hpp"
#include "core/response/quantity.hpp"

namespace quickstrip::hull_tool {

struct QuantityName {
  const char* name;
  const char* unit;  // of rms and significant
};

QuantityName name_of(Quantity quantity);

/// Empty for a name that is none.
std::optional<Quantity> quantity_of(std::string_view name);

/// Every name, "surge, sway, ...".
std::string quantity_names();

/// Of a quantity of the watch on board: the hull file's name of the place, "propeller", "G".
std::string place_of(Quantity quantity, std::uint8_t place, const Hull& hull);

}  // namespace quickstrip::hull_tool
