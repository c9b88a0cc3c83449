// Hazard bits of a cell: where the ship is, whatever her linear motions say. At most 15, for the wire has
// int16. Worded once, in msgs/convert/hazard_text.hpp and msgs/CHANNELS.md.
//
// Zones come in one level or in two: the zone by geometry and period, and its warning where the waves (or the
// ship's own stability, damping or measured motion) make it real. A warning never stands without its zone.
#pragma once

#include <cstddef>
#include <cstdint>

namespace quickstrip {

enum HazardBit : std::uint16_t {
  kHazardNoSteerage = 1u << 0,          // below the minimum steerage speed: never recommended
  kHazardFollowingUnwatched = 1u << 1,  // linear motions say nothing: too much at low encounter frequency
  // IMO zones, of any wave system
  kHazardSurfRiding = 1u << 2,                // surf-riding and broaching-to
  kHazardSurfRidingWaves = 1u << 3,           // warning: and the waves are long and high enough for it
  kHazardSuccessiveWaves = 1u << 4,           // successive high-wave attack
  kHazardSuccessiveWavesConfirmed = 1u << 5,  // warning: and measured motion shows it
  kHazardSynchronousRoll = 1u << 6,           // encounter period near the roll period
  kHazardParametricRoll = 1u << 7,            // encounter period near the roll period or half of it
  kHazardParametricRollGrows = 1u << 8,       // warning: the stiffness varies more than damping can take
  kHazardPureLoss = 1u << 9,                  // pure loss of stability on a crest
  kHazardPureLossGm = 1u << 10,               // warning: hardly any GM is left on the crest
  // Not a zone: no verdict follows from it.
  kHazardMarginalSurfRiding = 1u << 11,  // large surging below the surf-riding speed: the grey band
  // What is known
  kHazardZonesUnknown = 1u << 12,  // waves from abaft the beam, and a zone that could not be evaluated
  kHazardMotions = 1u << 13,       // a watched motion by itself gives cause for caution or more
};
inline constexpr std::size_t kNumHazardBits = 14;

/// Warnings: the verdict is "exceeded".
inline constexpr std::uint16_t kSevereZoneBits =
    kHazardSurfRidingWaves | kHazardSuccessiveWavesConfirmed | kHazardParametricRollGrows | kHazardPureLossGm;

/// Any of them: at least "caution". Without kHazardMotions: "zone only"; kHazardMotions alone: "motion only".
inline constexpr std::uint16_t kZoneBits = kHazardSurfRiding | kHazardSuccessiveWaves |
                                           kHazardSynchronousRoll | kHazardParametricRoll | kHazardPureLoss |
                                           kSevereZoneBits;

}  // namespace quickstrip
