#include "sim/parent/frank.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/check.hpp"
#include "sim/parent/panels.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// Both meshes share the form of their error, which goes as the square of the panels' length.
double extrapolated(double fine, double coarse) {
  return fine + (fine - coarse) / 3.0;
}

Complex extrapolated(Complex fine, Complex coarse) {
  return fine + (fine - coarse) / 3.0;
}

// Limits of the checks. On Lewis forms of the reference (xi 0.02 ... 10) the first two stay below 0.0013, the
// third below 0.01; at an irregular frequency left in they are of order 1.
constexpr double kEnergyLimit = 0.01;
constexpr double kReciprocityLimit = 0.01;
constexpr double kCorrectionLimit = 0.03;

// Damping by the pressure on the hull against that by the radiated wave; 24 against 42; what extrapolation
// changes. Damping counts as 5 % of the force at least, 44 as 1 % of 22 at the section's depth.
bool agrees(const PanelFlow& fine, const PanelFlow& coarse, double depth) {
  std::array<double, kNumSectionModes> size{};
  for (std::size_t k = 0; k < kNumSectionModes; ++k) {
    size[k] = std::abs(fine.force[k][k]);
  }
  size[kSectionRoll] = std::max(size[kSectionRoll], 0.01 * size[kSectionSway] * depth * depth);
  bool good = true;
  for (std::size_t k = 0; k < kNumSectionModes; ++k) {
    const Complex force = extrapolated(fine.force[k][k], coarse.force[k][k]);
    const double radiated = std::pow(extrapolated(fine.h[k], coarse.h[k]), 2);
    const double scale = std::max(radiated, 0.05 * size[k]);
    good = good && std::abs(force.imag() - radiated) < kEnergyLimit * scale &&
           std::abs(force - fine.force[k][k]) < kCorrectionLimit * size[k];
  }
  const Complex forth =
      extrapolated(fine.force[kSectionSway][kSectionRoll], coarse.force[kSectionSway][kSectionRoll]);
  const Complex back =
      extrapolated(fine.force[kSectionRoll][kSectionSway], coarse.force[kSectionRoll][kSectionSway]);
  return good &&
         std::abs(forth - back) < kReciprocityLimit * std::sqrt(size[kSectionSway] * size[kSectionRoll]);
}

}  // namespace

FrankSection::FrankSection(const SectionContour& contour, const FrankOptions& options)
    : FrankSection(
          contour, options,
          options.removes_irregular_frequencies ? interior_points(contour) : std::vector<Complex>{}) {}

FrankSection::FrankSection(const SectionContour& contour, const FrankOptions& options,
                           const std::vector<Complex>& inside)
    : contour_(contour),
      options_(options),
      fine_(panel_ends(contour, options.num_panels), inside),
      coarse_(coarsened(panel_ends(contour, options.num_panels)), inside) {
  for (const Offset& p : contour.points) {
    depth_ = std::max({depth_, p.y, -p.z});
  }
}

SectionFlow FrankSection::flow(double wave_number) const {
  SectionFlow out = flow_of_these_panels(wave_number);
  for (const int times : {2, 4}) {
    if (out.is_converged || !options_.removes_irregular_frequencies) {
      break;
    }
    const FrankSection finer(contour_, {.num_panels = times * options_.num_panels});
    out = finer.flow_of_these_panels(wave_number);
  }
  return out;
}

SectionFlow FrankSection::flow_of_these_panels(double wave_number) const {
  QS_CHECK(wave_number > 0.0);
  const PanelFlow fine = fine_.flow(wave_number);
  const PanelFlow coarse = coarse_.flow(wave_number);
  SectionFlow out;
  out.wave_number = wave_number;
  const auto added = [&](SectionMode k, SectionMode j) {
    return -extrapolated(fine.force[k][j].real(), coarse.force[k][j].real());
  };
  out.a22 = added(kSectionSway, kSectionSway);
  out.a44 = added(kSectionRoll, kSectionRoll);
  out.a33 = added(kSectionHeave, kSectionHeave);
  out.a24 = 0.5 * (added(kSectionSway, kSectionRoll) + added(kSectionRoll, kSectionSway));
  out.h2 = extrapolated(fine.h[kSectionSway], coarse.h[kSectionSway]);
  out.h4 = extrapolated(fine.h[kSectionRoll], coarse.h[kSectionRoll]);
  out.h3 = extrapolated(fine.h[kSectionHeave], coarse.h[kSectionHeave]);
  out.is_converged = agrees(fine, coarse, depth_);
  out.points = fine_.points();
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    for (std::size_t k = 0; k < kNumSectionModes; ++k) {
      out.points[i].phi[k] = fine.phi[k][i];
    }
  }
  return out;
}

}  // namespace quickstrip
