// Sections mapped with more coefficients than Lewis forms: the multipoles do what they must, and the solution
// tends to the closed forms of the double body.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <initializer_list>
#include <random>

#include "core/base/constants.hpp"
#include "sim/section_table/conformal_mapping.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

MappingCoefficients mapping(std::initializer_list<double> values) {
  MappingCoefficients a;
  for (const double value : values) {
    EXPECT_TRUE(a.push_back(value));
  }
  return a;
}

// A full midship with a knuckle, a fine section, a flare with a flat, a bulbous one; 3 ... 10 coefficients.
std::vector<MappingCoefficients> forms() {
  return {mapping({0.13, -0.09, 0.02}), mapping({-0.30, 0.05, 0.03, -0.012}),
          mapping({0.35, 0.02, -0.03, 0.01, 0.006}), mapping({-0.25, -0.15, 0.02, 0.01}),
          mapping({0.10, -0.08, 0.03, 0.012, -0.008, 0.005, 0.003, -0.002, 0.0015, 0.001})};
}

// Off the hull, written out anew: w(Z).
Complex position(const MappingCoefficients& a, Complex z) {
  Complex w = z;
  for (std::size_t n = 1; n <= a.size(); ++n) {
    w += (n % 2 == 0 ? a[n - 1] : -a[n - 1]) * std::pow(z, -(2 * static_cast<int>(n) - 1));
  }
  return -w;
}

// A multipole as a function of Z with the amplitudes that the equations take for the hull.
Complex multipole(const SectionHarmonics& section, std::size_t p, double kappa, Complex z) {
  Complex g = std::pow(z, -static_cast<int>(p));
  for (std::size_t k = 0; k < section.chain_length(); ++k) {
    const auto q = static_cast<int>(p - 1 + 2 * k);
    g += kappa * section.chain(k) / q * std::pow(z, -q);
  }
  return g;
}

TEST(MappedSection, MultipolesMeetTheFreeSurfaceCondition) {
  constexpr double kappa = 0.7;
  constexpr double step = 1e-4;
  for (const MappingCoefficients& a : forms()) {
    const SectionHarmonics section(a);
    for (const std::size_t p : {2U, 3U, 6U, 7U}) {
      for (const double radius : {1.1, 1.7}) {
        const Complex z(0.0, -radius);
        const Complex dz(0.0, step);
        // dG/dw along the free surface: of the real part (heave, even p) or the imaginary one (sway, odd p)
        const Complex slope = (multipole(section, p, kappa, z + dz) - multipole(section, p, kappa, z - dz)) /
                              (position(a, z + dz) - position(a, z - dz));
        const Complex rest = slope - kappa * multipole(section, p, kappa, z);
        // Central differences: error step^2.
        EXPECT_NEAR(p % 2 == 0 ? rest.real() : rest.imag(), 0.0, 1e-6) << p;
      }
    }
  }
}

TEST(MappedSection, CouplingIsThatOfTheMultipolesOnTheHull) {
  // -int phi_i dpsi_j/dtheta by quadrature, psi the conjugate function; symmetric although not built so.
  constexpr double kappa = 0.7;
  const ContourQuadrature rule(120);
  for (const MappingCoefficients& a : forms()) {
    SectionHarmonics section(a);
    section.keep(4);  // some kept, some not
    for (const Symmetry symmetry : {Symmetry::kHeave, Symmetry::kSwayRoll}) {
      const bool heave = symmetry == Symmetry::kHeave;
      for (std::size_t i = 1; i <= 6; ++i) {
        for (std::size_t j = 1; j <= i; ++j) {
          double total = 0.0;
          double transposed = 0.0;
          for (std::size_t n = 0; n < rule.size(); ++n) {
            const auto phi = [&](std::size_t m, double theta) {
              const Complex g =
                  multipole(section, multipole_frequency(symmetry, m), kappa, std::polar(1.0, -theta));
              return heave ? std::array{g.real(), g.imag()} : std::array{g.imag(), -g.real()};
            };
            const auto psi_slope = [&](std::size_t m, double theta) {
              return (phi(m, theta + 1e-5)[1] - phi(m, theta - 1e-5)[1]) / 2e-5;
            };
            const double theta = rule.theta(n);
            total -= rule.weight(n) * phi(i, theta)[0] * psi_slope(j, theta);
            transposed -= rule.weight(n) * phi(j, theta)[0] * psi_slope(i, theta);
          }
          EXPECT_NEAR(section.coupling(symmetry, kappa, i, j), total, 1e-7);  // of the differences
          EXPECT_NEAR(total, transposed, 1e-7);
        }
      }
    }
  }
}

