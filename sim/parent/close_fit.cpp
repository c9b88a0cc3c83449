#include "sim/parent/close_fit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "sim/parent/mapping_fit.hpp"

namespace quickstrip {
namespace {

constexpr double kLeastH0 = 0.05;
constexpr double kMostH0 = 20.0;
constexpr int kCurvePoints = 120;

double distance_to_contour(const SectionContour& contour, Offset p) {
  double nearest = INFINITY;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    const Offset& a = contour.points[i - 1];
    const Offset& b = contour.points[i];
    const double dy = b.y - a.y;
    const double dz = b.z - a.z;
    const double along = ((p.y - a.y) * dy + (p.z - a.z) * dz) / (dy * dy + dz * dz);
    const double t = std::clamp(along, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(p.y - a.y - t * dy, p.z - a.z - t * dz));
  }
  return nearest;
}

std::vector<Offset> mapped_contour(const CloseFit& fit) {
  std::vector<Offset> points;
  for (int j = 0; j <= kCurvePoints; ++j) {
    const std::complex<double> w = fit.scale * mapped_point(fit.a, 0.5 * kPi * j / kCurvePoints).w;
    points.push_back({w.imag(), w.real()});
  }
  points.front().y = 0.0;  // of rounding
  points.back().z = 0.0;
  return points;
}

// Conformal, and a contour that a section can have.
bool has_flow(const CloseFit& fit) {
  if (!is_conformal(fit.a)) {
    return false;
  }
  try {
    static_cast<void>(section_contour(mapped_contour(fit)));
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

CloseFit fit_of(const MappingFit& mapping, const SectionContour& contour) {
  CloseFit fit;
  fit.scale = mapping.powers[0];
  for (std::size_t n = 1; n <= mapping.num_coefficients; ++n) {
    QS_CHECK(fit.a.push_back((n % 2 == 1 ? -1.0 : 1.0) * mapping.powers[n] / fit.scale));
  }
  fit.rms_error = mapping.rms_error;
  fit.largest_error = mapping.largest_error;
  for (const Offset& p : mapped_contour(fit)) {
    fit.largest_error = std::max(fit.largest_error, distance_to_contour(contour, p));
  }
  fit.area_error = fit.scale * fit.scale * mapped_area(fit.a) / area(contour) - 1.0;
  return fit;
}

std::string why_not(const CloseFit& fit, const SectionContour& contour) {
  const double h0 = contour.half_breadth() / contour.draught();
  if (!(h0 >= kLeastH0)) {
    return "thinner than a twentieth of its draught";
  }
  if (!(h0 <= kMostH0)) {
    return "draught less than a fortieth of its breadth";
  }
  if (fit.a.empty()) {
    return "no conformal mapping";
  }
  const double scale = error_scale(contour);
  if (fit.rms_error > kConventionalRmsError * scale ||
      fit.largest_error > kConventionalLargestError * scale) {
    return "contour not met";
  }
  return "";
}

}  // namespace

CloseFit close_fit(const SectionContour& contour, int num_coefficients) {
  QS_CHECK(num_coefficients >= kLeastMappingCoefficients &&
           num_coefficients <= static_cast<int>(kMaxMappingCoefficients));
  CloseFit best;
  if (contour.is_submerged()) {
    best.reason = "wholly submerged";
    return best;
  }
  MappingFitter fitter(contour);
  std::vector<MappingFit> fits;
  for (int n = 1; n <= num_coefficients; ++n) {
    fits.push_back(fitter.next());
  }
  for (auto fit = fits.rbegin(); fit + 1 != fits.rend() && best.a.empty(); ++fit) {
    const CloseFit tried = fit_of(*fit, contour);
    if (has_flow(tried)) {
      best = tried;
    }
  }
  best.reason = why_not(best, contour);
  best.is_conventional = best.reason.empty();
  return best;
}

double error_scale(const SectionContour& contour) {
  return std::sqrt(contour.half_breadth() * contour.draught());
}

MappedSection mapped_section(const CloseFit& fit) {
  return {fit.a, fit.scale};
}

SectionFlow close_fit_flow(const CloseFit& fit, double wave_number) {
  return mapped_section(fit).flow(wave_number);
}

}  // namespace quickstrip
