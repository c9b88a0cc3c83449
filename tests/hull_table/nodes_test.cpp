// Between the nodes of frequency and direction: what the table gives at one station against its own flow
// solved there.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/hull_table/table_section.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"
#include "sim/parent/true_section.hpp"
#include "tests/hull_table/compiled.hpp"

namespace quickstrip::test {
namespace {

using Complex = std::complex<double>;

// Cubic in ln K on these nodes: measured 0.19 % of a24's greatest value, 0.18 % of a22's, others less.
constexpr double kOscillation = 2.5e-3;
// Cubic in the logarithm and in sin^2 mu: measured 0.07 % in sway, for waves longer than 1.16 breadths. In
// shorter ones sway grows to 1 % at 0.75 breadths and 6 % at half a breadth, which move no ship.
constexpr double kWaves = 1e-3;
constexpr double kShortestWave = 2.7;  // of K B/2

class Nodes : public testing::Test {
 protected:
  static constexpr std::size_t kStation = 2;  // of the thinned hull: a full section forward of the stern
  static constexpr double kLevel = 9.5;

  [[nodiscard]] LevelStencil stencil() const { return table_.view.level_stencil(kStation, kLevel); }
  [[nodiscard]] SectionFlow flow(double k) const { return section_.flow(k); }

  std::unique_ptr<Hull> hull_ = thinned_s175(8);
  Compiled table_{*hull_, HullSections::kCloseFit, {{kLevel}, {}}};
  TrueSection section_{section_contour(*cut_station(*hull_, kStation, kLevel)), SectionMethod::kCloseFit};
  TableNodes nodes_ = table_nodes(*hull_);
};

TEST_F(Nodes, OscillationsBetweenFrequenciesAreThoseOfTheFlow) {
  OscillationValues greatest{};
  OscillationValues difference{};
  for (std::size_t i = 0; i + 1 < kHullTableOscillations; ++i) {
    const double k = std::sqrt(nodes_.oscillation[i] * nodes_.oscillation[i + 1]);
    if (k > nodes_.highest_met) {
      break;
    }
    const SectionFlow own = flow(k);
    const OscillationValues wanted = {own.a33, own.h3, own.a22, own.a24, own.a44, own.h2, own.h4};
    const OscillationValues got = table_.view.oscillation(stencil(), k);
    for (std::size_t q = 0; q < wanted.size(); ++q) {
      greatest[q] = std::max(greatest[q], std::fabs(wanted[q]));
      difference[q] = std::max(difference[q], std::fabs(got[q] - wanted[q]));
    }
  }
  for (std::size_t q = 0; q < greatest.size(); ++q) {
    std::printf("quantity %zu: %.3f %%\n", q, 100.0 * difference[q] / greatest[q]);
    EXPECT_LT(difference[q], kOscillation * greatest[q]) << "quantity " << q;
  }
}

TEST_F(Nodes, WavesBetweenFrequenciesAndDirectionsAreThoseOfTheFlow) {
  HullTable::WaveFactors factors{};
  const double half_breadth = 0.5 * cut_station(*hull_, kStation, kLevel)->breadth;
  double worst = 0.0;
  for (const double mu_deg : {10.0, 20.0, 45.0, 75.0, 80.0, 90.0, 120.0}) {
    const double sin_mu = std::sin(radians(mu_deg));
    table_.view.wave_factors(stencil(), sin_mu, factors);
    for (std::size_t i = 0; i + 1 < kHullTableWaves; ++i) {
      const double k = 0.5 * (nodes_.wave[i] + nodes_.wave[i + 1]);
      if (k * half_breadth > kShortestWave) {
        break;
      }
      const DiffractionFactors wanted = diffraction_factors(flow(k), k, sin_mu);
      const HullTable::WaveStencil at = table_.view.wave_stencil(k);
      DiffractionFactors got;
      for (std::size_t n = 0; n < at.weight.size(); ++n) {
        got.heave += at.weight[n] * factors.heave[at.first + n];
        got.sway += at.weight[n] * factors.sway[at.first + n];
        got.roll_lever += at.weight[n] * factors.roll_lever[at.first + n];
      }
      // Parts of the motion of the water at the surface: 1, and of a roll lever of the half-breadth.
      const double part = std::max({std::abs(got.heave - wanted.heave), std::abs(got.sway - wanted.sway),
                                    std::abs(got.roll_lever - wanted.roll_lever) / half_breadth});
      worst = std::max(worst, part);
    }
  }
  std::printf("waves: %.3f %%\n", 100.0 * worst);
  EXPECT_LT(worst, kWaves);
}

TEST_F(Nodes, InALongWaveTheWaterMovesTheSectionAsAParticle) {
  HullTable::WaveFactors factors{};
  table_.view.wave_factors(stencil(), 1.0, factors);
  EXPECT_EQ(factors.heave[0], Complex(1.0, 0.0));
  EXPECT_EQ(factors.sway[0], Complex(1.0, 0.0));
  EXPECT_EQ(factors.roll_lever[0], Complex(0.0, 0.0));
}

}  // namespace
}  // namespace quickstrip::test
