#include "core/sea/spectrum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/constants.hpp"
#include "core/sea/moments.hpp"

namespace quickstrip {
namespace {

constexpr std::array kShapes = {SpectrumShape::kBretschneider, SpectrumShape::kJonswap,
                                SpectrumShape::kNeumann};
constexpr std::array kKinds = {PeriodKind::kPeak, PeriodKind::kMean, PeriodKind::kZeroCrossing};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

WaveSystem system_of(SpectrumShape shape, double hs, double period, PeriodKind kind, double gamma = 3.3) {
  WaveSystem system;
  system.shape = shape;
  system.hs = hs;
  system.period = period;
  system.period_kind = kind;
  system.peakedness = gamma;
  return system;
}

Spectrum spectrum(SpectrumShape shape, double hs, double period, PeriodKind kind, double gamma = 3.3) {
  return *spectrum_of(system_of(shape, hs, period, kind, gamma));
}

TEST(Spectrum, HeightIsFourRootsOfTheZerothMoment) {
  for (const SpectrumShape shape : kShapes) {
    for (const PeriodKind kind : kKinds) {
      const Spectrum s = spectrum(shape, 4.0, 8.0, kind);
      // Numerically, not by the closed form: 1e-6 is the tail above 60 omega_p, (5/4) / 60^4 and less.
      EXPECT_NEAR(significant_wave_height(moment_between(s, 0, 0.0, 60.0 * s.peak_frequency)), 4.0, 1e-6);
    }
  }
}

// Each period is read back from numerical moments. m2's tail above X omega_p is 2.5 / X^2 of it, 2.8e-7 at
// 3000 (Bretschneider, JONSWAP; Neumann 1/X^3).
TEST(Spectrum, KeepsThePeriodThatWasGiven) {
  for (const SpectrumShape shape : kShapes) {
    const Spectrum by_mean = spectrum(shape, 4.0, 8.0, PeriodKind::kMean);
    const Spectrum by_zero = spectrum(shape, 4.0, 8.0, PeriodKind::kZeroCrossing);
    const auto numeric = [](const Spectrum& s, int n) {
      return moment_between(s, n, 0.0, 3000.0 * s.peak_frequency);
    };
    EXPECT_NEAR(mean_period(numeric(by_mean, 0), numeric(by_mean, 1)), 8.0, 1e-6);
    EXPECT_NEAR(zero_crossing_period(numeric(by_zero, 0), numeric(by_zero, 2)), 8.0, 3e-6);
    EXPECT_NEAR(mean_period(moment(by_mean, 0), moment(by_mean, 1)), 8.0, 1e-12);
    EXPECT_NEAR(zero_crossing_period(moment(by_zero, 0), moment(by_zero, 2)), 8.0, 1e-12);
  }
}

TEST(Spectrum, PeakLiesAtThePeakPeriod) {
  for (const SpectrumShape shape : kShapes) {
    const Spectrum s = spectrum(shape, 2.0, 11.0, PeriodKind::kPeak);
    const double peak = density(s, kTwoPi / 11.0);
    EXPECT_GT(peak, density(s, 1.001 * kTwoPi / 11.0));
    EXPECT_GT(peak, density(s, 0.999 * kTwoPi / 11.0));
  }
}

// T1 = 0.772 Tp = 1.086 T2 as commonly printed; T2/Tp = (1.25 pi)^(-1/4).
TEST(Bretschneider, PeriodRatiosAreTheClosedOnes) {
  const double t1 = *period_over_peak_period(SpectrumShape::kBretschneider, 1.0, PeriodKind::kMean);
  const double t2 = *period_over_peak_period(SpectrumShape::kBretschneider, 1.0, PeriodKind::kZeroCrossing);
  EXPECT_NEAR(t2, std::pow(1.25 * kPi, -0.25), 1e-14);
  EXPECT_NEAR(t1, 0.772, 5e-4);       // three printed digits
  EXPECT_NEAR(t1 / t2, 1.086, 5e-4);  // the same
}

// S = 172.8 H^2 T1^-4 omega^-5 exp(-691.2 T1^-4 omega^-4): constants of four digits, exponent up to 3.
TEST(Bretschneider, IsTheFormulaOfTheIttcByMeanPeriod) {
  const double h = 4.0;
  const double t1 = 8.0;
  const Spectrum s = spectrum(SpectrumShape::kBretschneider, h, t1, PeriodKind::kMean);
  for (const double omega : {0.45, 0.6, 0.8, 1.2, 2.0}) {
    const double q = 1.0 / std::pow(t1 * omega, 4);
    const double printed = 172.8 * h * h / std::pow(t1, 4) * std::pow(omega, -5) * std::exp(-691.2 * q);
    EXPECT_NEAR(density(s, omega), printed, 2e-3 * printed);
  }
}

// The share of m0 below omega is exp(-1.25 (omega_p / omega)^4).
TEST(Bretschneider, ZerothMomentBelowAFrequencyIsTheClosedOne) {
  const Spectrum s = spectrum(SpectrumShape::kBretschneider, 3.0, 9.0, PeriodKind::kPeak);
  for (const double x : {0.7, 1.0, 1.5, 4.0}) {
    const double closed = s.m0 * std::exp(-1.25 / std::pow(x, 4));
    EXPECT_NEAR(moment_between(s, 0, 0.0, x * s.peak_frequency), closed, 1e-9 * s.m0);
  }
}

// S = 3832 H^2 T1^-5 omega^-6 exp(-69.8 T1^-2 omega^-2), T1 (not T2): [Journee1992] §4, constants of 3
// digits.
TEST(Neumann, IsTheFormulaByMeanPeriod) {
  const double h = 4.0;
  const double t1 = 8.0;
  const Spectrum s = spectrum(SpectrumShape::kNeumann, h, t1, PeriodKind::kMean);
  for (const double omega : {0.45, 0.6, 0.8, 1.2, 2.0}) {
    const double printed =
        3832.0 * h * h / std::pow(t1, 5) * std::pow(omega, -6) * std::exp(-69.8 / (t1 * t1 * omega * omega));
    EXPECT_NEAR(density(s, omega), printed, 5e-3 * printed);
  }
  const double t1_over_t2 = *period_over_peak_period(SpectrumShape::kNeumann, 1.0, PeriodKind::kMean) /
                            *period_over_peak_period(SpectrumShape::kNeumann, 1.0, PeriodKind::kZeroCrossing);
  EXPECT_NEAR(t1_over_t2, 1.085, 5e-4);
}

// Published ratios are of spectra cut at 20 omega_p; four printed digits. A_gamma is the peak's normalising
// factor: the Bretschneider's zeroth moment over that of JONSWAP.
TEST(Jonswap, PeriodRatiosAreThoseOfTheTable) {
  struct Row {
    double gamma, normalising, t1, t2;
  };
  constexpr std::array<Row, 5> kTable = {{{1.0, 1.0000, 0.7719, 0.7115},
                                          {2.0, 0.8028, 0.8064, 0.7475},
                                          {3.3, 0.6558, 0.8344, 0.7784},
                                          {5.0, 0.5381, 0.8584, 0.8062},
                                          {7.0, 0.4494, 0.8775, 0.8293}}};
  for (const Row& row : kTable) {
    const Spectrum s = spectrum(SpectrumShape::kJonswap, 4.0, kTwoPi, PeriodKind::kPeak, row.gamma);
    const auto cut = [&s](int n) { return moment_between(s, n, 0.05, 20.0); };
    EXPECT_NEAR(0.2 / s.shape_moment, row.normalising, 6e-5) << row.gamma;
    EXPECT_NEAR(cut(0) / cut(1), row.t1, 6e-5) << row.gamma;
    EXPECT_NEAR(std::sqrt(cut(0) / cut(2)), row.t2, 6e-5) << row.gamma;
    // The whole tail: T1 within 2e-4, T2 shorter by up to 2e-3.
    EXPECT_NEAR(*period_over_peak_period(SpectrumShape::kJonswap, row.gamma, PeriodKind::kMean), row.t1,
                2e-4);
    EXPECT_NEAR(*period_over_peak_period(SpectrumShape::kJonswap, row.gamma, PeriodKind::kZeroCrossing),
                row.t2, 2e-3);
  }
}

TEST(Jonswap, OfPeakednessOneIsBretschneider) {
  const Spectrum j = spectrum(SpectrumShape::kJonswap, 3.0, 7.0, PeriodKind::kMean, 1.0);
  const Spectrum b = spectrum(SpectrumShape::kBretschneider, 3.0, 7.0, PeriodKind::kMean);
  for (const double omega : {0.4, 0.7, 1.0, 3.0}) {
    EXPECT_NEAR(density(j, omega), density(b, omega), 1e-13);
  }
}

TEST(Jonswap, PeakIsHigherByPeakednessAndNormalisingFactor) {
  const Spectrum j = spectrum(SpectrumShape::kJonswap, 3.0, 10.0, PeriodKind::kPeak, 3.3);
  const Spectrum b = spectrum(SpectrumShape::kBretschneider, 3.0, 10.0, PeriodKind::kPeak);
  EXPECT_NEAR(density(j, kTwoPi / 10.0) / density(b, kTwoPi / 10.0), 3.3 * 0.6558, 3e-4);  // four digits
}

// Lengths times lambda, times times sqrt(lambda): S [m2 s] times lambda^2.5.
TEST(Spectrum, ScalesByFroude) {
  const double scale = 49.0;
  for (const SpectrumShape shape : kShapes) {
    const Spectrum full = spectrum(shape, 4.9, 8.4, PeriodKind::kMean);
    const Spectrum model = spectrum(shape, 0.1, 1.2, PeriodKind::kMean);
    for (const double omega : {0.5, 0.8, 1.1}) {
      EXPECT_NEAR(density(model, 7.0 * omega) * std::pow(scale, 2.5) / density(full, omega), 1.0, 1e-12);
    }
  }
}

TEST(Spectrum, IsZeroAtAndBelowZeroFrequency) {
  for (const SpectrumShape shape : kShapes) {
    const Spectrum s = spectrum(shape, 4.0, 8.0, PeriodKind::kPeak);
    EXPECT_EQ(density(s, 0.0), 0.0);
    EXPECT_EQ(density(s, -0.5), 0.0);
    EXPECT_EQ(density(s, 1e-300), 0.0);
  }
}

TEST(Spectrum, RefusesWhatIsNoSea) {
  const auto error = [](double hs, double period, double gamma) {
    return spectrum_of(system_of(SpectrumShape::kJonswap, hs, period, PeriodKind::kMean, gamma)).error();
  };
  EXPECT_EQ(error(kNaN, 8, 3.3), Error::kNotFinite);
  EXPECT_EQ(error(4, kNaN, 3.3), Error::kNotFinite);
  EXPECT_EQ(error(4, 8, kNaN), Error::kNotFinite);
  EXPECT_EQ(error(std::numeric_limits<double>::infinity(), 8, 3.3), Error::kNotFinite);
  EXPECT_EQ(error(-4, 8, 3.3), Error::kOutOfRange);
  EXPECT_EQ(error(0, 8, 3.3), Error::kOutOfRange);
  EXPECT_EQ(error(4, 0, 3.3), Error::kOutOfRange);
  EXPECT_EQ(error(4, -8, 3.3), Error::kOutOfRange);
  EXPECT_EQ(error(4, 8, 0.5), Error::kOutOfRange);
  EXPECT_EQ(error(4, 8, 3.3), Error::kNone);
}

// Half hats at the ends: the sum is what lies between the end nodes, known in closed form.
TEST(HatEnergies, SumToTheClosedZerothMomentBetweenTheNodes) {
  const Spectrum s = spectrum(SpectrumShape::kBretschneider, 4.0, 9.0, PeriodKind::kPeak);
  std::vector<double> omega;
  for (int i = 0; i < 30; ++i) {
    omega.push_back(0.3 + 0.06 * i);
  }
  std::vector<double> energy(omega.size());
  hat_energies(s, omega, energy);
  double sum = 0.0;
  for (const double e : energy) {
    sum += e;
  }
  const auto below = [&s](double w) { return s.m0 * std::exp(-1.25 * std::pow(s.peak_frequency / w, 4)); };
  EXPECT_NEAR(sum, below(omega.back()) - below(omega.front()), 1e-9 * s.m0);
}

// Exact for responses that are linear between nodes: omega itself gives m1, whatever the nodes.
TEST(HatEnergies, GiveTheFirstMomentExactlyOnTheCoarsestGrid) {
  for (const SpectrumShape shape : kShapes) {
    const Spectrum s = spectrum(shape, 4.0, 9.0, PeriodKind::kPeak);
    const std::array<double, 3> omega = {0.25, 0.9, 2.5};
    std::array<double, 3> energy{};
    hat_energies(s, omega, energy);
    const double m1 = omega[0] * energy[0] + omega[1] * energy[1] + omega[2] * energy[2];
    EXPECT_NEAR(m1, moment_between(s, 1, omega[0], omega[2]), 1e-8 * m1);
  }
}

}  // namespace
}  // namespace quickstrip
