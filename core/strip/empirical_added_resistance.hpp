// Added resistance in regular waves by the semi-empirical method that the ITTC recommends for speed trials
// when no model test is at hand: SNNM [LiuPapanikolaou2020], [ITTC2021] (7.5-04-01-01.1). From main
// dimensions, loading and the two ends of the waterline: a part by motion, fitted to some hundred ships, and
// a part by reflection of short waves, which radiation methods have not. Per metre of wave amplitude squared
// [N/m2], + aft. All headings.
//
// Fit to ships as they are built; it knows nothing of this hull's motions. Formulas: head to beam waves are
// the same in every restatement seen; between beam and following waves the speed factors a1 and a2 are each
// interpolated linearly in direction, where some restatements interpolate their product; a2 in following
// waves is read so that it is continuous in speed (the change at the group velocity). [ITTC2021] and the
// paper were not read in the original but through public programs that state them.
//
// Range of validity (outside it there is no answer): 75 < Lpp < 350 m, 4 < L/B < 9, 2.2 < B/T < 9,
// 0.39 < C_B < 0.90, Fn <= 0.30: what the same procedure prints for its other semi-empirical method,
// STAWAVE-2, as remembered; SNNM's own list could not be read. Fn below 0.1 is left in: SNNM has a branch for
// it. Trim up to 2 % of Lpp, ours: the trim terms 4 - 125 arctan lose their meaning at 3.2 %.
// Expected error: some 20 ... 30 % of the peak, by its authors' figures as remembered.
// Cost: some 0.05 us a frequency. Re-entrant.
#pragma once

#include "core/base/angles.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

struct EmpiricalShip {
  double lpp = 0.0;
  double breadth = 0.0;
  double draught = 0.0;  // the deeper of both perpendiculars [m]
  double trim = 0.0;     // difference of both, without sign [m]
  double cb = 0.0;
  double pitch_gyradius = 0.0;  // of lpp
  double entrance = 0.0;        // angle E1 of the waterline forward: arctan(0.495 B / L_E) [rad]
  double run = 0.0;             // E2 aft
  double density = 0.0;
  double gravity = 0.0;
};

/// L_E, L_R: from a perpendicular to where the waterline has 99 % of its greatest breadth.
EmpiricalShip empirical_ship(const LoadedHull& hull);

bool is_in_range(const EmpiricalShip& ship, double speed);

/// What depends on the wave's frequency alone, omega > 0 [rad/s].
struct EmpiricalWave {
  double omega = 0.0;
  double log_omega = 0.0;
  double decay = 0.0;  // exponent of the wave's pressure, over depth, against that of a wave of 2.5 lpp [1/m]
  double at_draught = 0.0;  // 1 - e^(decay draught)
  bool is_short = false;    // enough to be reflected: lambda <= 2.5 lpp
};
EmpiricalWave empirical_wave(const EmpiricalShip& ship, double omega);

/// One direction at one speed; what does not depend on the wave's frequency is found once.
class EmpiricalResistance {
 public:
  /// Of a ship and speed [m/s] in range.
  EmpiricalResistance(const EmpiricalShip& ship, EncounterAngle mu, double speed);

  /// Of a wave of the same ship.
  [[nodiscard]] double at(const EmpiricalWave& wave) const { return by_motion(wave) + by_reflection(wave); }
  [[nodiscard]] double by_motion(const EmpiricalWave& wave) const;
  [[nodiscard]] double by_reflection(const EmpiricalWave& wave) const;

 private:
  // a: form and heading, b: speed (the paper's a1 and a2).
  struct Factors {
    double form = 0.0;
    double speed = 0.0;
  };
  [[nodiscard]] Factors ahead(double cos_alpha) const;
  [[nodiscard]] Factors following(double omega) const;
  [[nodiscard]] double speed_factor(double froude) const;
  // sin^2(E - alpha) and cos alpha - cos E cos(E - alpha), one face of the waterline in the waves.
  struct Face {
    double square = 0.0;
    double speed = 0.0;
  };
  [[nodiscard]] static Face face(double angle, double to_alpha, double cos_alpha);

  EmpiricalShip ship_;
  double speed_;
  double froude_;
  double root_gl_;
  double log_flatness_;     // ln(B/T)
  double past_beam_ = 0.0;  // 0 to the beam, 1 following
  Factors ahead_;           // at this direction, or at the beam for those behind it
  double motion_scale_ = 0.0;
  double log_omega_bar_ = 0.0;  // ln of it over omega
  double d_low_ = 0.0;
  double d_high_ = 0.0;
  Face forward_;  // sums of the faces that the waves reach
  Face aft_;
  double bluntness_ = 1.0;
  double draught_aft_ = 0.0;
};

}  // namespace quickstrip
