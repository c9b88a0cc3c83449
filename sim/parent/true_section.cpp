#include "sim/parent/true_section.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "sim/parent/frank.hpp"
#include "sim/parent/mapped_flow.hpp"

namespace quickstrip {
namespace {

template <typename Section>
std::function<SectionFlow(double)> shared(Section section) {
  return [kept = std::make_shared<const Section>(std::move(section))](double wave_number) {
    return kept->flow(wave_number);
  };
}

MappedSection lewis_form(const SectionContour& contour) {
  double depth = 0.0;
  for (const Offset& p : contour.points) {
    depth = std::max(depth, -p.z);
  }
  const Result<LewisSection> form =
      hydrodynamic_lewis_section(2.0 * contour.half_breadth(), depth, area(contour));
  if (!form) {
    throw std::invalid_argument(std::string("a section without a Lewis form: ") + message(form.error()));
  }
  return mapped_section(*form);
}

}  // namespace

const char* name_of(SectionMethod method) {
  switch (method) {
    case SectionMethod::kLewis:
      return "lewis";
    case SectionMethod::kCloseFit:
      return "close-fit";
    case SectionMethod::kFrank:
      break;
  }
  return "frank";
}

// The close fit is not there yet: Frank's method takes its place, and method() says so.
TrueSection::TrueSection(const SectionContour& contour, SectionMethod method)
    : method_(method == SectionMethod::kLewis ? method : SectionMethod::kFrank),
      solve_(method == SectionMethod::kLewis ? shared(lewis_form(contour)) : shared(FrankSection(contour))) {}

}  // namespace quickstrip
