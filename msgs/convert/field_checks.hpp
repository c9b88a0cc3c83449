// Checks shared by the converters of messages; each yields the Conversion that names the field.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "msgs/convert/ranges.hpp"
#include "msgs/convert/refusal.hpp"

namespace quickstrip {

struct NamedField {
  const char* name;
  std::span<const double> values;
};

inline NamedField field(const char* name, const double& value) {
  return {name, {&value, 1}};
}

/// NaN and infinity are refused in every field, marked valid or not (contract §5).
inline Conversion all_finite(std::initializer_list<NamedField> fields) {
  for (const NamedField& named : fields) {
    for (std::size_t i = 0; i < named.values.size(); ++i) {
      if (!std::isfinite(named.values[i])) {
        return {Refusal::kNotFinite, named.name, named.values.size() > 1 ? static_cast<int>(i) : -1};
      }
    }
  }
  return {};
}

inline bool is_direction(double degrees_value) {
  return degrees_value >= 0.0 && degrees_value < 360.0;
}

/// lcm-gen makes an enum of its own of each constant; this joins them.
inline std::int32_t bits(std::initializer_list<std::int32_t> list) {
  std::int32_t joined = 0;
  for (const std::int32_t bit : list) {
    joined |= bit;
  }
  return joined;
}

inline bool has(std::int32_t valid, std::int32_t bit) {
  return (valid & bit) != 0;
}

}  // namespace quickstrip
