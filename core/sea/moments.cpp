#include "core/sea/moments.hpp"

#include <algorithm>
#include <cstddef>

#include "core/base/check.hpp"
#include "core/base/legendre.hpp"
#include "core/sea/quadrature.hpp"

namespace quickstrip {
namespace {

// Five points on a twentieth of the peak frequency resolve the narrowest thing there is: the low-frequency
// side of a JONSWAP peak, 0.07 omega_p wide.
constexpr double kPanelWidth = 0.05;
constexpr std::size_t kMaxPanelsOfInterval = 64;
constexpr std::size_t kMaxPanelsOfMoment = 4096;

std::size_t num_panels(const Spectrum& spectrum, double from, double to) {
  const double width = kPanelWidth * std::max(spectrum.peak_frequency, from);
  const double count = std::ceil((to - from) / width);
  return static_cast<std::size_t>(std::clamp(count, 1.0, static_cast<double>(kMaxPanelsOfInterval)));
}

}  // namespace

double moment(const Spectrum& spectrum, int n) {
  return spectrum.m0 * std::pow(spectrum.peak_frequency, n) *
         shape_moment(spectrum.shape, spectrum.peakedness, n) / spectrum.shape_moment;
}

double moment_between(const Spectrum& spectrum, int n, double from, double to) {
  double sum = 0.0;
  double left = from;
  for (std::size_t p = 0; p < kMaxPanelsOfMoment && left < to; ++p) {
    // The peak is a panel's end: JONSWAP's width jumps there.
    const double peak = spectrum.peak_frequency;
    const double next = left + kPanelWidth * std::max(peak, left);
    const double right = std::min(to, left < peak && next > peak ? peak : next);
    sum += integrate(left, right, 1,
                     [&](double omega) { return std::pow(omega, n) * density(spectrum, omega); });
    left = right;
  }
  return sum;
}

void hat_energies(const Spectrum& spectrum, std::span<const double> omega, std::span<double> energy) {
  QS_CHECK(omega.size() == energy.size());
  std::fill(energy.begin(), energy.end(), 0.0);
  const auto add = [&](std::size_t i, double from, double to) {
    if (!(from < to)) {
      return;
    }
    const double width = omega[i + 1] - omega[i];
    for_each_gauss_point(from, to, num_panels(spectrum, from, to), [&](double w, double weight) {
      const double part = weight * density(spectrum, w);
      const double share = (w - omega[i]) / width;
      energy[i] += part * (1.0 - share);
      energy[i + 1] += part * share;
    });
  };
  for (std::size_t i = 0; i + 1 < omega.size(); ++i) {
    const double peak = std::clamp(spectrum.peak_frequency, omega[i], omega[i + 1]);
    add(i, omega[i], peak);
    add(i, peak, omega[i + 1]);
  }
}

DensityTerms density_terms(const Spectrum& spectrum, double from, double to) {
  DensityTerms terms{};
  const auto add = [&](double left, double right) {
    if (!(left < right)) {
      return;
    }
    for_each_gauss_point(left, right, num_panels(spectrum, left, right), [&](double w, double weight) {
      const auto p = legendre((w - from) / (to - from));
      const double part = weight * density(spectrum, w);
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        terms[l] += part * p[l];
      }
    });
  };
  const double peak = std::clamp(spectrum.peak_frequency, from, to);
  add(from, peak);
  add(peak, to);
  for (std::size_t l = 0; l < kDensityTerms; ++l) {
    terms[l] *= static_cast<double>(2 * l + 1) / (to - from);
  }
  return terms;
}

}  // namespace quickstrip
