// Transverse stability on a long wave: how GM changes with the height of a wave of the ship's own length and
// with where its crest is.
//
// The hull floats quasi-statically on the frozen wave zeta(x) = H/2 cos(2 pi (x - x_crest) / L): sinkage and
// trim keep displacement and the x of the centre of buoyancy. Pressure is hydrostatic below the local surface
// (no Smith effect), as in [IMO2020] and the Grim effective wave (core/hazard/effective_wave.hpp). Then
//   GM = (int 2/3 y^3 dx + int int z dA dx) / volume - KG,
// the stiffness of small roll about the centre plane. Only its change against still water is kept: that does
// not depend on KG, so it holds for any GM at these draughts. Left out: the lever (KG - KB) sin(trim) in the
// trimming moment (some per cent of the trim).
// Above its offsets a section goes on with the slope of its last panel, never narrower, and no wider than the
// hull's greatest half-breadth; a contour that closes on the centre plane is a bulb and ends there.
// `covered_height` says up to which wave no section needed that.
// Heights 0 ... 0.1 L, straight lines between them, held beyond; crests at tenths of L.
// Error: the still-water GM, rounding (tests/hull); of the crests: the extremes of a cosine-like curve on ten
// points are missed by at most 1 - cos(18 degrees) = 5 % of the amplitude.
// A hull with stations of minimal form has one draught only: not known.
// Cost: 100 balances of about four steps, 0.7 ms for 24 stations; when the loading changes. Memory: 150
// bytes.
#pragma once

#include <array>
#include <cstddef>

#include "core/hull/hull.hpp"

namespace quickstrip {

/// Over the crest positions at one wave height, against still water [m].
struct GmChange {
  float least = 0.0F;
  float greatest = 0.0F;
  float mean = 0.0F;
};

struct GmInWaves {
  static constexpr std::size_t kNumHeights = 11;
  static constexpr double kStep = 0.01;  // of L
  static constexpr std::size_t kNumCrests = 10;

  bool is_known = false;
  double length = 0.0;                            // of the wave: lpp [m]
  double covered_height = 0.0;                    // [m]; above it sections are continued beyond their offsets
  std::array<GmChange, kNumHeights> by_height{};  // height n kStep length
};

/// Not known: a minimal form, or a balance that does not settle (a hull nearly out of freeboard).
GmInWaves gm_in_waves(const Hull& hull, const Loading& loading);

/// At a wave height >= 0 [m]; straight lines between the heights, the last one beyond.
GmChange gm_change(const GmInWaves& table, double height);

/// GM on one wave minus GM in still water [m]; crest: x of a crest from the aft perpendicular [m]. False when
/// it does not settle; `is_covered` becomes false when a section was continued beyond its offsets.
[[nodiscard]] bool gm_change_on_wave(const Hull& hull, const Loading& loading, double height, double crest,
                                     double& change, bool& is_covered);

}  // namespace quickstrip
