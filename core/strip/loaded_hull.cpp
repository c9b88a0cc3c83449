#include "core/strip/loaded_hull.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

#include "core/strip/ikeda_damping.hpp"
#include "core/strip/section_table.hpp"
#include "core/strip/surge.hpp"

namespace quickstrip {
namespace {

// Encounter frequency nodes in units of sqrt(g/L): below lies no wave that moves a ship relative to it, above
// lie encounter frequencies of Fn 0.4 in head seas of wave length L/20.
constexpr double kLowestNode = 0.05;
constexpr double kHighestNode = 50.0;

constexpr double kGauss = 0.57735026918962576;  // 1/sqrt(3): two-point Gauss rule

// On every panel of the offsets: exact for the cubic that a linear half-breadth and the first terms of
// exp(kz) make.
void set_quadrature(const ImmersedSection& section, OffsetQuadrature& q) {
  q.count = 0;
  for (std::size_t i = 0; i + 1 < section.contour.size(); ++i) {
    const Offset& a = section.contour[i];
    const Offset& b = section.contour[i + 1];
    const double dz = b.z - a.z;
    if (!(dz > 0.0)) {
      continue;  // flat bottom
    }
    for (const double side : {-kGauss, kGauss}) {
      const double t = 0.5 * (1.0 + side);
      q.add(a.z + t * dz, a.y + t * (b.y - a.y), 0.5 * dz);
    }
  }
}

template <std::size_t N>
void set_quadrature(const LewisSection& form, ContourQuadrature<N>& q) {
  constexpr double kPanel = 0.5 * kPi / static_cast<double>(kLewisPanels);
  q.count = 0;
  for (std::size_t i = 0; i < kLewisPanels; ++i) {
    for (const double side : {-kGauss, kGauss}) {
      const double theta = (static_cast<double>(i) + 0.5 * (1.0 + side)) * kPanel;
      const ContourPoint point = contour_point(form, theta);
      const double dz_dtheta =
          form.scale * ((1.0 - form.a1) * std::sin(theta) + 3.0 * form.a3 * std::sin(3.0 * theta));
      q.add(point.z, point.y, 0.5 * kPanel * dz_dtheta);
    }
  }
}

// Of one section about O, SI.
struct AboutO {
  double a22 = 0.0;
  double b22 = 0.0;
  double a24 = 0.0;
  double b24 = 0.0;
  double a33 = 0.0;
  double b33 = 0.0;
  double a44 = 0.0;
  double b44 = 0.0;
};

AboutO lewis_hydrodynamics(const LoadedHull& hull, std::size_t i, const SectionTableColumn& column,
                           double omega) {
  const LewisSection& form = hull.lewis[i];
  const double xi = omega * omega * form.breadth / (2.0 * hull.gravity);
  const SectionCoefficients c = section_coefficients(column, xi);
  const double per_second = std::sqrt(2.0 * hull.gravity / form.breadth);
  const double rho_a = hull.density * form.area;
  const double rho_ab = rho_a * form.breadth;
  const double rho_ab2 = rho_ab * form.breadth;
  return {.a22 = rho_a * c.a22,
          .b22 = rho_a * c.b22 * per_second,
          .a24 = rho_ab * c.a24,
          .b24 = rho_ab * c.b24 * per_second,
          .a33 = rho_a * c.a33,
          .b33 = rho_a * c.b33 * per_second,
          .a44 = rho_ab2 * c.a44,
          .b44 = rho_ab2 * c.b44 * per_second};
}

AboutO compiled_hydrodynamics(const LoadedHull& hull, std::size_t i, double omega) {
  const OscillationValues v = hull.table->oscillation(hull.level[i], omega * omega / hull.gravity);
  const double rho = hull.density;
  const double rho_omega = rho * omega;
  return {.a22 = rho * v[kTableA22],
          .b22 = rho_omega * v[kTableH2] * v[kTableH2],
          .a24 = rho * v[kTableA24],
          .b24 = rho_omega * v[kTableH2] * v[kTableH4],
          .a33 = rho * v[kTableA33],
          .b33 = rho_omega * v[kTableH3] * v[kTableH3],
          .a44 = rho * v[kTableA44],
          .b44 = rho_omega * v[kTableH4] * v[kTableH4]};
}

// One section in the table that its coefficients come from.
class TabulatedSection {
 public:
  TabulatedSection(const LoadedHull& hull, std::size_t i) : hull_(hull), i_(i) {
    if (hull.table == nullptr) {
      const Result<SectionTableColumn> column = section_table_column(hull.lewis[i].h0, hull.lewis[i].sigma);
      QS_CHECK(column.ok());  // set_sections() has seen to it
      column_ = *column;
    }
  }

