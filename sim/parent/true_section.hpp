// A section by the method of the user's choice: prepared once, solved at any frequency.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip {

enum class SectionMethod : std::uint8_t {
  kLewis,     // of the section's breadth, draught and area, as the program on board takes it (replaced forms
              // too)
  kCloseFit,  // conformal mapping of the contour; Frank's method where no mapping fits
  kFrank,     // pulsating sources, any contour
};

/// "lewis", "close-fit", "frank".
const char* name_of(SectionMethod method);

class TrueSection {
 public:
  /// Copies share what was prepared.
  TrueSection(const SectionContour& contour, SectionMethod method);

  /// K = omega^2 / g > 0 [1/m]; several threads may ask.
  [[nodiscard]] SectionFlow flow(double wave_number) const { return solve_(wave_number); }

  /// The method in use: not the one asked for where that falls back on another.
  [[nodiscard]] SectionMethod method() const { return method_; }

 private:
  SectionMethod method_;
  std::function<SectionFlow(double)> solve_;
};

}  // namespace quickstrip
