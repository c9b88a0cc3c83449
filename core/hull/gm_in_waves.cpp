#include "core/hull/gm_in_waves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/hull/hydrostatics.hpp"

namespace quickstrip {
namespace {

constexpr double kClosed = 1e-3;        // of the greatest half-breadth: the contour ends at the centre plane
constexpr double kSettled = 1e-9;       // of volume, and of volume times L
constexpr std::size_t kMostSteps = 40;  // of Newton's method; four are common
constexpr double kLongestStep = 0.05;   // of L, at either end: keeps the first steps on the hull

/// One section below a waterline.
struct Cut {
  double half_breadth = 0.0;
  double area = 0.0;    // both sides
  double moment = 0.0;  // of the area about the base line
  bool is_covered = true;
};

/// The slice between two heights, straight sides.
void add_slice(double y0, double z0, double y1, double z1, Cut& cut) {
  const double dz = z1 - z0;
  cut.area += dz * (y0 + y1);
  cut.moment += dz / 3.0 * (z0 * (2.0 * y0 + y1) + z1 * (y0 + 2.0 * y1));
}

/// From the last offset up to the waterline.
void add_continuation(const Station& station, double waterline, double widest, Cut& cut) {
  const Offset top = station.offsets.back();
  double greatest = 0.0;
  for (const Offset& offset : station.offsets) {
    greatest = std::max(greatest, offset.y);
  }
  if (top.y <= kClosed * greatest) {
    cut.half_breadth = 0.0;
    return;
  }
  cut.is_covered = false;
  const Offset below = station.offsets[station.offsets.size() - 2];
  const double rise = top.z - below.z;
  const double slope = rise > 0.0 ? std::max(0.0, (top.y - below.y) / rise) : 0.0;
  const double height = waterline - top.z;
  const double until = slope > 0.0 ? std::min(height, std::max(0.0, widest - top.y) / slope) : 0.0;
  const double y = top.y + slope * until;
  add_slice(top.y, top.z, y, top.z + until, cut);
  add_slice(y, top.z + until, y, waterline, cut);
  cut.half_breadth = y;
}

Cut cut_at(const Station& station, double waterline, double widest) {
  Cut cut;
  const auto& offsets = station.offsets;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    const Offset& a = offsets[i - 1];
    const Offset& b = offsets[i];
    if (!(waterline > a.z)) {
      return cut;
    }
    if (b.z >= waterline) {
      const double y = b.z > a.z ? a.y + (b.y - a.y) * (waterline - a.z) / (b.z - a.z) : a.y;
      add_slice(a.y, a.z, y, waterline, cut);
      cut.half_breadth = y;
      return cut;
    }
    add_slice(a.y, a.z, b.y, b.z, cut);
  }
  add_continuation(station, waterline, widest, cut);
  return cut;
}

/// Trapezoidal sums over the hull; x from amidships.
struct Sums {
  double volume = 0.0;
  double volume_x = 0.0;
  double waterplane = 0.0;
  double waterplane_x = 0.0;
  double waterplane_xx = 0.0;
  double stability = 0.0;  // of 2/3 y^3 and of z dA
  bool is_covered = true;
};

struct Floating {
  double height = 0.0;  // of the wave
  double crest = 0.0;
  double sinkage = 0.0;  // amidships
  double trim = 0.0;     // slope, + by the bow
};

double trapezoidal_weight(const Hull& hull, std::size_t i) {
  const std::size_t last = hull.stations.size() - 1;
  return 0.5 * (hull.stations[std::min(i + 1, last)].x - hull.stations[i > 0 ? i - 1 : 0].x);
}

Sums sums_at(const Hull& hull, const Loading& loading, double widest, const Floating& at) {
  Sums out;
  for (std::size_t i = 0; i < hull.stations.size(); ++i) {
    const Station& station = hull.stations[i];
    const double x = station.x - 0.5 * hull.lpp;
    const double wave = 0.5 * at.height * std::cos(kTwoPi * (station.x - at.crest) / hull.lpp);
    const double waterline = waterline_height(hull, loading, station.x) + at.sinkage + at.trim * x + wave;
    const Cut cut = cut_at(station, waterline, widest);
    const double weight = trapezoidal_weight(hull, i);
    const double breadth = 2.0 * cut.half_breadth;
    out.volume += weight * cut.area;
    out.volume_x += weight * cut.area * x;
    out.waterplane += weight * breadth;
    out.waterplane_x += weight * breadth * x;
    out.waterplane_xx += weight * breadth * x * x;
    out.stability += weight * (breadth * breadth * breadth / 12.0 + cut.moment);
    out.is_covered = out.is_covered && cut.is_covered;
  }
  return out;
}

double greatest_half_breadth(const Hull& hull) {
  double out = 0.0;
  for (const Station& station : hull.stations) {
    for (const Offset& offset : station.offsets) {
      out = std::max(out, offset.y);
    }
  }
  return out;
}

/// Sinkage and trim for the volume and centre of `still`.
bool balance(const Hull& hull, const Loading& loading, double widest, const Sums& still, Floating& at,
             Sums& sums) {
  for (std::size_t step = 0; step < kMostSteps; ++step) {
    sums = sums_at(hull, loading, widest, at);
    const double volume = still.volume - sums.volume;
    const double moment = still.volume_x - sums.volume_x;
    if (std::abs(volume) <= kSettled * still.volume &&
        std::abs(moment) <= kSettled * still.volume * hull.lpp) {
      return true;
    }
    const double determinant = sums.waterplane * sums.waterplane_xx - sums.waterplane_x * sums.waterplane_x;
    if (!(determinant > 0.0)) {
      return false;
    }
    double sinkage = (volume * sums.waterplane_xx - moment * sums.waterplane_x) / determinant;
    double trim = (moment * sums.waterplane - volume * sums.waterplane_x) / determinant;
    const double largest = std::abs(sinkage) + 0.5 * hull.lpp * std::abs(trim);
    const double shorter = std::min(1.0, kLongestStep * hull.lpp / largest);
    at.sinkage += shorter * sinkage;
    at.trim += shorter * trim;
  }
  return false;
}

bool has_offsets_only(const Hull& hull) {
  return hull.stations.size() >= 3 && std::all_of(hull.stations.begin(), hull.stations.end(),
                                                  [](const Station& s) { return s.offsets.size() >= 2; });
}

GmChange between(const GmChange& a, const GmChange& b, float t) {
  return {a.least + t * (b.least - a.least), a.greatest + t * (b.greatest - a.greatest),
          a.mean + t * (b.mean - a.mean)};
}

}  // namespace

