// HDT and THS: true heading; ROT: rate of turn.
#include "firmware/nmea/families.hpp"

namespace quickstrip::nmea {

// $--HDT,x.x,T: deprecated by IEC 61162-1 in favour of THS, and still what most gyros send.
Fate read_hdt(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (!is_letter(cut.field(1), 'T')) {
    gather.refuse(Fate::kBadField);
  }
  gather.take_direction(Quantity::kHeading, cut.field(0));
  return gather.fate();
}

// $--THS,x.x,a: a = A autonomous; E estimated, M manual, S simulator, V not valid: none of these is a heading
// to steer a storm by.
Fate read_ths(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (is_letter(cut.field(1), 'A')) {
    gather.take_direction(Quantity::kHeading, cut.field(0));
  } else if (!is_one_of(cut.field(1), "EMSV")) {
    gather.refuse(Fate::kBadField);
  }
  return gather.fate();
}

// $--ROT,x.x,A: degrees a minute, negative when the bow turns to port; A valid, V not.
Fate read_rot(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (is_letter(cut.field(1), 'A')) {
    gather.take(Quantity::kRateOfTurn, cut.field(0));
  } else if (!is_one_of(cut.field(1), "V")) {
    gather.refuse(Fate::kBadField);
  }
  return gather.fate();
}

}  // namespace quickstrip::nmea
