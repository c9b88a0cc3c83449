#include "sim/parent/panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

constexpr double kCornerTurn = 15.0 * kPi / 180.0;
// Panels of a part go as this power of its length: a short part next to a corner needs more than its share.
// Measured on rectangles and on the S-175.
constexpr double kShareExponent = 0.6;
// Fractions of the half breadth, none of them a node of the first modes of the water inside.
constexpr std::array<double, 6> kInterior = {0.0, 0.23, 0.43, 0.61, 0.79, 0.91};

std::vector<Complex> without_repeats(const SectionContour& contour) {
  std::vector<Complex> ends;
  double size = 0.0;
  for (const Offset& p : contour.points) {
    size = std::max(size, std::hypot(p.y, p.z));
  }
  for (const Offset& p : contour.points) {
    const Complex w(p.z, p.y);
    if (ends.empty() || std::abs(w - ends.back()) > 1e-9 * size) {
      ends.push_back(w);
    }
  }
  return ends;
}

double turn(Complex before, Complex here, Complex after) {
  return std::fabs(std::arg((after - here) / (here - before)));
}

// One part of the contour between corners.
struct Part {
  std::vector<Complex> points;
  std::vector<double> length;  // along it, up to each point
  bool is_corner_first = false;
  bool is_corner_last = false;
};

std::vector<Part> parts(const std::vector<Complex>& points) {
  std::vector<Part> out;
  // Mirrored in the centre plane the contour turns there by twice its inclination.
  const auto turns_at_centre = [](Complex on, Complex next) {
    return turn(std::conj(next), on, next) > kCornerTurn;
  };
  const std::size_t last = points.size() - 1;
  Part part;
  part.is_corner_first = points[0].imag() > 0.0 || turns_at_centre(points[0], points[1]);
  for (std::size_t i = 0; i <= last; ++i) {
    part.length.push_back(
        part.points.empty() ? 0.0 : part.length.back() + std::abs(points[i] - part.points.back()));
    part.points.push_back(points[i]);
    if (i == last) {
      part.is_corner_last = points[i].imag() > 0.0 || turns_at_centre(points[i], points[i - 1]);
    } else if (i > 0 && turn(points[i - 1], points[i], points[i + 1]) > kCornerTurn) {
      part.is_corner_last = true;
    } else {
      continue;
    }
    out.push_back(part);
    part = Part{{points[i]}, {0.0}, true, false};
  }
  return out;
}

double graded(const Part& part, double u) {
  if (part.is_corner_first && part.is_corner_last) {
    return 0.5 - 0.5 * std::cos(kPi * u);
  }
  if (part.is_corner_last) {
    return std::sin(0.5 * kPi * u);
  }
  return part.is_corner_first ? 1.0 - std::cos(0.5 * kPi * u) : u;
}

Complex at_length(const Part& part, double s) {
  const auto above = std::lower_bound(part.length.begin() + 1, part.length.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - part.length.begin());
  const double share = (s - part.length[i - 1]) / (part.length[i] - part.length[i - 1]);
  return part.points[i - 1] + share * (part.points[i] - part.points[i - 1]);
}

}  // namespace

std::vector<Complex> panel_ends(const SectionContour& contour, int num_panels) {
  const std::vector<Part> all = parts(without_repeats(contour));
  double total = 0.0;
  for (const Part& part : all) {
    total += std::pow(part.length.back(), kShareExponent);
  }
  std::vector<Complex> ends = {all.front().points.front()};
  for (const Part& part : all) {
    const double share = std::pow(part.length.back(), kShareExponent) / total;
    const int pairs = std::max(1, static_cast<int>(std::lround(0.5 * num_panels * share)));
    for (int k = 1; k < 2 * pairs; ++k) {
      ends.push_back(at_length(part, part.length.back() * graded(part, 0.5 * k / pairs)));
    }
    ends.push_back(part.points.back());
  }
  return ends;
}

std::vector<Complex> coarsened(const std::vector<Complex>& ends) {
  std::vector<Complex> out;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    out.push_back(ends[i]);
  }
  return out;
}

std::vector<Complex> interior_points(const SectionContour& contour) {
  std::vector<Complex> points;
  const Offset& top = contour.points.back();
  if (!contour.is_submerged() && top.y > 0.0) {
    for (const double share : kInterior) {
      points.emplace_back(0.0, share * top.y);
    }
  }
  return points;
}

}  // namespace quickstrip
