// Sections cut at the waterline: the immersed part of core/hull/hydrostatics.hpp.
#include <algorithm>
#include <cmath>

#include "core/hull/hydrostatics.hpp"
#include "core/hull/minimal_section.hpp"

namespace quickstrip {
namespace {

// Shares of lpp; all of them far below what can be measured on a ship.
constexpr double kRoundOff = 1e-12;     // an offset this near to the waterline lies on it
constexpr double kLeastDraught = 1e-5;  // shallower (1.75 mm of 175 m): out of the water
constexpr double kLeastArea = 1e-9;     // of lpp^2 (0.3 dm2 of 175 m): out of the water
constexpr double kDraughtMatch = 1e-3;  // of the mean draught: stations of minimal form
constexpr double kClosed = 1e-3;        // of the section's half-breadth: a contour that ends here is closed
constexpr std::size_t kLeastStations = 3;  // for a parabola in x (Lagrange, derivatives)

Status check_offsets(const Station& station) {
  for (std::size_t i = 0; i < station.offsets.size(); ++i) {
    const Offset& offset = station.offsets[i];
    if (!std::isfinite(offset.y) || !std::isfinite(offset.z)) {
      return Error::kNotFinite;
    }
    if (offset.y < 0.0) {
      return Error::kOutOfRange;
    }
    if (i > 0 && offset.z < station.offsets[i - 1].z) {
      return Error::kContourNotOrdered;
    }
  }
  return station.offsets.size() >= 2 ? Status{} : Status{Error::kOutOfRange};
}

Status check_minimal(const Station& station) {
  if (!std::isfinite(station.breadth) || !std::isfinite(station.draught) || !std::isfinite(station.area)) {
    return Error::kNotFinite;
  }
  // No breadth at the waterline: a wholly submerged bulb.
  const bool physical = station.breadth >= 0.0 && station.draught > 0.0 && station.area > 0.0;
  return physical ? Status{} : Status{Error::kOutOfRange};
}

Status check_stations(const Hull& hull) {
  for (std::size_t i = 0; i < hull.stations.size(); ++i) {
    const Station& station = hull.stations[i];
    if (!std::isfinite(station.x)) {
      return Error::kNotFinite;
    }
    if (i > 0 && !(station.x > hull.stations[i - 1].x)) {
      return Error::kStationsNotOrdered;
    }
    const Status status = station.is_minimal() ? check_minimal(station) : check_offsets(station);
    if (!status) {
      return status;
    }
  }
  return {};
}

// Stations of minimal form hold at one draught: that of the hull file's own loading condition.
Status check_minimal_draught(const Hull& hull, const Loading& loading) {
  const Loading& design = hull.loading;
  const double tolerance = kDraughtMatch * 0.5 * std::abs(design.draught_aft + design.draught_fwd);
  bool any_minimal = false;
  bool any_offsets = false;
  bool reaches_base = false;
  for (const Station& station : hull.stations) {
    any_minimal = any_minimal || station.is_minimal();
    any_offsets = any_offsets || !station.is_minimal();
    const double local = waterline_height(hull, design, station.x);
    reaches_base = reaches_base || std::abs(station.draught - local) <= tolerance;
  }
  if (!any_minimal) {
    return {};
  }
  const bool same_draughts = std::abs(loading.draught_aft - design.draught_aft) <= tolerance &&
                             std::abs(loading.draught_fwd - design.draught_fwd) <= tolerance;
  return same_draughts && (any_offsets || reaches_base) ? Status{} : Status{Error::kDraughtNotSupported};
}

// Parts without breadth below or above the section (a sheet of no thickness) are no section.
void strip_sheets(StaticVector<Offset, kMaxOffsets + 2>& contour) {
  std::size_t first = 0;
  while (first + 1 < contour.size() && contour[first].y == 0.0 && contour[first + 1].y == 0.0) {
    ++first;
  }
  std::size_t last = contour.size() - 1;
  while (last > first && contour[last].y == 0.0 && contour[last - 1].y == 0.0) {
    --last;
  }
  std::copy(contour.begin() + first, contour.begin() + last + 1, contour.begin());
  QS_CHECK(contour.resize(last + 1 - first));
}

// The contour up to the waterline; empty when the section is out of the water.
Status cut_contour(const Station& station, double waterline, double round_off, ImmersedSection& section) {
  auto& contour = section.contour;
  contour.clear();
  if (station.offsets.front().z - waterline >= -round_off) {
    return {};
  }
  double greatest = 0.0;
  bool reached = false;
  for (const Offset& offset : station.offsets) {
    const double z = offset.z - waterline;
    if (z < -round_off) {
      QS_CHECK(contour.push_back({offset.y, z}));
      greatest = std::max(greatest, offset.y);
      continue;
    }
    const Offset below = contour.back();
    const double y = z > round_off ? below.y + (offset.y - below.y) * (-below.z) / (z - below.z) : offset.y;
    QS_CHECK(contour.push_back({y, 0.0}));
    reached = true;
    break;
  }
  if (!reached) {
    const Offset top = contour.back();
    if (top.y > kClosed * greatest) {
      return Error::kDraughtAboveDeck;
    }
    if (top.y > 0.0) {
      QS_CHECK(contour.push_back({0.0, top.z}));
    }
  }
  strip_sheets(contour);
  return {};
}

// Area, first moment in z of the polygon: exact for straight sides; horizontal sides add nothing.
void measure_contour(ImmersedSection& section) {
  double half_area = 0.0;
  double half_moment = 0.0;
  for (std::size_t i = 1; i < section.contour.size(); ++i) {
    const Offset& p = section.contour[i - 1];
    const Offset& q = section.contour[i];
    const double dz = q.z - p.z;
    half_area += 0.5 * dz * (p.y + q.y);
    half_moment += dz / 6.0 * (p.z * (2.0 * p.y + q.y) + q.z * (p.y + 2.0 * q.y));
  }
  section.area = 2.0 * half_area;
  section.centroid_z = half_area > 0.0 ? half_moment / half_area : 0.0;
  section.draught = -section.contour.front().z;
  section.breadth = section.contour.back().z < 0.0 ? 0.0 : 2.0 * section.contour.back().y;
}

void measure_minimal(const Station& station, ImmersedSection& section) {
  minimal_contour(station.breadth, station.draught, station.area, section.contour);
  measure_contour(section);
  section.breadth = station.breadth;  // as given, not as rounded
  section.draught = station.draught;
  section.area = station.area;
}

// Trapezoidal weight of station i among all stations, immersed or not.
double trapezoidal_weight(const Hull& hull, std::size_t i) {
  const std::size_t last = hull.stations.size() - 1;
  const double aft = hull.stations[i > 0 ? i - 1 : 0].x;
  const double fwd = hull.stations[i < last ? i + 1 : last].x;
  return 0.5 * (fwd - aft);
}

bool is_immersed(const Hull& hull, const ImmersedSection& section) {
  return section.draught > kLeastDraught * hull.lpp && section.area > kLeastArea * hull.lpp * hull.lpp;
}

}  // namespace

double waterline_height(const Hull& hull, const Loading& loading, double x) {
  return loading.draught_aft + (loading.draught_fwd - loading.draught_aft) * (x / hull.lpp);
}

Status immerse(const Hull& hull, const Loading& loading, ImmersedSections& out) {
  out.clear();
  if (!std::isfinite(hull.lpp) || !std::isfinite(loading.draught_aft) ||
      !std::isfinite(loading.draught_fwd)) {
    return Error::kNotFinite;
  }
  if (!(hull.lpp > 0.0)) {
    return Error::kOutOfRange;
  }
  Status status = check_stations(hull);
  if (status) {
    status = check_minimal_draught(hull, loading);
  }
  for (std::size_t i = 0; status && i < hull.stations.size(); ++i) {
    const Station& station = hull.stations[i];
    QS_CHECK(out.resize(out.size() + 1));
    ImmersedSection& section = out.back();
    section.x = station.x;
    section.waterline_z = waterline_height(hull, loading, station.x);
    section.weight = trapezoidal_weight(hull, i);
    if (station.is_minimal()) {
      measure_minimal(station, section);
    } else {
      status = cut_contour(station, section.waterline_z, kRoundOff * hull.lpp, section);
      if (status && !section.contour.empty()) {
        measure_contour(section);
      }
    }
    if (!is_immersed(hull, section)) {
      QS_CHECK(out.resize(out.size() - 1));
    }
  }
  if (status && out.size() < kLeastStations) {
    status = Error::kTooFewStations;
  }
  if (!status) {
    out.clear();
  }
  return status;
}

}  // namespace quickstrip
