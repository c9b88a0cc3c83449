// The roll of the S-175 in long-crested seas against brute force: motion_transfer() itself on 5,000 wave
// frequencies, with the spectrum's own density.
#include "core/strip/roll_peak.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "core/response/moments.hpp"
#include "core/response/watch.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/sea/spectrum.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "core/strip/transfer_functions.hpp"
#include "tests/support/hulls.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr int kShifts = 4;
constexpr int kBruteFrequencies = 2000;
constexpr double kBruteFrom = 0.15;  // rad/s: around every shift's range
constexpr double kBruteTo = 2.35;

struct Case {
  WaveSystem sea;
  double mu_deg = 0.0;
  double speed = 0.0;
};

WaveSystem long_crested(double tp, SpectrumShape shape, double peakedness) {
  return {5.0, tp, PeriodKind::kPeak, WaveFrom{0.0}, 0.0, shape, peakedness};
}

std::complex<double> roll_at(const RollPeak& peak, std::size_t p) {
  static_assert(kPeakModes[1] == 3);
  return {static_cast<double>(peak.re[1][p]), static_cast<double>(peak.im[1][p])};
}

class RollPeakTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(load(hull_, hull_.loading, {}, *ship_).ok());
    ASSERT_TRUE(list_channels(hull_, hull_.loading, ship_->hydrostatics, SwellUp::kOff, watch_).ok());
    roll_ = find_channel(watch_, Quantity::kRoll, 0);
  }

  // Nodes of the hull's own, each shifted by `part` of the step to the next.
  std::vector<double> shifted_nodes(double part) {
    choose_frequencies(*ship_, *transfer_);
    std::vector<double> nodes(transfer_->omega.begin(), transfer_->omega.end());
    const std::size_t last = nodes.size() - 1;
    for (std::size_t f = 0; f <= last; ++f) {
      const std::size_t from = std::min(f, last - 1);
      nodes[f] = transfer_->omega[f] + part * (transfer_->omega[from + 1] - transfer_->omega[from]);
    }
    return nodes;
  }

  // Roll variance of each sea at one direction and speed.
  std::vector<double> brute_force(std::span<const Spectrum> seas, double mu_deg, double speed) {
    std::vector<double> sums(seas.size(), 0.0);
    const double step = (kBruteTo - kBruteFrom) / kBruteFrequencies;
    for (int i = 0; i < kBruteFrequencies; ++i) {
      const double omega = kBruteFrom + (i + 0.5) * step;
      const double h2 = std::norm(motion_transfer(*ship_, omega, {radians(mu_deg)}, speed).motion[3]);
      for (std::size_t s = 0; s < seas.size(); ++s) {
        sums[s] += h2 * density(seas[s], omega) * step;
      }
    }
    return sums;
  }

  // For a ship heading north.
  void place(const Case& at, std::span<const double> nodes) {
    SeaState sea;
    WaveSystem system = at.sea;
    system.from.radians = radians(180.0 - at.mu_deg);
    ASSERT_TRUE(sea.systems.push_back(system));
    ASSERT_TRUE(place_on_grid(sea, nodes, *sea_).ok());
  }

  std::vector<ResponseMoments> moments(double speed) {
    std::vector<ResponseMoments> out(watch_.channels.size());
    EXPECT_TRUE(response_moments(*transfer_, watch_, *sea_, {0.0}, speed, out).ok());
    return out;
  }

  // Relative error of the roll RMS. Without the scaling that stands for the lost tail: brute force covers
  // every shift's range, and roll has nothing beyond.
  double error_of(const Case& at, std::span<const double> nodes, double exact) {
    place(at, nodes);
    return std::sqrt((1.0 - sea_->lost_tail) * moments(at.speed)[roll_].m0 / exact) - 1.0;
  }

  void remove_peaks() {
    for (auto& row : transfer_->peak) {
      for (RollPeak& peak : row) {
        peak.clear();
      }
    }
  }

  Hull hull_ = test::s175();
  std::unique_ptr<LoadedHull> ship_ = std::make_unique<LoadedHull>();
  std::unique_ptr<TransferFunctions> transfer_ = std::make_unique<TransferFunctions>();
  std::unique_ptr<TransferWorkspace> work_ = std::make_unique<TransferWorkspace>();
  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  Watch watch_;
  std::size_t roll_ = 0;
};

