// The parent program: strip theory as on board, but on the flow about every section solved at every frequency
// of encounter, without a table. What SEAWAY is to SEAQUICK in [Journee1992].
//
// Geometry, hydrostatics, Froude-Krilov loads, viscous damping, the equations and the choices of method are
// core's, so that what differs between this and the program on board is where a, b and diffraction come from:
//   classic, haskind  equivalent motions, with the solved a and b;
//   boundary values   diffraction_factors() of each section at the wave's own k and mu from the potentials at
//                     the frequency of encounter [STF1970], or at the wave's frequency;
//                     slopes along the hull act on coefficient times factor, as there.
// Roll damping rests on the natural frequency and the wave damping of the solved sections too.
//
// Against another program of that theory (ShipX VERES, S-175, modified, surge of inertia only; medians over
// the directions of the RMS over frequency, in % of the peak): at rest surge 0.1, sway 0.1, heave 0.5, roll
// 0.2, pitch 1.6, yaw 0.3; at 20 kn 0.1, 0.2, 0.8, 0.2, 1.0, 0.3. With potentials of the wave's frequency at
// 20 kn 0.1, 0.2, 0.8, 0.6, 1.0, 0.3; with slopes on the coefficients alone sway 0.5, pitch 2.1, yaw 4.4.
//
// Range: omega_e, as the equations see it, within core's nodes, 0.05 ... 50 sqrt(g/L). Cost: a flow a section
// and frequency of encounter (mapped_flow.hpp, frank.hpp: 10 ms ... 50 ms a ship), the rest some 0.2 ms;
// frequencies share flows where the ship is at rest. Same result on any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/angles.hpp"
#include "core/hull/hull.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/regular_wave_roll.hpp"
#include "sim/parent/true_section.hpp"

namespace quickstrip {

struct ParentWave {
  double omega = 0.0;  // > 0 [rad/s]
  EncounterAngle mu;
  double speed = 0.0;  // m/s
};

/// The ship in one wave; what other roll dampings need is kept.
struct ParentResponse {
  ParentWave wave;
  MotionTransfer transfer;          // per metre of amplitude, damping of roll in this wave (see below)
  double roll_amplitude = 0.0;      // rad
  double added_resistance = 0.0;    // N/m2, + aft
  std::array<Complex, 6> load{};    // N/m, N m/m
  LengthIntegrals integrals;        // of the sections at |omega_e|, as the equations see it
  std::size_t num_unconverged = 0;  // sections whose own check of accuracy failed
};

struct ParentOptions {
  SectionMethod sections = SectionMethod::kCloseFit;
  /// Potentials of boundary values: at the frequency of encounter, or at the wave's.
  bool diffracts_at_encounter = true;
  unsigned num_threads = 1;
};

class ParentShip {
 public:
  /// Throws std::invalid_argument with the reason: what load() refuses, a station whose contour is none.
  ParentShip(const Hull& hull, const Loading& loading, const StripMethod& method,
             const ParentOptions& options = {});

  /// Everything but the sections' flow: their a and b here are of use near the natural roll frequency only.
  [[nodiscard]] const LoadedHull& hull() const { return *hull_; }

  /// Replaces the added roll damping by a ratio of critical.
  void set_roll_damping_ratio(double ratio);

  /// In waves of `amplitude` > 0 [m], which counts where roll damping depends on roll. Order of the waves.
  [[nodiscard]] std::vector<ParentResponse> solve(std::span<const ParentWave> waves,
                                                  double amplitude = 1.0) const;

  /// The same ship in the same wave with another added roll damping b44 [N m s]. `scratch`: a copy of hull().
  static MotionTransfer damped(const ParentResponse& response, double roll_damping, LoadedHull& scratch);

 private:
  struct Flows;
  [[nodiscard]] std::vector<SectionFlow> flows(double wave_number) const;
  [[nodiscard]] Flows flows_at(double omega) const;
  void solve_group(double omega_e, std::span<const std::size_t> members, std::span<const ParentWave> waves,
                   double amplitude, LoadedHull& scratch, std::vector<ParentResponse>& out) const;
  void solve_roll_nodes();

  ParentOptions options_;
  std::unique_ptr<LoadedHull> hull_;
  std::vector<TrueSection> sections_;  // as hull_'s
};

}  // namespace quickstrip
