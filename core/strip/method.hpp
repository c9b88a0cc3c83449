// The choices that strip theory leaves open; the default of each is its first value (contract §4).
#pragma once

#include <cstdint>

namespace quickstrip {

enum class StripVariant : std::uint8_t {
  kOrdinary,  // d/dt{a v} + b v [Korvin-Kroukovsky1957]
  kModified,  // d/dt{(a - i b/omega_e) v} [Tasai1969], [STF1970]
};

enum class DiffractionLoads : std::uint8_t {
  kHaskind,        // equivalent motions, corrected so that beam seas obey the Haskind relation
  kClassic,        // equivalent accelerations and velocities alone [Journee1992] §3
  kBoundaryValue,  // the restrained section's own flow, of a compiled hull table (boundary_value.hpp)
};

enum class BeamLoads : std::uint8_t {
  kRadiatedWave,      // of kHaskind: sway loads in phase with the radiated wave, speed terms of yaw and pitch
  kEquivalentMotion,  // in phase with the equivalent motion's load, no speed terms: what others program
};

enum class SurgeTerms : std::uint8_t {
  kFull,         // potential added mass and viscous damping in surge
  kInertiaOnly,  // a11 = b11 = 0
};

enum class WaveContour : std::uint8_t {
  kOffsets,  // undisturbed wave pressure on the real section, where offsets are known
  kLewis,    // on the Lewis form, as [Journee1992] §4 has it
};

enum class LowEncounterRule : std::uint8_t {
  kFloor,  // |omega_e| held at a floor in coefficients and equations, and flagged
  kPaper,  // wave loads forced to zero there [Journee1992] §2, and flagged
};

enum class SwellUp : std::uint8_t {
  kOnboard,  // relative motion raised by the ship's own waves, response/swell_up.hpp
  kOff,      // the undisturbed wave and the geometrical freeboard [Journee1992] §3: the unsafe side
};

struct StripMethod {
  StripVariant variant = StripVariant::kOrdinary;
  bool end_terms = true;  // the jump of added mass at the hull's ends (matters for transoms)
  DiffractionLoads loads = DiffractionLoads::kHaskind;
  SurgeTerms surge = SurgeTerms::kFull;
  LowEncounterRule low_encounter = LowEncounterRule::kFloor;
  WaveContour contour = WaveContour::kOffsets;
  BeamLoads beam_loads = BeamLoads::kRadiatedWave;
  SwellUp swell_up = SwellUp::kOnboard;
};

/// The paper's own setting, `--paper`.
inline constexpr StripMethod kPaperMethod{.variant = StripVariant::kOrdinary,
                                          .end_terms = true,
                                          .loads = DiffractionLoads::kClassic,
                                          .surge = SurgeTerms::kFull,
                                          .low_encounter = LowEncounterRule::kPaper,
                                          .contour = WaveContour::kLewis,
                                          .swell_up = SwellUp::kOff};

}  // namespace quickstrip
