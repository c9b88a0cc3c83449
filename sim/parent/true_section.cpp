#include "sim/parent/true_section.hpp"

#include "sim/parent/frank.hpp"

namespace quickstrip {

// Until the mapped sections are there every method is Frank's, and method() says so.
TrueSection::TrueSection(const SectionContour& contour, SectionMethod)
    : frank_(std::make_shared<FrankSection>(contour)) {}

SectionFlow TrueSection::flow(double wave_number) const {
  return frank_->flow(wave_number);
}

}  // namespace quickstrip
