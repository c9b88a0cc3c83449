#include "firmware/cortex-m7/ship/ship.hpp"

extern "C" {
extern const std::uint32_t quickstrip_hull_table[];
extern const std::uint32_t quickstrip_hull_table_end[];
}

namespace quickstrip::ship {

std::span<const std::uint32_t> table_words() {
  return {quickstrip_hull_table, quickstrip_hull_table_end};
}

void add_station(Hull& hull, const StationForm& form, std::span<const double[2]> offsets) {
  QS_CHECK(hull.stations.push_back({}));
  Station& station = hull.stations.back();
  station.x = form.x;
  station.breadth = form.breadth;
  station.draught = form.draught;
  station.area = form.area;
  for (const auto& offset : offsets) {
    add(station.offsets, {offset[0], offset[1]});
  }
}

}  // namespace quickstrip::ship
