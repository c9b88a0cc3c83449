#include "core/hull/hydrostatics.hpp"

#include <algorithm>
#include <cmath>

namespace quickstrip {
namespace {

// Trapezoidal sums over the immersed sections; x from the aft perpendicular, z above base.
struct Sums {
  double volume = 0.0;
  double volume_x = 0.0;
  double volume_z = 0.0;
  double waterplane = 0.0;
  double waterplane_x = 0.0;
  double inertia_long = 0.0;   // of the waterplane about x = 0
  double inertia_trans = 0.0;  // about the centre plane
  double greatest_breadth = 0.0;
  double cm = 0.0;
};

Sums sums_of(const ImmersedSections& sections) {
  Sums sums;
  double greatest_area = 0.0;
  for (const ImmersedSection& s : sections) {
    sums.volume += s.weight * s.area;
    sums.volume_x += s.weight * s.area * s.x;
    sums.volume_z += s.weight * s.area * (s.waterline_z + s.centroid_z);
    sums.waterplane += s.weight * s.breadth;
    sums.waterplane_x += s.weight * s.breadth * s.x;
    sums.inertia_long += s.weight * s.breadth * s.x * s.x;
    sums.inertia_trans += s.weight * s.breadth * s.breadth * s.breadth / 12.0;
    sums.greatest_breadth = std::max(sums.greatest_breadth, s.breadth);
    if (s.area > greatest_area) {
      greatest_area = s.area;
      sums.cm = s.area / (s.breadth * s.draught);  // finiteness is checked with the rest
    }
  }
  return sums;
}

bool all_finite(const Hydrostatics& h) {
  const double total = h.volume + h.displacement + h.lcb + h.kb + h.bm + h.kg + h.kg_fluid + h.gm + h.gml +
                       h.lcf + h.waterplane_area + h.draught_at_lcb + h.cb + h.cm + h.cwp;
  return std::isfinite(total);
}

}  // namespace

Result<Hydrostatics> hydrostatics(const Hull& hull, const Loading& loading,
                                  const ImmersedSections& sections) {
  if (!std::isfinite(loading.water_density) || !std::isfinite(loading.kg)) {
    return Error::kNotFinite;
  }
  if (!(hull.lpp > 0.0) || !(loading.water_density > 0.0)) {
    return Error::kOutOfRange;
  }
  const Sums sums = sums_of(sections);
  if (!std::isfinite(sums.volume) || !std::isfinite(sums.waterplane)) {
    return Error::kNotFinite;
  }
  if (!(sums.volume > 0.0) || !(sums.waterplane > 0.0)) {
    return Error::kNoImmersedVolume;
  }
  Hydrostatics h;
  h.volume = sums.volume;
  h.displacement = loading.water_density * sums.volume;
  h.lcb = sums.volume_x / sums.volume;
  h.kb = sums.volume_z / sums.volume;
  h.bm = sums.inertia_trans / sums.volume;
  h.lcf = sums.waterplane_x / sums.waterplane;
  h.waterplane_area = sums.waterplane;
  h.draught_at_lcb = waterline_height(hull, loading, h.lcb);

  h.kg = loading.kg;
  h.kg_fluid =
      loading.gm ? h.kb + h.bm - *loading.gm : loading.kg + loading.free_surface_correction.value_or(0.0);
  h.gm = h.kb + h.bm - h.kg_fluid;
  // About x = lcb, where G lies: c55 = rho g (int B (x - x_G)^2 dx - V (z_G - z_B)) [STF eq 17]; solid KG.
  const double inertia_about_lcb =
      sums.inertia_long - 2.0 * h.lcb * sums.waterplane_x + h.lcb * h.lcb * sums.waterplane;
  h.gml = h.kb + inertia_about_lcb / sums.volume - h.kg;

  const double mean_draught = 0.5 * (loading.draught_aft + loading.draught_fwd);
  h.cb = sums.volume / (hull.lpp * sums.greatest_breadth * mean_draught);
  h.cm = sums.cm;
  h.cwp = sums.waterplane / (hull.lpp * sums.greatest_breadth);
  if (!all_finite(h)) {
    return Error::kNotFinite;
  }
  if (!(h.gm > 0.0)) {
    return Error::kUnstable;
  }
  return h;
}

}  // namespace quickstrip
