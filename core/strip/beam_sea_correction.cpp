// The Haskind correction of sectional loads in beam seas; what it is for: wave_loads.hpp.
#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"
#include "core/strip/froude_krilov.hpp"
#include "core/strip/sway_load_phase.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {
namespace {

constexpr Complex kI(0.0, 1.0);

// Signed square root of a radiated-wave relation, sqrt(rho g^2 b / omega): the Haskind amplitude of a load.
double haskind_amplitude(const LoadedHull& hull, double damping, double omega) {
  return std::sqrt(std::max(0.0, hull.density * hull.gravity * hull.gravity * damping / omega));
}

}  // namespace

void beam_sea_correction(const LoadedHull& hull, double omega, SectionDiffraction& out) {
  static_assert(sizeof(SectionHydrodynamics) < 8192, "kept on the stack");
  SectionHydrodynamics section;
  section_hydrodynamics(hull, omega, section);
  const double k = wave_number(omega, hull.gravity);
  const bool is_radiated = hull.method.beam_loads == BeamLoads::kRadiatedWave;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    // All on the form that a and b belong to: then the correction vanishes in long waves, term by term.
    const bool is_lewis = hull.table == nullptr;
    const double breadth = is_lewis ? hull.lewis[i].breadth : 2.0 * hull.half_breadth[i];
    const FroudeKrilov fk =
        froude_krilov(is_lewis ? hull.lewis_contour[i].view() : hull.wave_contour[i].view(), 0.5 * breadth,
                      hull.density, hull.gravity, k, EncounterAngle{0.5 * kPi});
    // Equivalent displacements: zeta*_2 = -i factor, zeta*_3 = factor.
    const Complex sway = -kI * fk.horizontal_factor;
    const Complex x2 =
        kI * fk.sway + Complex(-omega * omega * section[kA22][i], omega * section[kB22][i]) * sway;
    const Complex x4 = -kI * fk.roll + hull.g_height * kI * fk.sway +
                       Complex(-omega * omega * section[kA24][i], omega * section[kB24][i]) * sway;
    const Complex x3 =
        fk.heave + Complex(-omega * omega * section[kA33][i], omega * section[kB33][i]) * fk.heave_factor;

    const double h2 = haskind_amplitude(hull, section[kB22][i], omega);
    const Complex x2h = std::polar(h2, is_radiated ? sway_load_phase(hull.lewis[i], k) : std::arg(x2));
    const double lever = section[kB22][i] > 0.0 ? section[kB24][i] / section[kB22][i] : 0.0;
    const double h3 = haskind_amplitude(hull, section[kB33][i], omega);
    const double r = std::clamp(fk.heave - omega * omega * section[kA33][i] * fk.heave_factor, -h3, h3);
    const Complex x3h(r, std::sqrt(std::max(0.0, h3 * h3 - r * r)));

    // The square root is of order omega and would spoil the long-wave limit in oblique seas.
    const double kb = k * breadth / 0.04;
    out.sway[i] = x2h - x2;
    out.roll[i] = lever * x2h - x4;
    out.heave[i] = (x3h - x3) * (1.0 - std::exp(-kb * kb));
  }
}

}  // namespace quickstrip
