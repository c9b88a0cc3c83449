// The wave source of two-dimensional flow in deep water, and its integrals along a straight panel in closed
// form. Points are complex, w = z + i y (z up from the waterline, y to port).
//
// A source at w_Q seen from w_P, e^{-i omega t}, radiating ([Frank1967]; checked: G_z = K G on z = 0):
//   G = ln|u| - ln|W| - 2 Re F(W) - 2 pi i Re e^{KW},   u = w_P - w_Q,  W = w_P + conj(w_Q),
//   F(W) = PV int_0^inf e^{kW} / (k - K) dk = e^{KW} {E1(KW) +- i pi}  (+ where Im W >= 0),
// analytic in the whole half plane Re W <= 0: a panel may cross Im W = 0 without being divided. F' = K F -
// 1/W gives int F dW = {F + ln(-W)} / K, so that potential and normal velocity of a panel need F at its ends
// only.
//
// Here: the part of G that is in phase with the source (the rest is a product, f(P) e(Q), see frank.cpp).
// Error of F 5e-12 (tests/parent). Cost 0.05 us to 0.2 us an end.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace quickstrip {

/// F(W) of frequency K [1/m]; `log_minus` = ln(-W), `wave` = e^{KW}, which the caller has at less cost.
/// Re W <= 0, W != 0.
std::complex<double> wave_integral(std::complex<double> w, double wave_number, std::complex<double> log_minus,
                                   std::complex<double> wave);

/// What a chain of panels does to a point, of one frequency or of none: of each panel the integral of G over
/// it and of dG/dn (n to the right of the direction in which the chain runs).
struct PanelInfluence {
  double potential = 0.0;
  double normal = 0.0;
};

/// The integrals of a chain's panels at one point, prepared for any frequency.
class PointOfChain {
 public:
  /// `nodes`: ends of the panels; `own`: the panel that the point is the midpoint of, or none (< 0).
  PointOfChain(std::complex<double> point, const std::vector<std::complex<double>>& nodes, int own);

  /// `waves`: e^{K w} of the nodes. `out`: one for each panel.
  void influence(double wave_number, const std::vector<std::complex<double>>& waves,
                 std::vector<PanelInfluence>& out) const;

 private:
  struct End {
    std::complex<double> image;      // W
    std::complex<double> log_minus;  // ln(-W)
  };
  std::complex<double> point_;
  std::vector<End> ends_;
  std::vector<std::complex<double>> directions_;
  std::vector<PanelInfluence> fixed_;  // ln|u| - ln|W|
};

}  // namespace quickstrip