bool gm_change_on_wave(const Hull& hull, const Loading& loading, double height, double crest, double& change,
                       bool& is_covered) {
  if (!has_offsets_only(hull)) {
    return false;
  }
  const double widest = greatest_half_breadth(hull);
  const Sums still = sums_at(hull, loading, widest, Floating{});
  Floating at{.height = height, .crest = crest};
  Sums sums;
  if (!(still.volume > 0.0) || !balance(hull, loading, widest, still, at, sums)) {
    return false;
  }
  change = (sums.stability - still.stability) / still.volume;
  is_covered = is_covered && sums.is_covered;
  return std::isfinite(change);
}

GmInWaves gm_in_waves(const Hull& hull, const Loading& loading) {
  GmInWaves out{.length = hull.lpp};
  bool is_covered = true;
  for (std::size_t n = 1; n < GmInWaves::kNumHeights; ++n) {
    const double height = static_cast<double>(n) * GmInWaves::kStep * hull.lpp;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    double sum = 0.0;
    for (std::size_t c = 0; c < GmInWaves::kNumCrests; ++c) {
      constexpr auto kNum = static_cast<double>(GmInWaves::kNumCrests);
      double change = 0.0;
      if (!gm_change_on_wave(hull, loading, height, hull.lpp * static_cast<double>(c) / kNum, change,
                             is_covered)) {
        return GmInWaves{};
      }
      least = std::min(least, change);
      greatest = std::max(greatest, change);
      sum += change / kNum;
    }
    out.by_height[n] = {static_cast<float>(least), static_cast<float>(greatest), static_cast<float>(sum)};
    out.covered_height = is_covered ? height : out.covered_height;
  }
  out.is_known = true;
  return out;
}

GmChange gm_change(const GmInWaves& table, double height) {
  constexpr std::size_t kLast = GmInWaves::kNumHeights - 1;
  const double place = height / (GmInWaves::kStep * table.length);
  if (!(place < static_cast<double>(kLast))) {
    return table.by_height[kLast];
  }
  const auto n = static_cast<std::size_t>(place);
  return between(table.by_height[n], table.by_height[n + 1],
                 static_cast<float>(place - static_cast<double>(n)));
}

}  // namespace quickstrip
