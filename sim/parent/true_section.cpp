#include "sim/parent/true_section.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "sim/parent/close_fit.hpp"
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

TrueSection::TrueSection(const SectionContour& contour, SectionMethod method) : method_(method) {
  if (method == SectionMethod::kLewis) {
    solve_ = shared(lewis_form(contour));
    return;
  }
  if (method == SectionMethod::kCloseFit) {
    if (const CloseFit fit = close_fit(contour); fit.is_conventional) {
      solve_ = shared(mapped_section(fit));
      return;
    }
  }
  method_ = SectionMethod::kFrank;
  solve_ = shared(FrankSection(contour));
}

}  // namespace quickstrip
