// First-order wave loads on the restrained ship, about G, per metre of wave amplitude: Froude-Krilov loads on
// the contour, diffraction loads by equivalent accelerations and velocities [Journee1992] §3 (formulas §6),
// optionally corrected in beam seas so that they obey the Haskind relation: sway and roll in amplitude and
// phase (sway_load_phase.hpp), heave in amplitude; or, with a compiled hull table, by equivalent motions that
// stand for the restrained section's own flow (boundary_value.hpp).
//
// What does not depend on speed is gathered once per (omega, mu) in a WaveField; loads at a speed are then
// dot products over the sections. Assumptions: deep water, wave of small steepness, strips independent of
// each other. Contours: the real one for Froude-Krilov loads (Lewis contour for a hull of minimal form),
// Lewis forms for a and b.
#pragma once

#include <array>
#include <complex>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/pair.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

using Complex = std::complex<double>;
using ComplexSectionValues = std::array<Complex, kMaxStations>;
using HeldComplexValues = std::array<HeldComplex, kMaxStations>;

/// A quantity by section and at the hull's very ends, beyond them by the tapers.
struct AlongHull {
  ComplexSectionValues at;
  Complex aft;
  Complex fore;
};

/// What is known of a restrained section's diffraction, at one wave frequency:
///  kHaskind: corrections of the loads at mu = 90 degrees and V = 0, crest at the section [N/m2, N/m], roll
///    about G (formulas §6); of every direction alike;
///  kBoundaryValue: equivalent motions of the water in heave and sway, dimensionless, and the roll lever [m],
///    about O (boundary_value.hpp); of one direction.
struct SectionDiffraction {
  HeldComplexValues sway{};
  HeldComplexValues heave{};
  HeldComplexValues roll{};
};

/// Froude-Krilov amplitudes and equivalent-motion factors of each section, without the phase of the section's
/// place: smooth in omega.
struct SectionWaves {
  HeldSectionValues surge{};
  HeldSectionValues sway{};
  HeldSectionValues heave{};
  HeldSectionValues roll{};  // about O
  HeldSectionValues heave_factor{};
  HeldSectionValues horizontal_factor{};
};

struct WaveField {
  double omega = 0.0;
  EncounterAngle mu;
  std::array<Complex, 6> froude_krilov{};  // whole ship, about G; surge includes its added-mass part
  // Q = weight * velocity factor, R = the same against the slope of a coefficient; [0]: force, [1]: times x.
  std::array<ComplexSectionValues, 2> heave_velocity{};
  std::array<ComplexSectionValues, 2> heave_velocity_slope{};
  std::array<ComplexSectionValues, 2> sway_velocity{};
  std::array<ComplexSectionValues, 2> sway_velocity_slope{};
  // kBoundaryValue: of the velocities that make the roll moment through a22, b22, by a lever.
  ComplexSectionValues roll_velocity{};
  ComplexSectionValues roll_velocity_slope{};
  std::array<Complex, 6> beam_correction{};  // whole ship, weights of mu included, weight of omega_e not
};

/// Of kHaskind: all of a wave frequency that does not depend on direction. omega > 0 [rad/s].
void beam_sea_correction(const LoadedHull& hull, double omega, SectionDiffraction& out);

/// What the hull's method knows of this wave alone. False: nothing (kClassic), `out` untouched.
bool section_diffraction(const LoadedHull& hull, double omega, EncounterAngle mu, SectionDiffraction& out);

void section_waves(const LoadedHull& hull, double omega, EncounterAngle mu, SectionWaves& out);

/// What of section_waves() is alike for every direction, by frequency, as far as it finds room: pairs of
/// contour points of the sections in their order.
struct WaveDecays {
  std::span<Pair> room;      // none: everything is worked out each time
  std::size_t per_wave = 0;  // pairs
  bool is_filled = false;    // by a direction before

  /// Of frequency f, after `used` pairs of it; empty where there is no room.
  [[nodiscard]] std::span<Pair> place(std::size_t f, std::size_t used, std::size_t count) const {
    return used + count <= per_wave ? room.subspan(f * per_wave + used, count) : std::span<Pair>{};
  }
};
void section_waves(const LoadedHull& hull, double omega, EncounterAngle mu, std::size_t f, WaveDecays& decays,
                   SectionWaves& out);

/// e^{-i k x cos mu}: the wave along the hull, crest at G. omega > 0 [rad/s].
void elevation_along(const LoadedHull& hull, double omega, EncounterAngle mu, AlongHull& out);

/// `diffraction` as the hull's method has it, or null: loads by equivalent motions alone. The two halves are
/// independent: surge, heave and pitch; sway, roll and yaw.
void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                const SectionDiffraction* diffraction, WaveField& out);
void lateral_wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                        const SectionDiffraction* diffraction, WaveField& out);
/// The same with elevation_along() given.
void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const AlongHull& elevation,
                const SectionWaves& sections, const SectionDiffraction* diffraction, WaveField& out);

/// Velocities times the trapezoidal weight, plain and times x, and their weights against the slope of a
/// coefficient: the integral of a_x g over the length is the sum of a_i times the weights of g. By parts; at
/// an end without taper a jumps, which end terms include.
void weigh_velocity(const LoadedHull& hull, const AlongHull& velocity,
                    std::array<ComplexSectionValues, 2>& weighted,
                    std::array<ComplexSectionValues, 2>& against_slope);

/// All of one wave alone, as the hull's method has it (about 20 us).
void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, WaveField& out);

/// Six loads [N, N m per m], times e^{i omega_e t}. `section`: at |omega_e|; omega_e signed, not zero; V
/// [m/s].
std::array<Complex, 6> wave_loads(const LoadedHull& hull, const WaveField& field,
                                  const SectionHydrodynamics& section, double omega_e, double speed);

}  // namespace quickstrip
