#include "core/sea/spectrum.hpp"

#include <array>
#include <cmath>

#include "core/base/constants.hpp"
#include "core/sea/quadrature.hpp"

namespace quickstrip {
namespace {

constexpr double kHeightMax = 60.0;
constexpr double kPeriodMax = 100.0;
constexpr double kPeakednessMax = 20.0;

// Widths of the JONSWAP peak, Hasselmann et al. 1973.
constexpr double kWidthBelow = 0.07;
constexpr double kWidthAbove = 0.09;

// Below this x every shape is less than exp(-700) of its peak.
constexpr double kShapeStart = 0.06;

double peak_exponent(double x) {
  const double width = x < 1.0 ? kWidthBelow : kWidthAbove;
  const double distance = (x - 1.0) / width;
  return std::exp(-0.5 * distance * distance);
}

double bretschneider_shape(double x) {
  const double x4 = x * x * x * x;
  return std::exp(-1.25 / x4) / (x4 * x);
}

double neumann_shape(double x) {
  const double x2 = x * x;
  return std::exp(-3.0 / x2) / (x2 * x2 * x2);
}

double shape_value(SpectrumShape shape, double gamma, double x) {
  if (!(x > kShapeStart)) {
    return 0.0;
  }
  switch (shape) {
    case SpectrumShape::kBretschneider:
      return bretschneider_shape(x);
    case SpectrumShape::kJonswap:
      return bretschneider_shape(x) * std::pow(gamma, peak_exponent(x));
    case SpectrumShape::kNeumann:
      return neumann_shape(x);
  }
  return 0.0;
}

// Integral of x^(n-5) exp(-5/4 x^-4) from 0 to infinity = 1/4 (5/4)^((n-4)/4) Gamma(1 - n/4).
double bretschneider_moment(int n) {
  const double order = static_cast<double>(n) / 4.0;
  return 0.25 * std::pow(1.25, order - 1.0) * std::tgamma(1.0 - order);
}

// Integral of x^(n-6) exp(-3 x^-2) from 0 to infinity = 1/2 3^((n-5)/2) Gamma((5-n)/2).
double neumann_moment(int n) {
  const double order = (5.0 - static_cast<double>(n)) / 2.0;
  return 0.5 * std::pow(3.0, -order) * std::tgamma(order);
}

// What gamma adds to the Bretschneider moment. The peak's Gaussian is below 1e-16 beyond 8.6 widths.
double jonswap_excess(double gamma, int n) {
  constexpr double kReach = 8.6;
  constexpr std::size_t kPanels = 32;
  const auto excess = [gamma, n](double x) {
    return std::pow(x, n) * bretschneider_shape(x) * (std::pow(gamma, peak_exponent(x)) - 1.0);
  };
  return integrate(1.0 - kReach * kWidthBelow, 1.0, kPanels, excess) +
         integrate(1.0, 1.0 + kReach * kWidthAbove, kPanels, excess);
}

Status check_peakedness(SpectrumShape shape, double gamma) {
  if (shape != SpectrumShape::kJonswap) {
    return {};
  }
  if (!std::isfinite(gamma)) {
    return Error::kNotFinite;
  }
  return gamma >= 1.0 && gamma <= kPeakednessMax ? Status{} : Status{Error::kOutOfRange};
}

}  // namespace

double shape_moment(SpectrumShape shape, double gamma, int n) {
  switch (shape) {
    case SpectrumShape::kBretschneider:
      return bretschneider_moment(n);
    case SpectrumShape::kJonswap:
      return bretschneider_moment(n) + jonswap_excess(gamma, n);
    case SpectrumShape::kNeumann:
      return neumann_moment(n);
  }
  return 0.0;
}

Result<double> period_over_peak_period(SpectrumShape shape, double gamma, PeriodKind kind) {
  if (const Status fit = check_peakedness(shape, gamma); !fit) {
    return fit.error();
  }
  switch (kind) {
    case PeriodKind::kPeak:
      return 1.0;
    case PeriodKind::kMean:  // T1 = 2 pi m0 / m1
      return shape_moment(shape, gamma, 0) / shape_moment(shape, gamma, 1);
    case PeriodKind::kZeroCrossing:  // T2 = 2 pi sqrt(m0 / m2)
      return std::sqrt(shape_moment(shape, gamma, 0) / shape_moment(shape, gamma, 2));
  }
  return Error::kOutOfRange;
}

Result<Spectrum> spectrum_of(const WaveSystem& system) {
  if (!std::isfinite(system.hs) || !std::isfinite(system.period)) {
    return Error::kNotFinite;
  }
  if (!(system.hs > 0.0 && system.hs <= kHeightMax && system.period > 0.0 && system.period <= kPeriodMax)) {
    return Error::kOutOfRange;
  }
  const Result<double> ratio = period_over_peak_period(system.shape, system.peakedness, system.period_kind);
  if (!ratio) {
    return ratio.error();
  }
  Spectrum spectrum;
  spectrum.shape = system.shape;
  spectrum.m0 = system.hs * system.hs / 16.0;
  spectrum.peak_frequency = kTwoPi * *ratio / system.period;
  spectrum.peakedness = system.shape == SpectrumShape::kJonswap ? system.peakedness : 1.0;
  spectrum.shape_moment = shape_moment(system.shape, spectrum.peakedness, 0);
  return spectrum;
}

double density(const Spectrum& spectrum, double omega) {
  const double x = omega / spectrum.peak_frequency;
  return spectrum.m0 / (spectrum.peak_frequency * spectrum.shape_moment) *
         shape_value(spectrum.shape, spectrum.peakedness, x);
}

}  // namespace quickstrip
