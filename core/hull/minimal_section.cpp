#include "core/hull/minimal_section.hpp"

#include <algorithm>
#include <cmath>

#include "core/hull/lewis_section.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kPoints = 41;

// Share of the points on the lower side of the skeg's kink.
constexpr double kKink = 0.5;

// t = 0 at the keel ... 1 at the waterline. Two straight lines: area (1 - sigma + 1 + sigma) sigma B T / 2.
Offset skeg_point(double breadth, double draught, double sigma, double t) {
  if (t <= kKink) {
    const double s = t / kKink;
    return {0.5 * breadth * sigma * s, -draught * (1.0 - (1.0 - sigma) * s)};
  }
  const double s = (t - kKink) / (1.0 - kKink);
  return {0.5 * breadth * (sigma + (1.0 - sigma) * s), -draught * sigma * (1.0 - s)};
}

Offset bulb_point(double breadth, double draught, double area, double t) {
  const double c = 6.0 * (0.5 * area / draught - 0.25 * breadth);
  return {0.5 * breadth * t + c * t * (1.0 - t), -draught * (1.0 - t)};
}

bool has_plain_lewis_form(const Result<LewisSection>& lewis) {
  return lewis.ok() && lewis->lewis_class != LewisClass::kReentrant;
}

using Contour = StaticVector<Offset, kMaxOffsets + 2>;

// Integral over the whole section of y (-z/draught)^power dz and its first moment in z, as measured on a
// polygon whose sides are straight in y f and z.
struct Integrals {
  double area = 0.0;
  double moment = 0.0;
};

Integrals integrals_of(const Contour& contour, double draught, int power) {
  Integrals sum;
  const auto weighed = [&](const Offset& offset) {
    const double t = -offset.z / draught;
    return power == 0 ? offset.y : power == 1 ? offset.y * t : offset.y * t * t;
  };
  for (std::size_t i = 1; i < contour.size(); ++i) {
    const Offset& p = contour[i - 1];
    const Offset& q = contour[i];
    const double dz = q.z - p.z;
    const double yp = weighed(p);
    const double yq = weighed(q);
    sum.area += dz * (yp + yq);
    sum.moment += dz / 3.0 * (p.z * (2.0 * yp + yq) + q.z * (yp + 2.0 * yq));
  }
  return sum;
}

// y (1 + c1 t + c2 t^2), t = 0 at the waterline, 1 at the keel; false (nothing done) where y would turn
// negative.
bool widen(double c1, double c2, double draught, Contour& contour) {
  for (const Offset& offset : contour) {
    const double t = -offset.z / draught;
    if (!(1.0 + t * (c1 + c2 * t) >= 0.0)) {
      return false;
    }
  }
  for (Offset& offset : contour) {
    const double t = -offset.z / draught;
    offset.y *= 1.0 + t * (c1 + c2 * t);
  }
  return true;
}

// Exact for the polygon, whose area and moment are linear in y.
void fit(double area, double moment, bool fit_moment, double draught, Contour& contour) {
  const Integrals now = integrals_of(contour, draught, 0);
  const Integrals first = integrals_of(contour, draught, 1);
  const Integrals second = integrals_of(contour, draught, 2);
  const double missing_area = area - now.area;
  const double missing_moment = moment - now.moment;
  const double determinant = first.area * second.moment - second.area * first.moment;
  const double c1 = (missing_area * second.moment - missing_moment * second.area) / determinant;
  const double c2 = (first.area * missing_moment - first.moment * missing_area) / determinant;
  if (!fit_moment || !widen(c1, c2, draught, contour)) {
    // A few per cent at most: the area of the curves above is right but for the polygon and the flat bottom.
    QS_CHECK(widen(missing_area / first.area, 0.0, draught, contour));
  }
}

// Morrish's rule for the depth of the centre of buoyancy, (T/2 + volume/waterplane)/3, written for a section:
// exact for the rectangle and the triangle, 0.4 % of T too deep for the semicircle. For sigma <= 1.
double centroid_of(double breadth, double draught, double area) {
  return -(0.5 * draught + area / breadth) / 3.0;
}

}  // namespace

void minimal_contour(double breadth, double draught, double area, Contour& contour) {
  contour.clear();
  const Result<LewisSection> lewis = lewis_section(breadth, draught, area);
  const double sigma = area < breadth * draught ? area / (breadth * draught) : 1.0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(kPoints - 1);
    Offset offset;
    if (has_plain_lewis_form(lewis)) {
      const ContourPoint point = contour_point(*lewis, 0.5 * kPi * t);
      offset = {std::max(0.0, point.y), std::clamp(point.z, -draught, 0.0)};
    } else {
      offset = sigma < 1.0 ? skeg_point(breadth, draught, sigma, t) : bulb_point(breadth, draught, area, t);
    }
    offset.z = i > 0 ? std::max(offset.z, contour.back().z) : -draught;
    if (i + 1 == kPoints) {
      offset = {0.5 * breadth, 0.0};
    }
    QS_CHECK(contour.push_back(offset));
  }
  const bool full = area > breadth * draught;  // bulb: the curve's own centroid
  fit(area, full ? 0.0 : area * centroid_of(breadth, draught, area), !full, draught, contour);
}

}  // namespace quickstrip
