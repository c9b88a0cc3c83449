#include "msgs/convert/hazard_text.hpp"

namespace quickstrip {

const HazardWords* leading_zone(std::uint16_t hazards) {
  for (const std::uint16_t level : {kSevereZoneBits, kZoneBits}) {
    for (const HazardWords& words : kHazardWords) {
      if ((hazards & level & words.bit) != 0) {
        return &words;
      }
    }
  }
  return nullptr;
}

}  // namespace quickstrip
