#include "sim/hull_tool/quality_text.hpp"

#include <array>

#include "core/advice/advice.hpp"

namespace quickstrip::hull_tool {

std::string quality_text(std::uint32_t quality) {
  struct Word {
    std::uint32_t bit;
    const char* text;
  };
  constexpr std::array<Word, 8> kWords = {{{kQualityReplacedSection, "replaced_section"},
                                           {kQualityLowEncounter, "low_encounter"},
                                           {kQualityHighFroude, "high_froude"},
                                           {kQualityLowLengthBreadth, "low_length_breadth"},
                                           {kQualityExtremeMotion, "extreme_motion"},
                                           {kQualityTailLost, "tail_lost"},
                                           {kQualitySpeedOverGround, "speed_over_ground"},
                                           {kQualityFreeSurfaceUnknown, "free_surface_unknown"}}};
  std::string out;
  for (const Word& word : kWords) {
    if ((quality & word.bit) != 0) {
      if (!out.empty()) {
        out += '+';
      }
      out += word.text;
    }
  }
  return out;
}

}  // namespace quickstrip::hull_tool
