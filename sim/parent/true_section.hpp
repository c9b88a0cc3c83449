// A section by the method of the user's choice, prepared once, solved at any frequency.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip {

enum class SectionMethod : std::uint8_t {
  kLewis,     // of the section's breadth, draught and area
  kCloseFit,  // conformal mapping of the contour; Frank's method where no mapping fits
  kFrank,     // pulsating sources, any contour
};

class FrankSection;

class TrueSection {
 public:
  TrueSection(const SectionContour& contour, SectionMethod method);

  /// K = omega^2 / g > 0 [1/m]; may be called from several threads.
  [[nodiscard]] SectionFlow flow(double wave_number) const;

  /// The method that is used, which a fall-back makes another than the one asked for.
  [[nodiscard]] SectionMethod method() const { return method_; }

 private:
  SectionMethod method_ = SectionMethod::kFrank;
  std::shared_ptr<const FrankSection> frank_;
};

}  // namespace quickstrip
