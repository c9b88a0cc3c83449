// The compact coefficient table of one hull at one loading, and everything that strip theory needs beside it:
// built once when the loading changes, without allocation, then only read.
//
// Sections: real contours (or Lewis contours for a hull of minimal form) give area, hydrostatics and
// Froude-Krilov loads; a and b are those of Lewis forms, or of the hull's own sections where a compiled table
// of them (hull_table.hpp) covers the loading. Two-dimensional coefficients are held about G at geometric
// nodes of encounter frequency, 0.05 ... 50 sqrt(g/L), and interpolated there by second-degree Lagrange
// polynomials in ln(omega) [Journee1992] §4; outside the nodes they come from either table directly.
// Memory: about 1 MB, static. Cost of `load`: 96 nodes x stations table look-ups, a few ms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/check.hpp"
#include "core/base/held.hpp"
#include "core/base/pair.hpp"
#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/strip/hull_table.hpp"
#include "core/strip/method.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip {

/// One value per section, aft to fore.
using SectionValues = std::array<double, kMaxStations>;
using HeldSectionValues = std::array<Held, kMaxStations>;

/// Two-dimensional coefficients per metre of length, about G, SI.
enum StripQuantity : std::size_t { kA22, kB22, kA24, kB24, kA33, kB33, kA44, kB44, kNumStripQuantities };
using SectionHydrodynamics = std::array<SectionValues, kNumStripQuantities>;
using HeldHydrodynamics = std::array<HeldSectionValues, kNumStripQuantities>;

/// Points and weights for integrals over z from keel to waterline: sum weight f(z, y); z from the waterline,
/// y >= 0.
struct ContourView {
  std::span<const Held> z;
  std::span<const Held> y;
  std::span<const Held> weight;
};

template <std::size_t N>
struct ContourQuadrature {
  std::size_t count = 0;
  std::array<Held, N> z{};
  std::array<Held, N> y{};
  std::array<Held, N> weight{};

  void add(double z_at, double y_at, double weight_at) {
    QS_CHECK(count < N);
    z[count] = z_at;
    y[count] = y_at;
    weight[count] = weight_at;
    ++count;
  }
  [[nodiscard]] ContourView view() const {
    return {{z.data(), count}, {y.data(), count}, {weight.data(), count}};
  }
};

// Two Gauss points on each panel: of the offsets, and of 24 panels of a Lewis contour (volume within 1e-5).
inline constexpr std::size_t kLewisPanels = 24;
using OffsetQuadrature = ContourQuadrature<2 * (kMaxOffsets + 1)>;
using LewisQuadrature = ContourQuadrature<2 * kLewisPanels>;

/// Integrals over the length of a sectional quantity q and of its slope: of x^n q and x^n dq/dx, n = 0, 1, 2.
struct LengthIntegrals {
  std::array<std::array<double, 3>, kNumStripQuantities> plain{};
  std::array<std::array<double, 3>, kNumStripQuantities> slope{};
};

struct RigidBody {
  double mass = 0.0;  // kg
  double ixx = 0.0;   // kg m2, about G
  double iyy = 0.0;
  double izz = 0.0;
};

struct Restoring {
  double c33 = 0.0;
  double c35 = 0.0;
  double c44 = 0.0;  // rho g nabla GM, fluid
  double c55 = 0.0;
};

struct LoadedHull {
  StripMethod method;
  double gravity = kStandardGravity;
  double density = kSeaWaterDensity;
  double lpp = 0.0;
  double breadth = 0.0;
  Hydrostatics hydrostatics;
  ImmersedSections immersed;      // stations with immersed area, aft to fore
  double g_height = 0.0;          // OG: of (solid) G above the waterplane, + up [m]
  double roll_lever_shift = 0.0;  // m; moves the roll moment of FK loads from the solid to the fluid G
  RigidBody body;
  Restoring restoring;
  double surge_added_mass_factor = 0.0;  // a11' / (rho A)
  double surge_damping_per_speed = 0.0;  // viscous b11 / V [N s2/m2]
  RollDampingModel roll_damping;         // b44 on top of potential damping
  std::optional<Stabiliser> stabiliser;  // more while they work
  double roll_natural_frequency = 0.0;   // rad/s, with a44 there, undamped
  bool has_replaced_section = false;
  const HullTable* table = nullptr;                // of a and b; null: Lewis forms
  bool is_outside_table = false;                   // a table was given, but not for these draughts
  std::array<LevelStencil, kMaxStations> level{};  // in it, by section

