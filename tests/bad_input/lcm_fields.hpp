// The fields of a message type and where they lie in its encoding, read from its .lcm file: so that a test
// reaches every field, those added later too. LCM: 8 bytes of fingerprint, then the fields in order,
// big-endian, packed; fixed arrays element by element.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace quickstrip::test {

struct LcmField {
  std::string name;        // "hs_m", "states.hs_m"
  std::string type;        // int8_t, int16_t, int32_t, int64_t, byte, float, double
  std::size_t offset = 0;  // of the first element
  std::size_t size = 0;    // of an element
  std::size_t num_elements = 1;
  std::size_t stride = 0;  // from element to element

  [[nodiscard]] bool is_number() const { return type == "double" || type == "float"; }
};

/// Of msgs/TYPE.lcm.
std::vector<LcmField> lcm_fields(const std::string& type);

}  // namespace quickstrip::test