TEST(MappedSection, AreaAndNormalsAreThoseOfTheContour) {
  for (const MappingCoefficients& a : forms()) {
    const SectionHarmonics section(a);
    const ContourQuadrature rule(60);
    double by_quadrature = 0.0;
    for (std::size_t j = 0; j < rule.size(); ++j) {
      const double theta = rule.theta(j);
      const MappedPoint at = mapped_point(a, theta);
      const MappedPoint next = mapped_point(a, theta + 1e-6);
      const MappedPoint last = mapped_point(a, theta - 1e-6);
      EXPECT_NEAR(std::abs((next.w - last.w) / 2e-6 - at.slope), 0.0, 1e-8);
      by_quadrature += 2.0 * rule.weight(j) * at.w.imag() * at.slope.real();
      const auto sum = [theta](const ModeNormal& normal, auto shape) {
        double total = 0.0;
        for (std::size_t n = 0; n < normal.amplitude.size(); ++n) {
          total += normal.amplitude[n] * shape(static_cast<double>(normal.first + 2 * n) * theta);
        }
        return total;
      };
      const auto sine = [](double u) { return std::sin(u); };
      EXPECT_NEAR(sum(section.sway(), sine), at.slope.real(), 1e-12);
      EXPECT_NEAR(sum(section.heave(), [](double u) { return std::cos(u); }), -at.slope.imag(), 1e-12);
      EXPECT_NEAR(sum(section.roll(), sine), -(at.w.imag() * at.slope.imag() + at.w.real() * at.slope.real()),
                  1e-12);
    }
    EXPECT_NEAR(by_quadrature, mapped_area(a), 1e-10);
    EXPECT_NEAR(mapped_point(a, 0.5 * kPi).w.imag(), mapped_half_breadth(a), 1e-12);
    EXPECT_NEAR(mapped_point(a, 0.0).w.real(), -mapped_draught(a), 1e-12);
  }
}

double odd(std::size_t n) {
  return 2.0 * static_cast<double>(n) - 1.0;
}

TEST(MappedSection, TendsToTheClosedFormsAtInfiniteFrequency) {
  constexpr double kappa = 500.0;  // departs by about 1/kappa, with logarithms: under 1 %
  for (const MappingCoefficients& a : forms()) {
    const SectionSolution s = MultipoleSection(a).solve(kappa, 256);
    // The potential vanishes at the surface: psi = y continued by cos (2n-1) theta; roll by sin 2 s theta.
    double a33 = (1.0 + a[0]) * (1.0 + a[0]);
    for (std::size_t n = 2; n <= a.size(); ++n) {
      a33 += odd(n) * a[n - 1] * a[n - 1];
    }
    a33 *= 0.5 * kPi;
    const auto g = radius_harmonics(a);
    double a44 = 0.0;
    for (std::size_t n = 1; n <= a.size(); ++n) {
      a44 += kPi * static_cast<double>(n) * g[n - 1] * g[n - 1];
    }
    EXPECT_NEAR(s.a33, a33, 0.01 * a33);
    EXPECT_NEAR(s.a44, a44, 0.01 * (a44 + 0.1));
  }
}

