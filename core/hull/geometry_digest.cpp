#include "core/hull/geometry_digest.hpp"

#include "core/base/fnv1a64.hpp"

namespace quickstrip {

std::uint64_t geometry_digest(const Hull& hull) {
  Fnv1a64 hash;
  hash.add(hull.lpp);
  for (const Station& station : hull.stations) {
    hash.add(station.x);
    hash.add(static_cast<std::uint32_t>(station.offsets.size()));
    for (const Offset& offset : station.offsets) {
      hash.add(offset.y);
      hash.add(offset.z);
    }
    if (station.is_minimal()) {
      hash.add(station.breadth);
      hash.add(station.draught);
      hash.add(station.area);
    }
  }
  return hash.value();
}

}  // namespace quickstrip
