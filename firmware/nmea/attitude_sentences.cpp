// PSXN (Kongsberg Seapath), PASHR (Applanix POS MV, NovAtel, Trimble and others), XDR: roll, pitch, heave.
//
// Signs wanted: roll starboard down +, pitch bow DOWN +, heave up + (only its RMS and period are used, so
// that a wrong sign of heave changes nothing). Signs sent:
//   PSXN   roll port side up +, pitch bow up +, heave DOWN +   Seapath, as archives of ships' data quote it
//   PASHR  roll port side up +, pitch bow up +, heave up +     fields: NovAtel OEM7 and Trimble manuals; they
//                                                              state no sign: this is the custom of attitude
//                                                              sensors (POS MV, from memory)
//   XDR    roll to starboard +, pitch bow up +, heave up +     Airmar WeatherStation manual; heave by custom
// A sensor that is mounted or set otherwise: `--invert roll,pitch,heave`.
#include "firmware/nmea/families.hpp"

namespace quickstrip::nmea {
namespace {

constexpr double kAsSent = 1.0;
constexpr double kTurned = -1.0;

bool contains(std::string_view name, std::string_view part) {
  return name.find(part) != std::string_view::npos;
}

/// $PSXN,20,horizontal,height,heading,roll and pitch: 0 normal, 1 reduced, 2 not valid. Holds for the PSXN,23
/// that follows it.
Fate note_psxn_quality(const Cut& cut, PsxnQuality& quality) {
  for (std::size_t i = 1; i <= 4; ++i) {
    if (cut.field(i).empty() || !is_one_of(cut.field(i), "012")) {
      return Fate::kBadField;
    }
  }
  quality.is_height_bad = is_letter(cut.field(2), '2');
  quality.is_heading_bad = is_letter(cut.field(3), '2');
  quality.is_attitude_bad = is_letter(cut.field(4), '2');
  return Fate::kNotUsed;
}

/// $PSXN,23,roll,pitch,heading,heave.
Fate read_psxn_attitude(const Cut& cut, const PsxnQuality& quality, Readings& out) {
  Gatherer gather(out);
  if (!quality.is_attitude_bad) {
    gather.take(Quantity::kRoll, cut.field(1), kAsSent);
    gather.take(Quantity::kPitch, cut.field(2), kTurned);
  }
  if (!quality.is_heading_bad) {
    gather.take_direction(Quantity::kHeading, cut.field(3));
  }
  if (!quality.is_height_bad) {
    gather.take(Quantity::kHeave, cut.field(4), kTurned);
  }
  return gather.fate();
}

}  // namespace

// 22 (gyro calibration and offset), 24 (rates) and others are not used.
Fate read_psxn(const Cut& cut, PsxnQuality& quality, Readings& out) {
  out.clear();
  if (cut.field(0) == "20") {
    return note_psxn_quality(cut, quality);
  }
  return cut.field(0) == "23" ? read_psxn_attitude(cut, quality, out) : Fate::kNotUsed;
}

// $PASHR,hhmmss.sss,heading,T,roll,pitch,heave,roll accuracy,pitch accuracy,heading accuracy,q[,i]: q = 0
// without position aiding. Ashtech's own PASHR begins with letters (POS, ATT, ...): other sentences.
Fate read_pashr(const Cut& cut, Readings& out) {
  out.clear();
  if (!number(cut.field(0))) {
    return Fate::kNotUsed;
  }
  Gatherer gather(out);
  if (!is_letter_or_empty(cut.field(2), 'T')) {
    gather.refuse(Fate::kBadField);
  }
  gather.take_direction(Quantity::kHeading, cut.field(1));
  gather.take(Quantity::kRoll, cut.field(3), kAsSent);
  gather.take(Quantity::kPitch, cut.field(4), kTurned);
  gather.take(Quantity::kHeave, cut.field(5), kAsSent);
  return gather.fate();
}

// $--XDR, then by fours: type, value, unit, name. Names are the maker's: those that contain ROLL or HEEL,
// PTCH or PITCH (angle in degrees), HEAVE (displacement in metres) are taken; others are passed over.
Fate read_xdr(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  bool is_ours = false;
  for (std::size_t i = 0; i + 3 < cut.fields.size(); i += 4) {
    const std::string_view name = cut.field(i + 3);
    const bool is_angle = is_letter(cut.field(i), 'A') && is_letter(cut.field(i + 2), 'D');
    const bool is_distance = is_letter(cut.field(i), 'D') && is_letter(cut.field(i + 2), 'M');
    if (is_angle && (contains(name, "ROLL") || contains(name, "HEEL"))) {
      gather.take(Quantity::kRoll, cut.field(i + 1), kAsSent);
    } else if (is_angle && (contains(name, "PTCH") || contains(name, "PITCH"))) {
      gather.take(Quantity::kPitch, cut.field(i + 1), kTurned);
    } else if (is_distance && contains(name, "HEAVE")) {
      gather.take(Quantity::kHeave, cut.field(i + 1), kAsSent);
    } else {
      continue;
    }
    is_ours = true;
  }
  return is_ours ? gather.fate() : Fate::kNotUsed;
}

}  // namespace quickstrip::nmea
