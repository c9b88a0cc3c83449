#include "sim/hull_tool/station_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace quickstrip::hull_tool {
namespace {

constexpr double kFullPart = 1.0e-3;    // of the largest area
constexpr double kLargestSwing = 0.7;   // neighbours come no nearer than half their distance
constexpr int kMaxSteps = 30;           // of Newton's method; four or five do
constexpr double kDone = 1.0e-8;        // of CB and of lpp
constexpr double kDifference = 1.0e-4;  // of the swing, for the slopes

struct FullPart {
  double aft_end = 0.0;  // of the ship, x
  double aft = 0.0;
  double fore = 0.0;
  double fore_end = 0.0;
};

FullPart full_part(const Hull& hull, const ImmersedSections& sections) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    largest = sections[i].area > sections[largest].area ? i : largest;
  }
  const double full = (1.0 - kFullPart) * sections[largest].area;
  std::size_t aft = largest;
  while (aft > 0 && sections[aft - 1].area >= full) {
    --aft;
  }
  std::size_t fore = largest;
  while (fore + 1 < sections.size() && sections[fore + 1].area >= full) {
    ++fore;
  }
  return {std::max(0.0, hull.stations.front().x), sections[aft].x, sections[fore].x,
          std::min(hull.lpp, hull.stations.back().x)};
}

/// Where the section at x goes when the stretch from `full` to `end` swings by c.
double swung(double x, double full, double end, double c) {
  const double u = (x - full) / (end - full);
  if (!(u > 0.0 && u < 1.0)) {
    return x;
  }
  return x - (end - full) * u * (1.0 - u) * std::expm1(-c) / (u + (1.0 - u) * std::exp(-c));
}

// The stations of `hull` moved. A section of minimal form is known at its own draught only: where a trimmed
// ship floats it a little deeper or higher, a strip of its breadth is added.
void move_stations(const Hull& hull, const FullPart& part, std::array<double, 2> c, Hull& out) {
  for (std::size_t i = 0; i < hull.stations.size(); ++i) {
    const Station& from = hull.stations[i];
    Station& to = out.stations[i];
    to.x = swung(swung(from.x, part.aft, part.aft_end, c[0]), part.fore, part.fore_end, c[1]);
    if (from.is_minimal()) {
      const double deeper =
          waterline_height(hull, hull.loading, to.x) - waterline_height(hull, hull.loading, from.x);
      to.draught = from.draught + deeper;
      to.area = from.area + deeper * from.breadth;
    }
  }
}

class Swing {
 public:
  Swing(const Hull& hull, const ImmersedSections& sections, ShiftedHull& out)
      : hull_(hull), part_(full_part(hull, sections)), out_(out) {
    out_.hull = hull;
  }

  /// Misses of CB and of LCB / lpp at these swings.
  Result<std::array<double, 2>> misses(std::array<double, 2> c, double cb, double lcb) {
    move_stations(hull_, part_, c, out_.hull);
    if (const Status cut = immerse(out_.hull, out_.hull.loading, *sections_); !cut) {
      return cut.error();
    }
    const auto floated = hydrostatics(out_.hull, out_.hull.loading, *sections_);
    if (!floated) {
      return floated.error();
    }
    out_.hydrostatics = *floated;
    return std::array<double, 2>{floated->cb - cb, (floated->lcb - lcb) / hull_.lpp};
  }

 private:
  const Hull& hull_;
  FullPart part_;
  ShiftedHull& out_;
  std::unique_ptr<ImmersedSections> sections_ = std::make_unique<ImmersedSections>();
};

}  // namespace

Status shift_stations(const Hull& hull, const ImmersedSections& sections, const Hydrostatics& hydrostatics,
                      const FormChange& change, ShiftedHull& out) {
  Swing swing(hull, sections, out);
  const double cb = hydrostatics.cb + change.cb;
  const double lcb = hydrostatics.lcb + change.lcb;
  std::array<double, 2> c{};
  for (int step = 0; step < kMaxSteps; ++step) {
    const auto miss = swing.misses(c, cb, lcb);
    if (!miss) {
      return miss.error();
    }
    if (std::fabs((*miss)[0]) < kDone && std::fabs((*miss)[1]) < kDone) {
      out.swing_aft = c[0];
      out.swing_fore = c[1];
      return {};
    }
    const auto aft = swing.misses({c[0] + kDifference, c[1]}, cb, lcb);
    const auto fore = swing.misses({c[0], c[1] + kDifference}, cb, lcb);
    if (!aft || !fore) {
      return aft ? fore.error() : aft.error();
    }
    const double a = ((*aft)[0] - (*miss)[0]) / kDifference;
    const double b = ((*fore)[0] - (*miss)[0]) / kDifference;
    const double d = ((*aft)[1] - (*miss)[1]) / kDifference;
    const double e = ((*fore)[1] - (*miss)[1]) / kDifference;
    const double determinant = a * e - b * d;
    c[0] -= ((*miss)[0] * e - b * (*miss)[1]) / determinant;
    c[1] -= (a * (*miss)[1] - d * (*miss)[0]) / determinant;
    if (!(std::fabs(c[0]) <= kLargestSwing && std::fabs(c[1]) <= kLargestSwing)) {
      return Error::kOutOfRange;
    }
  }
  return Error::kOutOfRange;
}

double possible_share(const Hull& hull, const ImmersedSections& sections, const Hydrostatics& hydrostatics,
                      const FormChange& change) {
  const auto tried = std::make_unique<ShiftedHull>();
  double possible = 0.0;
  double too_much = 1.0;
  for (int step = 0; step < 10; ++step) {  // to a thousandth
    const double share = 0.5 * (possible + too_much);
    const FormChange part{share * change.cb, share * change.lcb};
    (shift_stations(hull, sections, hydrostatics, part, *tried) ? possible : too_much) = share;
  }
  return possible;
}

}  // namespace quickstrip::hull_tool