// All headings, 0, 10 and 20 kn, four positions of the frequencies, ratios 0.05 and 0.02, long-crested seas.
// Prints the worst error of the roll RMS where the ship rolls, at a tenth of the sea's largest RMS or more,
// and where she does not. What is left in the shortest sea is the straight line between frequencies in waves
// from astern, far from any resonance; in a JONSWAP sea of Tp 7 s the same reaches 6 % where the ship rolls a
// twentieth of her largest.
TEST_F(RollPeakTest, GivesTheRollOfBruteForceOnAllHeadingsWhereverTheFrequenciesFall) {
  const std::array<double, 3> speeds = {0.0, 10.0 * kKnot, 20.0 * kKnot};
  const std::array<WaveSystem, 3> seas = {long_crested(17.0, SpectrumShape::kBretschneider, 1.0),
                                          long_crested(12.0, SpectrumShape::kJonswap, 3.3),
                                          long_crested(9.0, SpectrumShape::kBretschneider, 1.0)};
  std::vector<Spectrum> spectra;
  for (const WaveSystem& sea : seas) {
    spectra.push_back(*spectrum_of(sea));
  }
  struct Worst {
    double rolls = 0.0;
    double still = 0.0;
    double without_points = 0.0;
  };
  std::array<Worst, 3> worst{};
  const auto take = [](double error, double& largest) { largest = std::max(largest, std::fabs(error)); };
  for (const double ratio : {0.05, 0.02}) {
    set_roll_damping_ratio(*ship_, ratio);
    std::vector<Case> cases;
    std::vector<double> exact;
    for (double mu_deg = 15.0; mu_deg < 179.0; mu_deg += 15.0) {
      for (const double speed : speeds) {
        const std::vector<double> sums = brute_force(spectra, mu_deg, speed);
        for (std::size_t s = 0; s < seas.size(); ++s) {
          cases.push_back({seas[s], mu_deg, speed});
          exact.push_back(sums[s]);
        }
      }
    }
    std::array<double, 3> largest{};
    for (std::size_t i = 0; i < cases.size(); ++i) {
      largest[i % 3] = std::max(largest[i % 3], exact[i]);
    }
    for (int shift = 0; shift < kShifts; ++shift) {
      const auto nodes = shifted_nodes(static_cast<double>(shift) / kShifts - 0.5);
      ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, nodes, *work_, *transfer_).ok());
      for (std::size_t i = 0; i < cases.size(); ++i) {
        const bool rolls = exact[i] > 0.01 * largest[i % 3];
        const double error = error_of(cases[i], nodes, exact[i]);
        take(error, rolls ? worst[i % 3].rolls : worst[i % 3].still);
        EXPECT_NEAR(error, 0.0, rolls ? 0.01 : 0.02)
            << "sea " << i % 3 << " mu " << cases[i].mu_deg << " V " << cases[i].speed << " ratio " << ratio;
      }
      remove_peaks();
      for (std::size_t i = 0; i < cases.size(); ++i) {
        take(error_of(cases[i], nodes, exact[i]), worst[i % 3].without_points);
      }
    }
  }
  std::printf("worst error of the roll RMS, %%:  rolls  still  without the points\n");
  for (std::size_t s = 0; s < seas.size(); ++s) {
    std::printf("  Tp %4.1f s, gamma %.1f %15.2f %6.2f %8.1f\n", seas[s].period, seas[s].peakedness,
                100.0 * worst[s].rolls, 100.0 * worst[s].still, 100.0 * worst[s].without_points);
    EXPECT_GT(worst[s].without_points, 0.03);  // else there was nothing to mend
  }
}

// At its points the peak holds the solution of motion_transfer() but for the interpolation of the loads.
// Measured 0.3 % of the largest roll at the points while the wave at the ends of the ship turns by less than
// 2 rad from one frequency to the next, 6 % beyond, in waves that carry little.
TEST_F(RollPeakTest, HoldsAtItsPointsTheMotionsOfTheEquationsThemselves) {
  set_roll_damping_ratio(*ship_, 0.02);
  const std::array<double, 3> speeds = {0.0, 12.0 * kKnot, 20.0 * kKnot};
  ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *transfer_).ok());
  const double step = transfer_->omega[1] / transfer_->omega[0] - 1.0;
  std::array<double, 3> worst{};
  std::size_t num_points = 0;
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    for (std::size_t m = 1; m + 1 < kNumSolvedDirections; ++m) {
      const RollPeak& peak = transfer_->peak[v][m];
      const EncounterAngle mu{kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1)};
      std::array<double, 3> error{};
      double largest = 0.0;
      for (std::size_t p = 0; p < peak.num_points; ++p) {
        const auto omega = static_cast<double>(peak.omega[p]);
        const MotionTransfer exact = motion_transfer(*ship_, omega, mu, speeds[v]);
        largest = std::max(largest, std::abs(exact.motion[3]));
        const double turn =
            omega * omega / ship_->gravity * 2.0 * step * 0.5 * ship_->lpp * std::fabs(std::cos(mu.radians));
        const std::size_t kind = turn < 1.0 ? 0 : turn < 2.0 ? 1 : 2;
        error[kind] = std::max(error[kind], std::abs(roll_at(peak, p) - exact.motion[3]));
      }
      for (std::size_t kind = 0; kind < 3; ++kind) {
        worst[kind] = std::max(worst[kind], error[kind] / largest);
      }
      num_points += peak.num_points;
    }
  }
  EXPECT_GT(num_points, 2000U);
  EXPECT_LT(worst[0], 0.005);
  EXPECT_LT(worst[1], 0.005);
  EXPECT_LT(worst[2], 0.1);
}

