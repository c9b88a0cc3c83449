#include "sim/picture/polar_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/base/angles.hpp"

namespace quickstrip {
namespace {

void append(std::string& text, PlanePoint p) {
  fmt::format_to(std::back_inserter(text), "{:.4f} {:.4f}\n", p.x, p.y);
}

double speed_of(const grid_t& grid, int speed) {
  return static_cast<double>(grid.speed_kn[speed]);
}

}  // namespace

PlanePoint at_bearing(double bearing_deg, double radius) {
  return {radius * std::sin(radians(bearing_deg)), radius * std::cos(radians(bearing_deg))};
}

double ring_outside(const grid_t& grid, int speed) {
  if (speed + 1 < grid.num_speeds) {
    return 0.5 * (speed_of(grid, speed) + speed_of(grid, speed + 1));
  }
  return speed > 0 ? 1.5 * speed_of(grid, speed) - 0.5 * speed_of(grid, speed - 1)
                   : speed_of(grid, speed) + 0.5;
}

double ring_inside(const grid_t& grid, int speed) {
  if (speed > 0) {
    return 0.5 * (speed_of(grid, speed) + speed_of(grid, speed - 1));
  }
  const double half_step = ring_outside(grid, 0) - speed_of(grid, 0);
  return std::max(0.0, speed_of(grid, 0) - half_step);
}

double column_width_deg(const grid_t& grid) {
  return 360.0 / std::max<double>(1.0, grid.num_headings);
}

double column_heading_deg(const grid_t& grid, int heading) {
  return column_width_deg(grid) * heading;
}

PlanePoint cell_centre(const grid_t& grid, int speed, int heading) {
  return at_bearing(column_heading_deg(grid, heading),
                    0.5 * (ring_inside(grid, speed) + ring_outside(grid, speed)));
}

double cell_area(const grid_t& grid, int speed) {
  const double outside = ring_outside(grid, speed);
  const double inside = ring_inside(grid, speed);
  return 0.5 * radians(column_width_deg(grid)) * (outside * outside - inside * inside);
}

std::vector<PlanePoint> arc(double radius, double from_deg, double to_deg) {
  const int num = std::max(2, static_cast<int>(std::ceil((to_deg - from_deg) / 1.25)) + 1);
  std::vector<PlanePoint> points;
  for (int i = 0; i < num; ++i) {
    points.push_back(at_bearing(from_deg + (to_deg - from_deg) * i / (num - 1), radius));
  }
  return points;
}

std::vector<PlanePoint> cell_sector(const grid_t& grid, int speed, int heading) {
  constexpr double kOverlapDeg = 0.12;  // hides the seam that antialiasing leaves between neighbours
  constexpr double kOverlapKn = 0.03;
  const double half = 0.5 * column_width_deg(grid) + kOverlapDeg;
  const double middle = column_heading_deg(grid, heading);
  std::vector<PlanePoint> points = arc(ring_outside(grid, speed) + kOverlapKn, middle - half, middle + half);
  const std::vector<PlanePoint> inner =
      arc(std::max(0.0, ring_inside(grid, speed) - kOverlapKn), middle - half, middle + half);
  points.insert(points.end(), inner.rbegin(), inner.rend());
  return points;
}

std::vector<PlanePoint> ship_outline(PlanePoint at, double heading_deg, double length) {
  // Along the bow and to starboard, in lengths: bow, shoulders, transom.
  constexpr std::array<PlanePoint, 7> kOutline{
      {{0.0, 0.55}, {0.17, 0.22}, {0.19, -0.1}, {0.15, -0.45}, {-0.15, -0.45}, {-0.19, -0.1}, {-0.17, 0.22}}};
  const double sine = std::sin(radians(heading_deg));
  const double cosine = std::cos(radians(heading_deg));
  std::vector<PlanePoint> points;
  for (const PlanePoint p : kOutline) {
    points.push_back(
        {at.x + length * (p.y * sine + p.x * cosine), at.y + length * (p.y * cosine - p.x * sine)});
  }
  return points;
}

std::vector<PlanePoint> inward_arrow(double bearing_deg, double from_radius, double to_radius, double width) {
  const double head = std::min(0.6 * (from_radius - to_radius), 1.1 * width + 0.9);
  const double neck = to_radius + head;
  const double half_head = 0.9 * width + 0.45;
  const PlanePoint across = at_bearing(bearing_deg + 90.0, 1.0);
  const auto at = [&](double radius, double aside) {
    const PlanePoint p = at_bearing(bearing_deg, radius);
    return PlanePoint{p.x + aside * across.x, p.y + aside * across.y};
  };
  return {
      at(from_radius, -0.5 * width), at(neck, -0.5 * width), at(neck, -half_head),        at(to_radius, 0.0),
      at(neck, half_head),           at(neck, 0.5 * width),  at(from_radius, 0.5 * width)};
}

void PlotData::polygon(const std::vector<PlanePoint>& points) {
  for (const PlanePoint p : points) {
    append(text_, p);
  }
  append(text_, points.front());
  text_ += '\n';
}

void PlotData::line(const std::vector<PlanePoint>& points) {
  for (const PlanePoint p : points) {
    append(text_, p);
  }
  text_ += '\n';
}

}  // namespace quickstrip
