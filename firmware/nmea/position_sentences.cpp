// RMC and GGA: position, and RMC's speed and course over ground. DPT and DBT: depth of the water.
#include <cmath>

#include "firmware/nmea/families.hpp"

namespace quickstrip::nmea {
namespace {

constexpr double kMinutesPerDegree = 60.0;
constexpr double kHundred = 100.0;

/// llll.ll,a: degrees times a hundred and minutes; `positive` or `negative` in the second field.
std::optional<double> angle(Gatherer& gather, std::string_view field, std::string_view letter, char positive,
                            char negative) {
  const std::optional<double> packed = gather.value_of(field);
  if (!packed) {
    return {};
  }
  const double degrees = std::floor(*packed / kHundred);
  const double minutes = *packed - degrees * kHundred;
  const bool is_negative = is_letter(letter, negative);
  if (!(*packed >= 0.0 && minutes < kMinutesPerDegree) || !(is_negative || is_letter(letter, positive))) {
    gather.refuse(Fate::kBadField);
    return {};
  }
  const double value = degrees + minutes / kMinutesPerDegree;
  return is_negative ? -value : value;
}

/// Four fields from `first` on: latitude, N or S, longitude, E or W. Both or none.
void take_position(Gatherer& gather, const Cut& cut, std::size_t first) {
  const std::optional<double> lat = angle(gather, cut.field(first), cut.field(first + 1), 'N', 'S');
  const std::optional<double> lon = angle(gather, cut.field(first + 2), cut.field(first + 3), 'E', 'W');
  if (lat && lon) {
    gather.give(Quantity::kLatitude, *lat);
    gather.give(Quantity::kLongitude, *lon);
  }
}

}  // namespace

// $--RMC,hhmmss,A,llll.ll,a,yyyyy.yy,a,x.x,x.x,ddmmyy,x.x,a[,a[,a]]: status, position, speed over ground
// [kn], course true, date, variation, mode, navigational status. Its time of day is not used: utime is that
// of arrival.
Fate read_rmc(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  if (!is_letter(cut.field(1), 'A')) {
    gather.refuse(is_one_of(cut.field(1), "V") ? Fate::kNotValid : Fate::kBadField);
  }
  if (!is_one_of(cut.field(11), kMeasuredModes)) {
    gather.refuse(is_one_of(cut.field(11), kOtherModes) ? Fate::kNotValid : Fate::kBadField);
  }
  take_position(gather, cut, 2);
  gather.take(Quantity::kSpeedOverGround, cut.field(6));
  gather.take_direction(Quantity::kCourse, cut.field(7));
  return gather.fate();
}

// $--GGA,hhmmss,llll.ll,a,yyyyy.yy,a,q,...: q = 0 no fix, 1 to 5 measured, 6 estimated, 7 manual, 8
// simulator.
Fate read_gga(const Cut& cut, Readings& out) {
  Gatherer gather(out);
  const std::string_view quality = cut.field(5);
  if (quality.empty() || !is_one_of(quality, "12345")) {
    gather.refuse(is_one_of(quality, "0678") ? Fate::kNotValid : Fate::kBadField);
  }
  take_position(gather, cut, 1);
  return gather.fate();
}

// $--DPT,x.x,x.x[,x.x]: depth below the transducer [m]; offset: positive from the water line to the
// transducer, negative from the keel to it. The field wanted counts from the surface: the transducer's
// draught is the offset if positive, else what the option says; without either the depth comes out too small,
// which errs to the side of the shallow-water flag.
Fate read_dpt(const Cut& cut, double transducer_depth_m, Readings& out) {
  Gatherer gather(out);
  const std::optional<double> below = gather.value_of(cut.field(0));
  const std::optional<double> offset = gather.value_of(cut.field(1));
  if (below) {
    const double draught = offset && *offset > 0.0 ? *offset : transducer_depth_m;
    gather.give(Quantity::kDepth, *below + draught);
  }
  return gather.fate();
}

// $--DBT,x.x,f,x.x,M,x.x,F: depth below the transducer in feet, metres, fathoms.
Fate read_dbt(const Cut& cut, double transducer_depth_m, Readings& out) {
  Gatherer gather(out);
  if (!is_letter_or_empty(cut.field(3), 'M')) {
    gather.refuse(Fate::kBadField);
  }
  if (const std::optional<double> below = gather.value_of(cut.field(2))) {
    gather.give(Quantity::kDepth, *below + transducer_depth_m);
  }
  return gather.fate();
}

}  // namespace quickstrip::nmea
