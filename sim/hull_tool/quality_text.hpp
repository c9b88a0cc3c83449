// Quality bits as words for a CSV field: "replaced_section+low_encounter", empty when there is nothing to
// say.
#pragma once

#include <cstdint>
#include <string>

namespace quickstrip::hull_tool {

std::string quality_text(std::uint32_t quality);

/// Of HazardBit, "surf_riding;motions"; empty: none.
std::string hazard_tokens(std::uint16_t hazards);

}  // namespace quickstrip::hull_tool
