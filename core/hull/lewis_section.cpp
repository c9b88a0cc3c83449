#include "core/hull/lewis_section.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// Distance kept from the bounds of sigma, where the contour gets a cusp. SCORES (Raff 1970) uses 1.0001 and
// 0.9999 on sigma too.
constexpr double kLimitMargin = 1e-4;
// The section that replaces a bulb keeps draught and area at this fullness (a22 11 ... 16 % low for the
// S-175's bulb; clipping sigma instead loses nearly all of it).
constexpr double kReplacementSigma = 0.9;

double fold(double h0) {
  return std::min(h0, 1.0 / h0);
}

LewisClass classify(double h0, double sigma) {
  if (sigma < reentrant_limit(h0)) {
    return LewisClass::kReentrant;
  }
  if (sigma <= conventional_limit(h0)) {
    return LewisClass::kConventional;
  }
  if (sigma <= single_bulge_limit(h0)) {
    return h0 <= 1.0 ? LewisClass::kBulbous : LewisClass::kTunnelled;
  }
  return LewisClass::kBulbousAndTunnelled;
}

// For sigma <= upper_limit(h0), all positive.
LewisSection map_section(double breadth, double draught, double sigma) {
  LewisSection section;
  section.breadth = breadth;
  section.draught = draught;
  section.area = sigma * breadth * draught;
  section.h0 = breadth / (2.0 * draught);
  section.sigma = sigma;
  // [vonKerczekTuck1969] as in SCORES, rederived: a3 from the area, a1 from the breadth-draught ratio.
  const double q = (section.h0 - 1.0) / (section.h0 + 1.0);
  const double c1 = 3.0 + 4.0 * sigma / kPi + (1.0 - 4.0 * sigma / kPi) * q * q;
  section.a3 = (3.0 - c1 + std::sqrt(std::max(0.0, 9.0 - 2.0 * c1))) / c1;
  section.a1 = q * (1.0 + section.a3);
  section.scale = 0.5 * breadth / (1.0 + section.a1 + section.a3);
  section.lewis_class = classify(section.h0, sigma);
  return section;
}

// Brings H0 and sigma into the range; the last resort.
LewisSection extrapolated_section(double breadth, double draught, double sigma) {
  const double h0 = breadth / (2.0 * draught);
  if (h0 < kMinTabulatedH0) {
    breadth = 2.0 * kMinTabulatedH0 * draught;
  } else {
    draught = breadth / (2.0 * kMaxTabulatedH0);
  }
  const double used_h0 = h0 < kMinTabulatedH0 ? kMinTabulatedH0 : kMaxTabulatedH0;
  const double lowest = reentrant_limit(used_h0) * (1.0 + kLimitMargin);
  const double highest = upper_limit(used_h0) * (1.0 - kLimitMargin);
  LewisSection section = map_section(breadth, draught, std::clamp(sigma, lowest, highest));
  section.extrapolated = true;
  return section;
}

LewisSection replacement(double breadth, double draught, double area) {
  const double h0 = breadth / (2.0 * draught);
  const double sigma = breadth > 0.0 ? area / (breadth * draught) : 0.0;
  if (h0 > kMaxTabulatedH0) {
    return extrapolated_section(breadth, draught, sigma);
  }
  if (h0 >= kMinTabulatedH0 && sigma < reentrant_limit(h0)) {
    return map_section(breadth, draught, reentrant_limit(h0) * (1.0 + kLimitMargin));
  }
  const double used_breadth = area / (kReplacementSigma * draught);
  const double used_h0 = used_breadth / (2.0 * draught);
  if (!(used_h0 >= kMinTabulatedH0 && used_h0 <= kMaxTabulatedH0)) {
    return extrapolated_section(used_breadth, draught, kReplacementSigma);
  }
  return map_section(used_breadth, draught, kReplacementSigma);
}

}  // namespace

const char* name_of(LewisClass lewis_class) {
  switch (lewis_class) {
    case LewisClass::kReentrant:
      return "re-entrant";
    case LewisClass::kConventional:
      return "conventional";
    case LewisClass::kBulbous:
      return "bulbous";
    case LewisClass::kTunnelled:
      return "tunnelled";
    case LewisClass::kBulbousAndTunnelled:
      return "bulbous-tunnelled";
  }
  return "unknown";
}

double reentrant_limit(double h0) {
  return 3.0 * kPi / 32.0 * (2.0 - fold(h0));
}
double conventional_limit(double h0) {
  return 3.0 * kPi / 32.0 * (3.0 + 0.25 * fold(h0));
}
double single_bulge_limit(double h0) {
  return 3.0 * kPi / 32.0 * (3.0 + 0.25 / fold(h0));
}
double upper_limit(double h0) {
  return kPi / 32.0 * (10.0 + h0 + 1.0 / h0);
}

Result<LewisSection> lewis_section(double breadth, double draught, double area) {
  if (!std::isfinite(breadth) || !std::isfinite(draught) || !std::isfinite(area)) {
    return Error::kNotFinite;
  }
  if (!(breadth > 0.0 && draught > 0.0 && area > 0.0)) {
    return Error::kOutOfRange;
  }
  const double sigma = area / (breadth * draught);
  if (!(sigma <= upper_limit(breadth / (2.0 * draught)))) {
    return Error::kOutOfRange;
  }
  return map_section(breadth, draught, sigma);
}

Result<LewisSection> hydrodynamic_lewis_section(double breadth, double draught, double area) {
  if (!std::isfinite(breadth) || !std::isfinite(draught) || !std::isfinite(area)) {
    return Error::kNotFinite;
  }
  if (!(breadth >= 0.0 && draught > 0.0 && area > 0.0)) {
    return Error::kOutOfRange;
  }
  const double h0 = breadth / (2.0 * draught);
  if (h0 >= kMinTabulatedH0 && h0 <= kMaxTabulatedH0) {
    const double sigma = area / (breadth * draught);
    if (sigma >= reentrant_limit(h0) && sigma <= upper_limit(h0)) {
      return map_section(breadth, draught, sigma);
    }
  }
  LewisSection section = replacement(breadth, draught, area);
  section.replaced = true;
  return section;
}

ContourPoint contour_point(const LewisSection& section, double theta) {
  const double a1 = section.a1;
  const double a3 = section.a3;
  return {section.scale * ((1.0 + a1) * std::sin(theta) - a3 * std::sin(3.0 * theta)),
          -section.scale * ((1.0 - a1) * std::cos(theta) + a3 * std::cos(3.0 * theta))};
}

}  // namespace quickstrip
