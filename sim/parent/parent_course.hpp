// Statistics of the parent program on one course at one speed, long-crested: what core's tables of transfer
// functions and sums over their nodes do quickly, here by brute force. The same quantities over the same
// range of wave frequencies, renormalised alike (sea_energy.hpp), so that the difference is the method's.
//
// Frequencies: those of the program on board, each interval divided, and more of them about the roll
// resonance; trapezoidal rule. Roll damping of the sea's own roll, as core linearises it [ITTC2011], found by
// bisection. Error of the sums: against twice as many frequencies below 1e-3 (tests/parent).
#pragma once

#include <span>
#include <vector>

#include "core/response/moments.hpp"
#include "core/response/watch.hpp"
#include "core/sea/spectrum.hpp"
#include "sim/parent/parent_ship.hpp"

namespace quickstrip {

struct ParentStatistics {
  std::vector<ResponseMoments> moments;  // by channel; m0_by_system is of the one system
  double added_resistance = 0.0;         // mean [N], + aft
  double roll_damping = 0.0;             // added b44 [N m s]
};

/// `nodes` in order, every interval divided into `parts`, and 8 `parts` + 1 more about each wave frequency
/// at which she meets waves at her natural frequency of roll.
std::vector<double> parent_frequencies(const LoadedHull& hull, EncounterAngle mu, double speed,
                                       std::span<const double> nodes, std::size_t parts = 4);

class ParentCourse {
 public:
  /// Solves every frequency (increasing, two at least).
  ParentCourse(const ParentShip& ship, EncounterAngle mu, double speed, std::span<const double> omegas);

  [[nodiscard]] ParentStatistics respond(const Spectrum& spectrum, const Watch& watch) const;

 private:
  [[nodiscard]] std::vector<MotionTransfer> motions(double roll_damping) const;
  [[nodiscard]] ResponseMoments moments(const Channel& channel, std::span<const MotionTransfer> motions,
                                        std::span<const double> energy) const;
  [[nodiscard]] std::vector<double> energies(const Spectrum& spectrum) const;

  const ParentShip& ship_;
  EncounterAngle mu_;
  double speed_;
  std::vector<ParentResponse> responses_;
};

}  // namespace quickstrip