  [[nodiscard]] AboutO at(double omega) const {
    return hull_.table != nullptr ? compiled_hydrodynamics(hull_, i_, omega)
                                  : lewis_hydrodynamics(hull_, i_, column_, omega);
  }

 private:
  const LoadedHull& hull_;
  std::size_t i_;
  SectionTableColumn column_;
};

// Moved to G: a24_G = a24 + OG a22 (NOTATION.md: OG up +).
template <typename Hydrodynamics>
void table_hydrodynamics(const LoadedHull& hull, std::size_t i, const TabulatedSection& section, double omega,
                         Hydrodynamics& out) {
  const AboutO c = section.at(omega);
  const double og = hull.g_height;
  out[kA22][i] = c.a22;
  out[kB22][i] = c.b22;
  out[kA24][i] = c.a24 + og * c.a22;
  out[kB24][i] = c.b24 + og * c.b22;
  out[kA33][i] = c.a33;
  out[kB33][i] = c.b33;
  out[kA44][i] = c.a44 + 2.0 * og * c.a24 + og * og * c.a22;
  out[kB44][i] = c.b44 + 2.0 * og * c.b24 + og * og * c.b22;
}

void interpolate(const LoadedHull& hull, const NodeStencil& s, StripQuantity q, SectionValues& out) {
  const HeldSectionValues& v0 = hull.node[s.first][q];
  const HeldSectionValues& v1 = hull.node[s.first + 1][q];
  const HeldSectionValues& v2 = hull.node[s.first + 2][q];
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out[i] = s.weight[0] * v0[i] + s.weight[1] * v1[i] + s.weight[2] * v2[i];
  }
}

// Nothing to read where doubles are held.
template <typename Kept>
const SectionHydrodynamics& read(const Kept& kept, std::size_t num_sections, SectionHydrodynamics& room) {
  if constexpr (std::is_same_v<Kept, SectionHydrodynamics>) {
    return kept;
  } else {
    for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
      std::copy_n(kept[q].begin(), num_sections, room[q].begin());
    }
    return room;
  }
}

Status set_sections(LoadedHull& hull) {
  const ImmersedSections& sections = hull.immersed;
  hull.num_sections = sections.size();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const ImmersedSection& s = sections[i];
    hull.x[i] = s.x - hull.hydrostatics.lcb;
    hull.half_breadth[i] = 0.5 * s.breadth;
    hull.area[i] = s.area;
    hull.centroid_below_g[i] = hull.g_height - s.centroid_z;
    hull.weight[i] = s.weight;
    const Result<LewisSection> form = hydrodynamic_lewis_section(s.breadth, s.draught, s.area);
    if (!form) {
      return form.error();
    }
    set_quadrature(*form, hull.lewis_contour[i]);
    // A bulb's own Lewis form is good for pressures where only its coefficients are not (formulas §2); a
    // re-entrant one crosses itself.
    const Result<LewisSection> own = lewis_section(s.breadth, s.draught, s.area);
    const bool own_form_is_simple = own.ok() && own->lewis_class != LewisClass::kReentrant;
    if (!s.contour.empty() && (hull.method.contour == WaveContour::kOffsets || !own.ok())) {
      set_quadrature(s, hull.wave_contour[i]);
    } else {
      set_quadrature(own_form_is_simple ? *own : *form, hull.wave_contour[i]);
    }
    hull.lewis[i] = *form;
    hull.has_replaced_section = hull.has_replaced_section || form->replaced;
    if (const Result<TablePosition> position = table_position(form->h0, form->sigma); !position) {
      return position.error();
    }
  }
  // What a weight holds beyond the neighbours' half panels is the panel to a station out of the water.
  const std::size_t last = hull.num_sections - 1;
  hull.taper_aft = std::max(0.0, 2.0 * hull.weight[0] - (hull.x[1] - hull.x[0]));
  hull.taper_fore = std::max(0.0, 2.0 * hull.weight[last] - (hull.x[last] - hull.x[last - 1]));
  return {};
}

