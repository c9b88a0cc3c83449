// Geometry of the polar picture. The plane is in knots: north up, a speed V on heading psi lies at
// (V sin psi, V cos psi). Shapes come as gnuplot data: one "x y" a line, a blank line after each polygon.
#pragma once

#include <string>
#include <vector>

#include "quickstrip/grid_t.hpp"

namespace quickstrip {

struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Compass bearing in degrees, distance in knots.
PlanePoint at_bearing(double bearing_deg, double radius);

/// The speed at the outer and at the inner edge of the ring of cells s [kn].
double ring_outside(const grid_t& grid, int speed);
double ring_inside(const grid_t& grid, int speed);
/// Heading of column h and width of a column [degrees].
double column_heading_deg(const grid_t& grid, int heading);
double column_width_deg(const grid_t& grid);

PlanePoint cell_centre(const grid_t& grid, int speed, int heading);
double cell_area(const grid_t& grid, int speed);

/// Gnuplot data that gathers polygons and lines.
class PlotData {
 public:
  void polygon(const std::vector<PlanePoint>& points);  // closed
  void line(const std::vector<PlanePoint>& points);
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The annular sector of a cell, grown by a hair so that no seam shows between neighbours.
std::vector<PlanePoint> cell_sector(const grid_t& grid, int speed, int heading);
/// An arc at `radius` over `from_deg` ... `to_deg`, clockwise.
std::vector<PlanePoint> arc(double radius, double from_deg, double to_deg);
/// A ship's outline seen from above, centred at `at`, its bow towards `heading_deg`, of the given length.
std::vector<PlanePoint> ship_outline(PlanePoint at, double heading_deg, double length);
/// A block arrow along the bearing from `from_radius` inward to `to_radius`, its shaft `width` wide.
std::vector<PlanePoint> inward_arrow(double bearing_deg, double from_radius, double to_radius, double width);

}  // namespace quickstrip
