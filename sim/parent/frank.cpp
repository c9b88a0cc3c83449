#include "sim/parent/frank.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "sim/parent/panels.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

double extrapolated(double fine, double coarse) {
  return fine + (fine - coarse) / 3.0;
}

}  // namespace

FrankSection::FrankSection(const SectionContour& contour, const FrankOptions& options)
    : fine_(panel_ends(contour, options.num_panels),
            options.removes_irregular_frequencies ? interior_points(contour) : std::vector<Complex>{}),
      coarse_(coarsened(panel_ends(contour, options.num_panels)),
              options.removes_irregular_frequencies ? interior_points(contour) : std::vector<Complex>{}) {}

SectionFlow FrankSection::flow(double wave_number) const {
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
  out.points = fine_.points();
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    for (std::size_t k = 0; k < kNumSectionModes; ++k) {
      out.points[i].phi[k] = fine.phi[k][i];
    }
  }
  return out;
}

}  // namespace quickstrip
