// The words for hazard bits, once for all programs: a token for tables, a short name for pictures and the
// display, and a clause for the bridge. msgs/CHANNELS.md lists the bits as they are on the wire.
#pragma once

#include <array>
#include <cstdint>

#include "core/hazard/hazard_bits.hpp"

namespace quickstrip {

struct HazardWords {
  HazardBit bit;
  const char* token;   // one word
  const char* name;    // a few words, no capital
  const char* bridge;  // a sentence without its full stop, its source in brackets
};

/// By bit, in order.
inline constexpr std::array<HazardWords, kNumHazardBits> kHazardWords{{
    {kHazardNoSteerage, "no_steerage", "below steerage speed", "Below steerage speed"},
    {kHazardFollowingUnwatched, "following_unwatched", "motions not known",
     "Following sea: slow motions are not fully covered"},
    {kHazardSurfRiding, "surf_riding", "surf-riding zone", "Surf-riding zone (IMO MSC.1/Circ.1228)"},
    {kHazardSurfRidingWaves, "surf_riding_waves", "surf-riding, waves high enough",
     "Danger of surf-riding and broaching-to (IMO MSC.1/Circ.1627)"},
    {kHazardSuccessiveWaves, "successive_waves", "successive high waves",
     "Successive high-wave attack zone (IMO MSC.1/Circ.1228)"},
    {kHazardSuccessiveWavesConfirmed, "successive_waves_confirmed", "successive high waves, felt",
     "Successive high-wave attack, confirmed by measured motion"},
    {kHazardSynchronousRoll, "synchronous_roll", "synchronous roll zone",
     "Synchronous roll zone (IMO MSC.1/Circ.1228)"},
    {kHazardParametricRoll, "parametric_roll", "parametric roll zone",
     "Parametric roll zone (IMO MSC.1/Circ.1228)"},
    {kHazardParametricRollGrows, "parametric_roll_grows", "parametric roll can grow",
     "Parametric roll can grow: stability varies more than roll damping can take"},
    {kHazardPureLoss, "pure_loss", "pure loss of stability zone",
     "Pure loss of stability zone (IMO MSC.1/Circ.1627)"},
    {kHazardPureLossGm, "pure_loss_gm", "stability lost on the crest",
     "Hardly any stability is left on a wave crest"},
    {kHazardMarginalSurfRiding, "marginal_surf_riding", "large surging",
     "Large surging possible (band below the surf-riding speed)"},
    {kHazardZonesUnknown, "zones_unknown", "zones not known",
     "Waves from abaft the beam, and stability in waves is not known"},
    {kHazardMotions, "motions", "motions near or above a limit", ""},
}};

/// The one to name first among the zones of `hazards`: warnings before cautions, each in the order of the
/// bits. Null: none of them is a zone.
const HazardWords* leading_zone(std::uint16_t hazards);

}  // namespace quickstrip
