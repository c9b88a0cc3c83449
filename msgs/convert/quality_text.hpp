// The words for quality bits, once for all programs: a token for tables, and a sentence for the bridge where
// the officer of the watch should know. msgs/CHANNELS.md lists the bits as they are on the wire.
#pragma once

#include <array>

#include "core/advice/advice.hpp"

namespace quickstrip {

struct QualityWords {
  QualityBit bit;
  const char* token;   // one word
  const char* bridge;  // a sentence without its full stop, or "": not said on the bridge
};

inline constexpr std::array<QualityWords, kNumQualityBits> kQualityWords{{
    {kQualityReplacedSection, "replaced_section", ""},
    {kQualityLowEncounter, "low_encounter", ""},  // said as a hazard where it matters
    {kQualityHighFroude, "high_froude", ""},
    {kQualityLowLengthBreadth, "low_length_breadth", ""},
    {kQualityExtremeMotion, "extreme_motion", "Roll beyond 10° RMS: figures uncertain"},
    {kQualityTailLost, "tail_lost", ""},
    {kQualitySpeedOverGround, "speed_over_ground", "Speed over ground"},
    {kQualityFreeSurfaceUnknown, "free_surface_unknown", "Free surfaces not known"},
    {kQualityWideBand, "wide_band", ""},
    {kQualitySwellUpRange, "swell_up_range", ""},
    {kQualityShallowWater, "shallow_water", "Shallow water: not computed"},
    {kQualityRollDampingRange, "roll_damping_range", ""},
    {kQualityRollNotConverged, "roll_not_converged", "Roll damping not settled: roll uncertain"},
    {kQualitySpeedNotKept, "speed_not_kept", "The engine cannot keep this speed in these waves"},
    {kQualityOutsideHullTable, "outside_hull_table", "Draughts outside the hull table: less accurate"},
}};

}  // namespace quickstrip
