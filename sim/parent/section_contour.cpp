#include "sim/parent/section_contour.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace quickstrip {
namespace {

// Shares of the section's size.
constexpr double kOnePoint = 1e-6;    // nearer points are one
constexpr double kOnTheAxis = 1e-4;   // a cut station whose keel is this near to the centre plane lies on it
constexpr double kNoDistance = 1e-9;  // rounding of the test for crossings

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

std::string point_text(std::size_t i) {
  return "point " + std::to_string(i + 1);
}

double size_of(const std::vector<Offset>& points) {
  double size = 0.0;
  for (const Offset& p : points) {
    size = std::max({size, std::abs(p.y), std::abs(p.z)});
  }
  return size;
}

double distance(const Offset& p, const Offset& q) {
  return std::hypot(p.y - q.y, p.z - q.z);
}

void check_points(const std::vector<Offset>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Offset& p = points[i];
    if (!std::isfinite(p.y) || !std::isfinite(p.z)) {
      refuse("a contour whose " + point_text(i) + " is not finite");
    }
    if (!(p.y >= 0.0)) {
      refuse("a contour that crosses the centre plane at " + point_text(i) + " (y < 0)");
    }
    if (!(p.z <= 0.0)) {
      refuse("a contour that leaves the water at " + point_text(i) + " (z > 0)");
    }
  }
}

// `number`: of each point among those given.
void check_ends(const std::vector<Offset>& points, const std::vector<std::size_t>& number) {
  const Offset& last = points.back();
  if (points.front().y > 0.0 || !(points.front().z < 0.0)) {
    refuse("a contour that does not begin at the keel on the centre plane, under water");
  }
  if (last.z < 0.0 && last.y > 0.0) {
    refuse("a contour that ends under water off the centre plane");
  }
  if (last.z == 0.0 && last.y == 0.0) {
    refuse("a contour without breadth at the waterline that reaches it (a submerged one ends below)");
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].z == 0.0) {
      refuse("a contour that is at the waterline before its end, at " + point_text(number[i]));
    }
    if (points[i].y == 0.0) {
      refuse("a contour that is at the centre plane between its ends, at " + point_text(number[i]));
    }
  }
}

// Twice the area of the triangle p q r, > 0 when r lies to the left of p -> q.
double turn(const Offset& p, const Offset& q, const Offset& r) {
  return (q.y - p.y) * (r.z - p.z) - (q.z - p.z) * (r.y - p.y);
}

double distance_to_side(const Offset& p, const Offset& a, const Offset& b) {
  const double length2 = (b.y - a.y) * (b.y - a.y) + (b.z - a.z) * (b.z - a.z);
  const double along = ((p.y - a.y) * (b.y - a.y) + (p.z - a.z) * (b.z - a.z)) / length2;
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
}

// They cross, or an end of one lies on the other.
bool meet(const Offset& a, const Offset& b, const Offset& c, const Offset& d, double near) {
  const bool cross = turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
  return cross || distance_to_side(c, a, b) < near || distance_to_side(d, a, b) < near ||
         distance_to_side(a, c, d) < near || distance_to_side(b, c, d) < near;
}

void check_crossings(const std::vector<Offset>& points, const std::vector<std::size_t>& number) {
  const auto side_text = [&number](std::size_t i) {
    return std::to_string(number[i] + 1) + "-" + std::to_string(number[i + 1] + 1);
  };
  const double near = kNoDistance * size_of(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    // Neighbours share a point: they meet elsewhere only where the contour turns back upon itself.
    if (i + 2 < points.size() && (distance_to_side(points[i + 2], points[i], points[i + 1]) < near ||
                                  distance_to_side(points[i], points[i + 1], points[i + 2]) < near)) {
      refuse("a contour that turns back upon itself at " + point_text(number[i + 1]));
    }
    for (std::size_t j = i + 2; j + 1 < points.size(); ++j) {
      if (meet(points[i], points[i + 1], points[j], points[j + 1], near)) {
        refuse("a contour that crosses itself between points " + side_text(i) + " and " + side_text(j));
      }
    }
  }
}

// Numbers of the points without sides of no length; the last point stays: the waterline.
std::vector<std::size_t> distinct_points(const std::vector<Offset>& points) {
  const double short_side = kOnePoint * size_of(points);
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (distance(points[kept.back()], points[i]) > short_side) {
      kept.push_back(i);
    }
  }
  if (kept.size() > 1) {
    kept.back() = points.size() - 1;
  }
  return kept;
}

// [y dz over the half contour], both sides.
double signed_area(const std::vector<Offset>& points) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    total += (points[i].z - points[i - 1].z) * (points[i].y + points[i - 1].y);
  }
  return total;
}

}  // namespace

SectionContour section_contour(const std::vector<Offset>& keel_to_waterline) {
  if (keel_to_waterline.size() < 3) {
    refuse("a contour of fewer than three points");
  }
  check_points(keel_to_waterline);
  const std::vector<std::size_t> number = distinct_points(keel_to_waterline);
  if (number.size() < 3) {
    refuse("a contour of fewer than three points that differ");
  }
  SectionContour contour;
  for (const std::size_t i : number) {
    contour.points.push_back(keel_to_waterline[i]);
  }
  check_ends(contour.points, number);
  check_crossings(contour.points, number);
  if (!(signed_area(contour.points) > 0.0)) {
    refuse("a contour that runs downwards or encloses no area");
  }
  return contour;
}

SectionContour section_contour(const ImmersedSection& section) {
  std::vector<Offset> points(section.contour.begin(), section.contour.end());
  if (points.size() < 2) {
    refuse("a contour of fewer than three points");
  }
  if (points.front().y <= kOnTheAxis * size_of(points)) {
    points.front().y = 0.0;
  } else {
    points.insert(points.begin(), Offset{0.0, points.front().z});
  }
  if (points.size() == 2) {
    const Offset middle{0.5 * points[1].y, 0.5 * (points[0].z + points[1].z)};
    points.insert(points.begin() + 1, middle);
  }
  return section_contour(points);
}

double area(const SectionContour& contour) {
  return signed_area(contour.points);
}

}  // namespace quickstrip
