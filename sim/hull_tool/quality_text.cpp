#include "sim/hull_tool/quality_text.hpp"

#include "msgs/convert/hazard_text.hpp"
#include "msgs/convert/quality_text.hpp"

namespace quickstrip::hull_tool {

std::string quality_text(std::uint32_t quality) {
  std::string out;
  for (const QualityWords& words : kQualityWords) {
    if ((quality & words.bit) != 0) {
      out.append(out.empty() ? "" : "+").append(words.token);
    }
  }
  return out;
}

std::string hazard_tokens(std::uint16_t hazards) {
  std::string out;
  for (const HazardWords& words : kHazardWords) {
    if ((hazards & words.bit) != 0) {
      out += out.empty() ? "" : ";";
      out += words.token;
    }
  }
  return out;
}

}  // namespace quickstrip::hull_tool
