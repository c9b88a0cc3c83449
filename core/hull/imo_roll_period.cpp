#include "core/hull/imo_roll_period.hpp"

#include <cmath>

namespace quickstrip {

Result<double> imo_roll_period(double length, double breadth, double draught, double gm) {
  if (!std::isfinite(length) || !std::isfinite(breadth) || !std::isfinite(draught) || !std::isfinite(gm)) {
    return Error::kNotFinite;
  }
  if (!(length > 0.0) || !(breadth > 0.0) || !(draught > 0.0) || !(gm > 0.0)) {
    return Error::kOutOfRange;
  }
  const double c = 0.373 + 0.023 * breadth / draught - 0.043 * length / 100.0;  // IS Code A 2.3.5
  if (!(c > 0.0)) {
    return Error::kOutOfRange;
  }
  return 2.0 * c * breadth / std::sqrt(gm);
}

}  // namespace quickstrip
