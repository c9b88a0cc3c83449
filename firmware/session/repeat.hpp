// When something that is sent every so often is sent again.
#pragma once

#include <cstdint>

#include "msgs/convert/units.hpp"

namespace quickstrip {

/// So long after it was sent at `sent` (0: never); or the clock was set back behind that: a replay started
/// anew, or one wrong time came, and what waited for the old time would be silent until then.
inline bool is_due_again(std::int64_t sent, std::int64_t now, double every_s) {
  const double age = seconds_between(sent, now);
  return !(age >= 0.0 && age < every_s);
}

}  // namespace quickstrip
