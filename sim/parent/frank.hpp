// Flow about an arbitrary symmetric section: conventional, bulbous, re-entrant, tunnelled, wholly submerged.
// [Frank1967]'s pulsating wave source on straight panels, solved for the potential (panel_flow.hpp says why),
// irregular frequencies removed; extrapolated from two meshes, one of every second panel end.
//
// Range: sections that section_contour accepts, xi = K B/2 of 1e-6 ... 40.
// Error with 56 panels, as shares of the complex force i omega a + b (tests/parent):
// - Lewis forms, xi 0.02 ... 10, against an independent boundary-element solution: median 0.001, worst 0.13 %
// - circle in heave against Ursell's analytic figures: 0.01 %
// - stations of S-175, KCS, DTMB 5512 (bulb, dome, skeg, transom), 112 panels: 0.3 %, sway of a transom 0.6 %
// - rectangles at their first six irregular frequencies: 0.3 % of the water displaced
// - conventional stations of the S-175 against the close-fit mapping: 0.5 % in sway and heave, 2 % in roll
// `is_converged` is false where damping by pressure and by the radiated wave, or 24 and 42, differ by 1 %, or
// extrapolation moves a value by 3 %, and four times the panels do not cure it.
// Cost: 2 ms a section, 0.6 ms (long waves) to 1.2 ms a frequency.
#pragma once

#include <complex>
#include <vector>

#include "sim/parent/panel_flow.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip {

struct FrankOptions {
  int num_panels = 56;  // on the half contour
  // False leaves them in, to show them; then a flow that fails its checks is returned as it is.
  bool removes_irregular_frequencies = true;
};

class FrankSection {
 public:
  explicit FrankSection(const SectionContour& contour, const FrankOptions& options = {});

  /// K = omega^2 / g > 0 [1/m]; several threads may ask. A flow that fails its checks is solved again with
  /// twice, then four times the panels (which costs 10 and 40 ms: a film of water over a bulb, a thin plate).
  [[nodiscard]] SectionFlow flow(double wave_number) const;

 private:
  FrankSection(const SectionContour& contour, const FrankOptions& options,
               const std::vector<std::complex<double>>& inside);
  [[nodiscard]] SectionFlow flow_of_these_panels(double wave_number) const;

  SectionContour contour_;
  FrankOptions options_;
  PanelMesh fine_;
  PanelMesh coarse_;
  double depth_ = 0.0;  // or half breadth, the greater [m]
};

}  // namespace quickstrip
