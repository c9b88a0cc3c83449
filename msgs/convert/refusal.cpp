#include "msgs/convert/refusal.hpp"

namespace quickstrip {

const char* message(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNone:
      return "not refused";
    case Refusal::kMalformed:
      return "does not decode as the type of its channel";
    case Refusal::kCount:
      return "a count lies outside its array";
    case Refusal::kNotFinite:
      return "a number is not finite";
    case Refusal::kFieldMissing:
      return "a required field is not marked as valid";
    case Refusal::kUnknownKind:
      return "a kind that is not known";
    case Refusal::kOutOfRange:
      return "a number lies outside its physical range";
    case Refusal::kHeight:
      return "the wave height is not between 0 and 30 m";
    case Refusal::kPeriod:
      return "the wave period is not between 1 and 40 s";
    case Refusal::kDirection:
      return "a direction is not in [0, 360) degrees";
    case Refusal::kNotOrdered:
      return "frequencies must increase, directions be evenly spaced all round";
    case Refusal::kEmpty:
      return "the spectrum holds no energy";
    case Refusal::kTime:
      return "the time of measurement does not lie between 1970 and 2200";
    case Refusal::kInconsistent:
      return "fields contradict each other";
    case Refusal::kSpeedOutsideGrid:
      return "the speed lies outside the grid";
    case Refusal::kNotReady:
      return "there is no advice to explain";
    case Refusal::kFromTheFuture:
      return "the time of measurement lies in the future";
    case Refusal::kForeignSource:
      return "its sender is not on the list of those allowed";
  }
  return "unknown reason";
}

}  // namespace quickstrip
