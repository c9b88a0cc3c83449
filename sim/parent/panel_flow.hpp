// The flow about one mesh of panels: Green's third identity with the wave source of green_function.hpp as
// its kernel, potential constant on each panel, met at the panels' midpoints,
//   pi phi(P) + oint phi dG/dn ds = oint G dphi/dn ds.
// The same kernel and the same irregular frequencies as [Frank1967], who spreads sources instead; the
// potential is bounded at the corners of a section where the strength of sources is not, and it is what the
// loads need: that is why.
//
// The part of G out of phase is a product of two real functions, so the equations are real: the radiated wave
// H enters as one more right-hand side, and b_kj is H_k H_j exactly.
//
// At the irregular frequencies (of the water inside the hull with phi = 0 on it) these equations are
// singular. For points inside the identity reads 0 on the left of phi dG/dn: such equations for points of the
// interior waterline are added and all are met by least squares ([Schenck1968]), from just below the first
// irregular frequency that a section of this breadth can have.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "sim/parent/green_function.hpp"
#include "sim/parent/section_flow.hpp"

namespace quickstrip {

/// Potentials of unit velocities on the panels, e^{+i omega t}; rho = 1.
struct PanelFlow {
  std::array<std::vector<std::complex<double>>, kNumSectionModes> phi;
  std::array<std::array<std::complex<double>, kNumSectionModes>, kNumSectionModes>
      force{};                               // int phi_j n_k ds
  std::array<double, kNumSectionModes> h{};  // signed amplitudes of the radiated waves
};

class PanelMesh {
 public:
  /// `ends` of the panels on the half contour, from the keel; `inside`: points for the removal of irregular
  /// frequencies.
  PanelMesh(const std::vector<std::complex<double>>& ends, const std::vector<std::complex<double>>& inside);

  /// K > 0 [1/m].
  [[nodiscard]] PanelFlow flow(double wave_number) const;

  /// Midpoints and normals, without potentials.
  [[nodiscard]] const std::vector<FlowPoint>& points() const { return points_; }

 private:
  struct Equations;
  [[nodiscard]] std::size_t num_rows(double wave_number, bool is_even) const;
  [[nodiscard]] Equations equations(double wave_number, bool is_even,
                                    const std::vector<PanelInfluence>& direct,
                                    const std::vector<PanelInfluence>& mirrored) const;
  [[nodiscard]] std::complex<double> force(const std::vector<std::complex<double>>& phi,
                                           SectionMode mode) const;
  void solve(bool is_even, Equations& equations, PanelFlow& out) const;

  std::vector<std::complex<double>> ends_;
  std::vector<std::complex<double>> directions_;
  std::vector<FlowPoint> points_;
  std::vector<std::array<double, kNumSectionModes>> normals_;  // unit: n2, n3, n4
  std::vector<std::complex<double>> rows_;                     // midpoints, then points inside
  std::vector<PointOfChain> direct_;                           // of the rows
  std::vector<PointOfChain> mirrored_;                         // of their mirror images in the centre plane
};

}  // namespace quickstrip
