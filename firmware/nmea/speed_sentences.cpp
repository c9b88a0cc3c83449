// VTG, VHW, VBW: speed over ground and through the water.
#include <cmath>

#include "firmware/nmea/families.hpp"

namespace quickstrip::nmea {

// $--VTG,x.x,T,x.x,M,x.x,N,x.x,K[,a]: course true, course magnetic, speed in knots, speed in km/h, mode.
Fate read_vtg(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (!is_one_of(cut.field(8), kMeasuredModes)) {
    gather.refuse(is_one_of(cut.field(8), kOtherModes) ? Fate::kNotValid : Fate::kBadField);
  }
  if (!is_letter_or_empty(cut.field(1), 'T') || !is_letter_or_empty(cut.field(5), 'N')) {
    gather.refuse(Fate::kBadField);
  }
  gather.take_direction(Quantity::kCourse, cut.field(0));
  gather.take(Quantity::kSpeedOverGround, cut.field(4));
  return gather.fate();
}

// $--VHW,x.x,T,x.x,M,x.x,N,x.x,K: heading true, heading magnetic, speed through the water in knots, in km/h.
Fate read_vhw(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (!is_letter_or_empty(cut.field(1), 'T') || !is_letter_or_empty(cut.field(5), 'N')) {
    gather.refuse(Fate::kBadField);
  }
  gather.take_direction(Quantity::kHeading, cut.field(0));
  gather.take(Quantity::kSpeedThroughWater, cut.field(4));
  return gather.fate();
}

// $--VBW,x.x,x.x,A,x.x,x.x,A[,x.x,A,x.x,A]: longitudinal and transverse speed through the water with status,
// the same over ground, then transverse at the stern; knots, ahead and to starboard positive. One of the two
// may be valid alone. Over ground own_ship_t takes the amount: both components.
Fate read_vbw(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  for (const std::size_t status : {std::size_t{2}, std::size_t{5}}) {
    if (!is_one_of(cut.field(status), "AV")) {
      gather.refuse(Fate::kBadField);
    }
  }
  if (is_letter(cut.field(2), 'A')) {
    gather.take(Quantity::kSpeedThroughWater, cut.field(0));
  }
  if (is_letter(cut.field(5), 'A')) {
    const std::optional<double> ahead = gather.value_of(cut.field(3));
    const std::optional<double> to_starboard = gather.value_of(cut.field(4));
    if (ahead) {
      gather.give(Quantity::kSpeedOverGround, std::hypot(*ahead, to_starboard.value_or(0.0)));
    }
  }
  return gather.fate();
}

}  // namespace quickstrip::nmea