  std::size_t num_sections = 0;
  SectionValues x{};             // from G, + forward [m]
  SectionValues weight{};        // trapezoidal: integral over length = sum weight f
  double taper_aft = 0.0;        // beyond the first and the last section the hull ends linearly within this
  double taper_fore = 0.0;       // length, at a station without immersed area; 0: it ends there [m]
  SectionValues half_breadth{};  // at the waterline [m]
  SectionValues area{};
  SectionValues centroid_below_g{};                           // bG [m]
  std::array<OffsetQuadrature, kMaxStations> wave_contour{};  // for Froude-Krilov loads, see StripMethod
  std::array<LewisQuadrature, kMaxStations> lewis_contour{};  // of the forms that a and b belong to
  std::array<LewisSection, kMaxStations> lewis{};

  std::array<double, kNumEncounterNodes> log_omega{};  // of the nodes, natural
  std::array<HeldHydrodynamics, kNumEncounterNodes> node{};
  std::array<LengthIntegrals, kNumEncounterNodes>
      node_integrals{};  // of `node`: linear in it, so interpolated alike
};

/// Fills `out`, after verifying the section table's checksum. `table`: compiled for this hull, or null; `out`
/// keeps the pointer. Where it does not cover the loading, Lewis forms stand in (is_outside_table), and loads
/// by boundary values become kHaskind's. Errors: kTableCorrupt, kHullTableOtherHull, kHullTableNeeded
/// (kBoundaryValue without a table), those of immerse() and hydrostatics(), kOutOfRange for a section outside
/// the section table, kNotFinite. On error `out` is not to be used.
Status load(const Hull& hull, const Loading& loading, const StripMethod& method, LoadedHull& out,
            const HullTable* table = nullptr);

/// Replaces the added roll damping by `ratio` of critical (0 ... 1): b44 = 2 ratio c44 / omega_n.
void set_roll_damping_ratio(LoadedHull& hull, double ratio);

/// a, b of every section at |omega_e| [rad/s] > 0, per metre, about G.
void section_hydrodynamics(const LoadedHull& hull, double omega_e, SectionHydrodynamics& out);

/// At node n: those held, or read into `room`.
const SectionHydrodynamics& node_hydrodynamics(const LoadedHull& hull, std::size_t n,
                                               SectionHydrodynamics& room);

/// Added mass and damping in heave alone, the same values.
void section_heave(const LoadedHull& hull, double omega_e, SectionValues& a33, SectionValues& b33);

/// The integrals of section_hydrodynamics() at |omega_e|, without forming the sections between the nodes.
void length_integrals(const LoadedHull& hull, double omega_e, LengthIntegrals& out);

/// Where |omega_e| lies among the nodes: the parabola's three, in increasing order, and their weights.
struct NodeStencil {
  std::size_t first = 0;
  std::array<double, 3> weight{};
  bool is_inside = false;  // else the rest means nothing
};
NodeStencil node_stencil(const LoadedHull& hull, double omega_e);
/// Of two frequencies.
std::array<NodeStencil, 2> node_stencils(const LoadedHull& hull, Pair omega_e);

/// Three sets of integrals and their weights.
struct LengthStencil {
  std::array<const LengthIntegrals*, 3> at{};
  std::array<double, 3> weight{};
};

/// The same from given sections.
void length_integrals(const LoadedHull& hull, const SectionHydrodynamics& section, LengthIntegrals& out);

/// Trapezoidal integral over the length of section values times x^power, power 0 ... 2.
double integral(const LoadedHull& hull, const SectionValues& values, int power);

/// Integral over the length of d(values)/dx times x^power; with end terms the jumps at both ends are
/// included, and it equals minus the integral of values times d(x^power)/dx to rounding.
double integral_of_slope(const LoadedHull& hull, const SectionValues& values, int power);

}  // namespace quickstrip
