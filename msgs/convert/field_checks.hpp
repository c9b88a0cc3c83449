// Checks shared by the converters of messages; each yields the Conversion that names the field.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "msgs/convert/ranges.hpp"
#include "msgs/convert/refusal.hpp"
#include "msgs/convert/units.hpp"

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

inline Conversion check_position(double lat_deg, double lon_deg) {
  if (!(lat_deg >= -90.0 && lat_deg <= 90.0)) {
    return {Refusal::kOutOfRange, "lat_deg"};
  }
  return lon_deg >= -180.0 && lon_deg <= 360.0 ? Conversion{} : Conversion{Refusal::kOutOfRange, "lon_deg"};
}

/// A sea that ceased to hold before it was measured would never be used: the sender is told why.
inline Conversion check_valid_until(std::int64_t utime, std::int64_t valid_until_utime) {
  if (!is_time(valid_until_utime)) {
    return {Refusal::kTime, "valid_until_utime"};
  }
  return valid_until_utime >= utime ? Conversion{} : Conversion{Refusal::kInconsistent, "valid_until_utime"};
}

/// lcm-gen makes an enum of its own of each constant; this joins them.
inline std::int32_t bits(std::initializer_list<std::int32_t> list) {
  std::int32_t joined = 0;
  for (const std::int32_t bit : list) {
    joined |= bit;
  }
  return joined;
}

/// A bit of `valid` that its type does not have: types never change (contract §5), so it is a slip, and what
/// it stands for is not guessed.
inline Conversion only_known_bits(std::int32_t valid, std::int32_t known) {
  return (valid & ~known) == 0 ? Conversion{} : Conversion{Refusal::kUnknownKind, "valid"};
}

inline bool has(std::int32_t valid, std::int32_t bit) {
  return (valid & bit) != 0;
}

}  // namespace quickstrip