TEST(MappedSection, TendsToTheClosedFormsInLongWaves) {
  constexpr double kappa = 1e-5;  // departs by about kappa ln kappa, 1e-4
  for (const MappingCoefficients& a : forms()) {
    const SectionSolution s = MultipoleSection(a).solve(kappa, 96);
    // Sway below a rigid surface: psi = -z continued by sin (2n-1) theta.
    double a22 = (1.0 - a[0]) * (1.0 - a[0]);
    for (std::size_t n = 2; n <= a.size(); ++n) {
      a22 += odd(n) * a[n - 1] * a[n - 1];
    }
    a22 *= 0.5 * kPi;
    EXPECT_NEAR(s.a22, a22, 2e-4 * a22);
    // The dipole far away is that of the displaced water and the added mass; a source sees the waterplane.
    EXPECT_NEAR(s.h2 / kappa, mapped_area(a) + a22, 3e-4 * (mapped_area(a) + a22));
    EXPECT_NEAR(s.h3, 2.0 * mapped_half_breadth(a), 2e-4 * s.h3);
    // ... and D4 = A zbar - B^3/12 + a24
    const ContourQuadrature rule(60);
    double moment = 0.0;  // of the area about the waterline, both sides
    for (std::size_t j = 0; j < rule.size(); ++j) {
      const MappedPoint at = mapped_point(a, rule.theta(j));
      moment -= 2.0 * rule.weight(j) * at.w.real() * at.w.imag() * at.slope.real();
    }
    const double breadth = 2.0 * mapped_half_breadth(a);
    const double d4 = moment - breadth * breadth * breadth / 12.0 + s.a24;
    EXPECT_NEAR(s.h4 / kappa, d4, 3e-4 * (std::abs(d4) + 0.1));
  }
}

TEST(MappedSection, FarFieldEnergyEqualsTheDampingByPressure) {
  for (const MappingCoefficients& a : forms()) {
    MultipoleSection section(a);
    for (const double kappa : {0.02, 0.3, 1.0, 3.0}) {
      const SectionSolution s = section.solve(kappa, 96);
      // The far field converges at the root of the pressure's rate.
      EXPECT_NEAR(s.far_field3 * s.far_field3, s.damping33, 3e-4 * s.damping33 + 1e-6);
      EXPECT_NEAR(s.far_field2 * s.far_field2, s.damping22, 3e-4 * s.damping22 + 1e-6);
      EXPECT_NEAR(s.far_field4 * s.far_field4, s.damping44, 3e-4 * s.damping44 + 1e-6);
    }
  }
}

TEST(MappedSection, MoreCoefficientsThatAreZeroChangeNothing) {
  const SectionSolution lewis = solve_lewis_form(0.13, -0.10, 0.6, 48);
  const SectionSolution ten = MultipoleSection(mapping({0.13, -0.10, 0, 0, 0, 0, 0, 0, 0, 0})).solve(0.6, 48);
  EXPECT_NEAR(ten.a33, lewis.a33, 1e-12);
  EXPECT_NEAR(ten.h2, lewis.h2, 1e-12);
  EXPECT_NEAR(ten.h4, lewis.h4, 1e-12);
}

TEST(ConformalMapping, KnowsWhetherItsSlopeVanishesOutsideTheCircle) {
  // Against the winding of dw/dZ along the circle: the zeros outside are as many as it lacks.
  std::mt19937 seeded(3);
  int conformal = 0;
  for (int trial = 0; trial < 400; ++trial) {
    MappingCoefficients a;
    for (int n = 1; n <= 5; ++n) {
      const double uniform = static_cast<double>(seeded()) / 4294967296.0 - 0.5;
      EXPECT_TRUE(a.push_back(1.2 * uniform / (2 * n - 1)));
    }
    double winding = 0.0;
    Complex before(1.0, 0.0);
    for (int k = 0; k <= 4000; ++k) {
      const Complex u = std::polar(1.0, 2.0 * kPi * k / 4000.0);
      Complex p = 1.0;
      for (std::size_t n = 1; n <= a.size(); ++n) {
        p -= odd(n) * (n % 2 == 0 ? a[n - 1] : -a[n - 1]) * std::pow(u, static_cast<int>(n));
      }
      winding += k == 0 ? 0.0 : std::arg(p / before);
      before = p;
    }
    conformal += is_conformal(a) ? 1 : 0;
    EXPECT_EQ(is_conformal(a), std::abs(winding) < 0.1) << trial;
  }
  EXPECT_GT(conformal, 40);
  EXPECT_LT(conformal, 360);
}

}  // namespace
}  // namespace quickstrip