// Sway, yaw and roll answer waves from the other side with the other sign: to the last bit.
TEST_F(RollPeakTest, IsTheSameForWavesFromPortAndFromStarboard) {
  set_roll_damping_ratio(*ship_, 0.02);
  const std::array<double, 1> speeds = {15.0 * kKnot};
  ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *transfer_).ok());
  for (const double mu_deg : {30.0, 60.0, 90.0, 135.0}) {
    const Case starboard{long_crested(14.0, SpectrumShape::kJonswap, 3.3), mu_deg, speeds[0]};
    Case port = starboard;
    port.mu_deg = -mu_deg;
    place(starboard, transfer_->omega);
    const auto from_starboard = moments(starboard.speed);
    place(port, transfer_->omega);
    const auto from_port = moments(port.speed);
    for (const Quantity q : {Quantity::kSway, Quantity::kRoll, Quantity::kYaw}) {
      const std::size_t c = find_channel(watch_, q, 0);
      EXPECT_GT(from_port[c].m0, 0.0);
      EXPECT_EQ(from_starboard[c].m0, from_port[c].m0) << mu_deg;
      EXPECT_EQ(from_starboard[c].m2, from_port[c].m2) << mu_deg;
    }
  }
}

TEST_F(RollPeakTest, IsTheSameBitForBitWhenSolvedAgain) {
  const std::array<double, 2> speeds = {5.0, 10.0};
  const auto again = std::make_unique<TransferFunctions>();
  ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *transfer_).ok());
  ASSERT_TRUE(solve_transfer_functions(*ship_, std::span(speeds).first(1), *work_, *again)
                  .ok());  // leaves old scratch
  ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *again).ok());
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
      const RollPeak& a = transfer_->peak[v][m];
      const RollPeak& b = again->peak[v][m];
      ASSERT_EQ(a.num_points, b.num_points);
      for (std::size_t p = 0; p < a.num_points; ++p) {
        EXPECT_EQ(a.omega[p], b.omega[p]);
        EXPECT_EQ(roll_at(a, p), roll_at(b, p));
      }
    }
  }
}

// A ship that answers every wave with one radian per metre has the sea's own variance, peak or not; a
// response that is a straight line between the frequencies gets nothing added.
TEST_F(RollPeakTest, AddsNothingWhereTheResponseIsAStraightLine) {
  set_roll_damping_ratio(*ship_, 0.02);
  const std::array<double, 1> speeds = {0.0};
  ASSERT_TRUE(solve_transfer_functions(*ship_, speeds, *work_, *transfer_).ok());
  for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
    transfer_->row[0][m].re[3].fill(1.0F);
    transfer_->row[0][m].im[3].fill(0.0F);
    transfer_->peak[0][m].re[1].fill(1.0F);
    transfer_->peak[0][m].im[1].fill(0.0F);
  }
  const Case beam{long_crested(14.0, SpectrumShape::kJonswap, 3.3), 90.0, 0.0};
  place(beam, transfer_->omega);
  EXPECT_GT(transfer_->peak[0][18].num_points, 0U);
  EXPECT_NEAR(moments(0.0)[roll_].m0, 5.0 * 5.0 / 16.0, kSingle);
}

// Roll resonance is where the motions are largest, and as wide as they are.
TEST_F(RollPeakTest, StandsWhereRollIsLargest) {
  set_roll_damping_ratio(*ship_, 0.02);
  const RollResonance resonance = roll_resonance(*ship_, 0.0);
  const auto roll_per_slope = [&](double omega) {
    const MotionTransfer t = motion_transfer(*ship_, omega, {radians(90.0)}, 0.0);
    return std::norm(t.motion[3]) / std::pow(omega, 4);
  };
  const double top = roll_per_slope(resonance.omega);
  EXPECT_GT(top, roll_per_slope(resonance.omega - 0.5 * resonance.half_width));
  EXPECT_GT(top, roll_per_slope(resonance.omega + 0.5 * resonance.half_width));
  // Half power at the half width; the exciting moment changes by some per cent on the way.
  EXPECT_NEAR(roll_per_slope(resonance.omega - resonance.half_width) / top, 0.5, 0.05);
  EXPECT_NEAR(roll_per_slope(resonance.omega + resonance.half_width) / top, 0.5, 0.05);
}

}  // namespace
}  // namespace quickstrip
