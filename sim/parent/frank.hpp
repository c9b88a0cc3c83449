// Flow about an arbitrary symmetric section: conventional, bulbous, re-entrant, wholly submerged.
#pragma once

#include "sim/parent/panel_flow.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip {

struct FrankOptions {
  int num_panels = 56;  // on the half contour
  bool removes_irregular_frequencies = true;
};

class FrankSection {
 public:
  explicit FrankSection(const SectionContour& contour, const FrankOptions& options = {});

  /// K = omega^2 / g > 0 [1/m].
  [[nodiscard]] SectionFlow flow(double wave_number) const;

 private:
  PanelMesh fine_;
  PanelMesh coarse_;
  double depth_ = 0.0;  // or half breadth, the greater [m]
};

}  // namespace quickstrip
