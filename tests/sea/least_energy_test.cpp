// Seas of hardly any height: nothing on the grid that a processor is slow with, and nothing that is no
// number. What the cycle makes of them in time: cycle_times --inputs (tests/bench).
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/sea/sea_energy.hpp"

namespace quickstrip {
namespace {

std::vector<double> nodes() {
  std::vector<double> out;
  for (int i = 0; i < 40; ++i) {
    out.push_back(0.2 + 0.045 * static_cast<double>(i));
  }
  return out;
}

// Zero, or far from the denormals even in single precision and after products: above 1e-28.
bool is_quick(double value) {
  return value == 0.0 || (std::fabs(value) >= 1e-28 && std::isfinite(value));
}

void expect_quick(const SeaEnergy& sea) {
  for (std::size_t b = 0; b < sea.num_bands; ++b) {
    for (const double energy : sea.band[b].node) {
      EXPECT_PRED1(is_quick, energy);
    }
    for (const DensityTerms& terms : sea.band[b].density) {
      for (const double term : terms) {
        EXPECT_PRED1(is_quick, term);
      }
    }
  }
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    for (std::size_t b = 0; b < sea.part[s].count; ++b) {
      for (const double share : sea.part[s].factor[sea.part[s].first + b]) {
        EXPECT_PRED1(is_quick, share);
      }
    }
  }
  EXPECT_TRUE(std::isfinite(sea.lost_tail));
  EXPECT_TRUE(std::isfinite(sea.hs));
}

TEST(LeastEnergy, NoSeaPutsDenormalsOnTheGridAndNoneIsNoNumber) {
  const auto sea = std::make_unique<SeaEnergy>();
  for (const double hs : {3.0, 1e-3, 1e-28, 1e-30, 1e-100, 1e-155, 1e-160, 1e-300, 5e-324}) {
    for (const double period : {2.0, 8.0, 25.0}) {
      for (const double spreading : {0.02, 0.5}) {
        SeaState state;
        ASSERT_TRUE(state.systems.push_back(
            {hs, period, PeriodKind::kPeak, WaveFrom{1.0}, spreading, SpectrumShape::kJonswap, 3.3}));
        ASSERT_TRUE(place_on_grid(state, nodes(), *sea).ok());
        expect_quick(*sea);
      }
    }
  }
}

TEST(LeastEnergy, MeasuredSpectraToo) {
  const auto spectrum = std::make_unique<DirectionalSpectrum>();
  for (int d = 0; d < 36; ++d) {
    ASSERT_TRUE(spectrum->directions.push_back(kTwoPi * static_cast<double>(d) / 36.0));
  }
  for (int f = 0; f < 20; ++f) {
    ASSERT_TRUE(spectrum->frequencies.push_back(0.3 + 0.05 * static_cast<double>(f)));
  }
  const auto sea = std::make_unique<SeaEnergy>();
  for (const double least : {1e-59, 1e-200, 1e-310}) {
    for (std::size_t f = 0; f < 20; ++f) {
      for (std::size_t d = 0; d < 36; ++d) {
        spectrum->density[f][d] = f == 5 && d == 7 ? 1.0 : least * static_cast<double>(d % 5);
      }
    }
    ASSERT_TRUE(place_on_grid(*spectrum, nodes(), *sea).ok());
    expect_quick(*sea);
  }
}

// What is dropped does not show: the energy on the grid is that of the sea.
TEST(LeastEnergy, EnergyIsKept) {
  const auto sea = std::make_unique<SeaEnergy>();
  SeaState state;
  ASSERT_TRUE(state.systems.push_back(
      {2.0, 9.0, PeriodKind::kPeak, WaveFrom{1.0}, 0.4, SpectrumShape::kJonswap, 3.3}));
  ASSERT_TRUE(place_on_grid(state, nodes(), *sea).ok());
  double sum = 0.0;
  for (const double energy : sea->band[0].node) {
    sum += energy;
  }
  EXPECT_NEAR(sum, 2.0 * 2.0 / 16.0, 1e-15);
}

}  // namespace
}  // namespace quickstrip
