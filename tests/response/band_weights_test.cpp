#include "core/response/band_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kNode = 5;  // the interval of the peak: frequencies 5 and 6
constexpr double kStep = 0.25;    // rad/s

/// A peak of three Gauss points between two frequencies, and a band of constant or sloping density there.
class BandWeightsTest : public testing::Test {
 protected:
  BandWeightsTest() {
    for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
      omega_[f] = kStep * static_cast<double>(f + 1);
    }
    constexpr std::array<double, 3> kPlaces = {0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    EXPECT_TRUE(peak_.intervals.push_back({kNode, 0, 3}));
    peak_.num_points = 3;
    for (std::size_t p = 0; p < 3; ++p) {
      peak_.omega[p] = static_cast<float>(omega_[kNode] + kPlaces[p] * kStep);
      peak_.weight[p] = static_cast<float>(kWeights[p] * kStep);
    }
    list_peak_shapes(peak_, omega_, shapes_);
    band_.first = 3;
    band_.last = 9;
    for (std::size_t f = band_.first; f <= band_.last; ++f) {
      band_.node[f] = 0.1 * static_cast<double>(f);
    }
  }
  /// A response that is `value(t)` at place t of the interval and on a straight line elsewhere.
  template <typename Value>
  ChannelValues response(const Value& value) const {
    ChannelValues out;
    out.has_points = true;
    for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
      out.nodes[f] = static_cast<float>(f <= kNode ? value(0.0) : value(1.0));
    }
    for (std::size_t p = 0; p < 3; ++p) {
      out.points[p] = static_cast<float>(value(shapes_.place[p]));
    }
    return out;
  }
  [[nodiscard]] double integral(const ChannelValues& values) {
    list_band_weights(band_, peak_, shapes_, weights_);
    double out = 0.0;
    integrate({&weights_, 1}, values, {&out, 1});
    return out;
  }

  std::array<double, kMaxFrequencies> omega_{};
  RollPeak peak_;
  PeakShapes shapes_;
  EnergyBand band_;
  BandWeights weights_;
};

TEST_F(BandWeightsTest, OfAStraightLineThePointsAddNothing) {
  band_.density[kNode] = {2.0, -0.5, 0.3, 0.1};
  const ChannelValues line = response([](double t) { return 3.0 - 2.0 * t; });
  EXPECT_NEAR(integral(line), integrate(band_, line.nodes), kSingle);
}

TEST_F(BandWeightsTest, OfAPeakTheyAddItsIntegralOverTheDensity) {
  band_.density[kNode] = {2.0, 0.0, 0.0, 0.0};
  const ChannelValues bump = response([](double t) { return 4.0 * t * (1.0 - t); });
  EXPECT_NEAR(integral(bump), 2.0 * kStep * 2.0 / 3.0, kSingle);  // 0 at all frequencies
  band_.density[kNode] = {0.0, 2.0, 0.0, 0.0};
  const ChannelValues cubic = response([](double t) { return t * t * t; });
  EXPECT_NEAR(integral(cubic), integrate(band_, cubic.nodes) - 2.0 * kStep / 60.0, kSingle);
}

TEST_F(BandWeightsTest, OfABandBesideTheIntervalThereAreNone) {
  band_.density[kNode] = {2.0, 0.0, 0.0, 0.0};
  const ChannelValues bump = response([](double t) { return 4.0 * t * (1.0 - t); });
  EXPECT_GT(integral(bump), 0.1);
  band_.last = kNode;  // and nothing is left of the weights before
  EXPECT_EQ(integral(bump), 0.0);
  EXPECT_TRUE(weights_.points.is_empty());
}

TEST_F(BandWeightsTest, BelowTheFloorOnlyTheWavesMetThereCount) {
  Encounters encounters;
  encounters.low = lanes_that_hold(4, 6);
  encounters.is_low[4] = 1.0F;
  encounters.is_low[6] = 1.0F;
  NodeValues values;
  values.fill(2.0F);
  list_band_weights(band_, peak_, shapes_, weights_);
  double low = 0.0;
  integrate_low({&weights_, 1}, encounters, values, {&low, 1});
  EXPECT_NEAR(low, 2.0 * (band_.node[4] + band_.node[6]), kSingle);
}

}  // namespace
}  // namespace quickstrip
