// Why a message was not taken. A converter returns a Conversion: ok, or the reason and the field, without
// heap.
#pragma once

#include <cstdint>

namespace quickstrip {

/// The numbers travel in health_t and response_t: append only.
enum class Refusal : std::int16_t {
  kNone = 0,
  kMalformed = 1,          // does not decode: wrong type, version or length
  kCount = 2,              // a count outside its array
  kNotFinite = 3,          // NaN or infinity, in any field whether marked valid or not
  kFieldMissing = 4,       // a required field is not marked in `valid`
  kUnknownKind = 5,        // an enumerator that we do not know
  kOutOfRange = 6,         // outside the field's physical range
  kHeight = 7,             // wave height not in (0, 30] m
  kPeriod = 8,             // wave period not in 1 ... 40 s
  kDirection = 9,          // a direction not in [0, 360)
  kNotOrdered = 10,        // frequencies not increasing, or directions not evenly spaced all round
  kEmpty = 11,             // a spectrum without energy
  kTime = 12,              // a time not between 1970 and 2200
  kInconsistent = 13,      // fields that contradict each other
  kSpeedOutsideGrid = 14,  // a query for a speed that is not swept
  kNotReady = 15,          // a query while there is no advice
  kFromTheFuture = 16,     // measured later than our clock's time, by more than the tolerance
  kForeignSource = 17,     // of a source that is not on the list of those allowed
};

/// One short clause of English, no full stop.
const char* message(Refusal refusal);

struct [[nodiscard]] Conversion {
  Refusal refusal = Refusal::kNone;
  const char* field = "";  // name of the first field refused
  int index = -1;          // within an array; -1: no array

  [[nodiscard]] bool ok() const { return refusal == Refusal::kNone; }
  explicit operator bool() const { return ok(); }
};

}  // namespace quickstrip