// Where a table holds this hull at these draughts: each section's place in it.
Status bind_table(const Hull& hull, const Loading& loading, const HullTable* table, LoadedHull& out) {
  out.table = nullptr;
  out.is_outside_table = false;
  if (table == nullptr) {
    return out.method.loads == DiffractionLoads::kBoundaryValue ? Status{Error::kHullTableNeeded} : Status{};
  }
  if (const Status same = table->check_hull(hull); !same) {
    return same;
  }
  if (!table->covers(hull, loading)) {
    out.is_outside_table = true;
    if (out.method.loads == DiffractionLoads::kBoundaryValue) {
      out.method.loads = DiffractionLoads::kHaskind;
    }
    return {};
  }
  std::size_t station = 0;  // sections are stations, those out of the water left out
  for (std::size_t i = 0; i < out.num_sections; ++i) {
    // bounded: each section is one of the stations, in their order
    while (hull.stations[station].x < out.immersed[i].x) {
      ++station;
    }
    out.level[i] = table->level_stencil(station, out.immersed[i].waterline_z);
  }
  out.table = table;
  if (table->sections() != HullSections::kLewis) {
    out.has_replaced_section = false;
  }
  return {};
}

// Roll moment of Froude-Krilov loads: the contours give the stiffness of the solid G. In a long wave the
// liquid in tanks (and whatever else a given GM stands for) sees the same tilted gravity as the ship, so the
// difference acts as a lever of the sway force; then roll tends to the wave slope (formulas §6, "roll moment
// and contour").
double roll_lever_shift(const LoadedHull& hull) {
  double contour_moment = 0.0;  // integral of 2/3 y_w^3 + 2 z y dz, about O [m4]
  double contour_volume = 0.0;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const ContourView q = hull.wave_contour[i].view();
    double first_moment = 0.0;
    double area = 0.0;
    for (std::size_t n = 0; n < q.z.size(); ++n) {
      first_moment += 2.0 * q.weight[n] * q.z[n] * q.y[n];
      area += 2.0 * q.weight[n] * q.y[n];
    }
    const double y = hull.half_breadth[i];
    contour_moment += hull.weight[i] * (2.0 / 3.0 * y * y * y + first_moment);
    contour_volume += hull.weight[i] * area;
  }
  const double contour_gm = contour_moment / contour_volume - hull.g_height;
  return contour_gm - hull.hydrostatics.gm;
}

Status set_roll_damping(const RollDamping& given, double viscosity, LoadedHull& hull) {
  if (given.method == RollDampingMethod::kRatio) {
    set_roll_damping_ratio(hull, given.ratio);
    return std::isfinite(reference_roll_damping(hull.roll_damping, 0.0)) ? Status{}
                                                                         : Status{Error::kNotFinite};
  }
  const Result<RollDampingModel> model = ikeda_roll_damping(hull, given.bilge_keel, viscosity);
  if (!model) {
    return model.error();
  }
  hull.roll_damping = *model;
  return {};
}

}  // namespace

