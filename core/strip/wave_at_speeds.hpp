// One wave at every speed: what of it does not depend on speed is worked out once, then each pair of speeds
// takes loads, motions and added resistance from it. The same numbers as motion_transfer() and
// added_resistance() give one by one, but for rounding. Cost: 4 us a wave and 0.2 us a speed at 24 sections.
// State: scratch of the wave, whose sums at nodes of encounter frequency are made when first asked for.
#pragma once

#include <array>
#include <cstdint>

#include "core/strip/equations_of_motion.hpp"
#include "core/strip/wave_sums.hpp"

namespace quickstrip {

/// Sway, roll and yaw loads.
using LateralLoad = std::array<Complex, 3>;

/// Sums of one wave at nodes of encounter frequency, as many as are in use at a time: node n in place n %
/// kPlaces, three neighbours always together.
class NodeSums {
 public:
  static constexpr std::size_t kPlaces = kNumEncounterNodes >= 64 ? 32 : 8;

  /// The wave is another.
  void forget() { held_.fill(kNone); }

  /// Sums with the coefficients at |omega_e|, whose place is `nodes`; all, or sway's alone.
  void at(const LoadedHull& hull, const WaveColumns& columns, const NodeStencil& nodes, double omega_e,
          WaveSums& out);
  void lateral_at(const LoadedHull& hull, const WaveColumns& columns, const NodeStencil& nodes,
                  double omega_e, WaveSums& out);

 private:
  static constexpr std::uint8_t kNone = 255;
  static_assert(kNumEncounterNodes < kNone);
  template <auto SumUp>
  WaveSumsStencil stencil(const LoadedHull& hull, const WaveColumns& columns, const NodeStencil& nodes);

  std::array<std::uint8_t, kPlaces> held_{};
  std::array<WaveSums, kPlaces> sums_;
};

/// Of the integral of c |r|^2 over the length, r = w - (A + B x): sums of c |w|^2, c w, c x w and c x^n. It
/// is c |w|^2, less 2 Re {A* (c w) + B* (c x w)}, and |A|^2 (c) + 2 Re A* B (c x) + |B|^2 (c x^2).
struct SquareSums {
  double square = 0.0;
  Pair plain{};
  Pair by_x{};
  std::array<double, 3> moments{};

  [[nodiscard]] double of(Complex a, Complex b) const;
};

/// Scratch of one wave.
struct WaveWork {
  MetWave met;
  double cos_mu = 0.0;
  WaveField field;
  ResistanceWave resistance;
  WaveColumns columns;
  NodeSums nodes;
  std::array<WaveSums, 2> sums;
  SquareSums elevation;                    // against the slope of the half-breadth
  std::array<LengthIntegrals, 2> outside;  // of frequencies beyond the nodes
};

/// Where the integrals at |omega_e| are found; beyond the nodes in `outside`, which is filled.
LengthStencil length_stencil(const LoadedHull& hull, const NodeStencil& nodes, double omega_e,
                             LengthIntegrals& outside);

/// `sections` and `diffraction`: of this wave, as wave_field() takes them.
void set_wave(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
              const SectionDiffraction* diffraction, WaveWork& work);

struct SpeedTerms {
  double speed = 0.0;
  double roll_damping = 0.0;  // b44 on top of potential damping [N m s]
};

struct SolvedSpeed {
  MotionTransfer transfer;
  LateralLoad load;
  double added_resistance = 0.0;
};

/// At two speeds, which may be the same.
std::array<SolvedSpeed, 2> solve_speeds(const LoadedHull& hull, const ShipTerms& ship,
                                        const std::array<SpeedTerms, 2>& speeds, WaveWork& work);

}  // namespace quickstrip