Status load(const Hull& hull, const Loading& loading, const StripMethod& method, LoadedHull& out,
            const HullTable* table) {
  if (!section_table_is_intact()) {
    return Error::kTableCorrupt;
  }
  ImmersedSections& sections = out.immersed;
  if (const Status cut = immerse(hull, loading, sections); !cut) {
    return cut;
  }
  const Result<Hydrostatics> floating = hydrostatics(hull, loading, sections);
  if (!floating) {
    return floating.error();
  }
  if (!(loading.roll_gyradius > 0.0 && loading.pitch_gyradius > 0.0 && loading.yaw_gyradius > 0.0)) {
    return Error::kOutOfRange;
  }
  out.method = method;
  out.gravity = loading.gravity;
  out.density = loading.water_density;
  out.lpp = hull.lpp;
  out.breadth = hull.breadth;
  out.hydrostatics = *floating;
  out.has_replaced_section = false;
  out.g_height = floating->kg - floating->draught_at_lcb;
  if (const Status placed = set_sections(out); !placed) {
    return placed;
  }
  if (const Status bound = bind_table(hull, loading, table, out); !bound) {
    return bound;
  }

  const double mass = floating->displacement;
  out.body = {mass, mass * loading.roll_gyradius * loading.roll_gyradius,
              mass * loading.pitch_gyradius * loading.pitch_gyradius,
              mass * loading.yaw_gyradius * loading.yaw_gyradius};
  const double rho_g = out.density * out.gravity;
  out.restoring.c33 = 2.0 * rho_g * integral(out, out.half_breadth, 0);
  out.restoring.c35 = -2.0 * rho_g * integral(out, out.half_breadth, 1);
  out.restoring.c44 = mass * out.gravity * floating->gm;
  out.restoring.c55 = mass * out.gravity * floating->gml;
  out.roll_lever_shift = roll_lever_shift(out);
  const bool has_surge = method.surge == SurgeTerms::kFull;
  out.surge_added_mass_factor = has_surge ? spheroid_surge_added_mass_factor(out.lpp, out.breadth) : 0.0;
  out.surge_damping_per_speed =
      has_surge ? surge_damping_per_speed(out.lpp, floating->volume, out.density) : 0.0;

  const double froude_frequency = std::sqrt(out.gravity / out.lpp);
  const double span = std::log(kHighestNode / kLowestNode);
  for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
    const double t = static_cast<double>(n) / static_cast<double>(kNumEncounterNodes - 1);
    out.log_omega[n] = std::log(kLowestNode * froude_frequency) + t * span;
  }
  for (std::size_t i = 0; i < out.num_sections; ++i) {
    const TabulatedSection section(out, i);
    for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
      table_hydrodynamics(out, i, section, std::exp(out.log_omega[n]), out.node[n]);
    }
  }
  for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
    SectionHydrodynamics held;
    length_integrals(out, node_hydrodynamics(out, n, held), out.node_integrals[n]);
  }
  out.roll_natural_frequency = roll_natural_frequency(out);
  out.stabiliser = hull.roll_damping.stabiliser;
  return set_roll_damping(hull.roll_damping, loading.viscosity, out);
}

void set_roll_damping_ratio(LoadedHull& hull, double ratio) {
  hull.roll_damping = constant_roll_damping(ratio_roll_damping(hull, ratio), hull.roll_natural_frequency);
}

void section_hydrodynamics(const LoadedHull& hull, double omega_e, SectionHydrodynamics& out) {
  const double omega = std::fabs(omega_e);
  const NodeStencil s = node_stencil(hull, omega);
  if (!s.is_inside) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      table_hydrodynamics(hull, i, TabulatedSection(hull, i), omega, out);
    }
    return;
  }
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    interpolate(hull, s, static_cast<StripQuantity>(q), out[q]);
  }
}

const SectionHydrodynamics& node_hydrodynamics(const LoadedHull& hull, std::size_t n,
                                               SectionHydrodynamics& room) {
  return read(hull.node[n], hull.num_sections, room);
}

void section_heave(const LoadedHull& hull, double omega_e, SectionValues& a33, SectionValues& b33) {
  const NodeStencil s = node_stencil(hull, omega_e);
  if (!s.is_inside) {
    SectionHydrodynamics all;
    section_hydrodynamics(hull, omega_e, all);
    a33 = all[kA33];
    b33 = all[kB33];
    return;
  }
  interpolate(hull, s, kA33, a33);
  interpolate(hull, s, kB33, b33);
}

}  // namespace quickstrip
