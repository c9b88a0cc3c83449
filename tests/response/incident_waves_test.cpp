#include "core/response/incident_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>

#include "core/base/constants.hpp"
#include "tests/response/synthetic.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

// e^{-i k x cos mu}, k = omega^2/g: written again from NOTATION.md, of all directions and not of a quarter.
TEST(IncidentWaves, FromEveryDirectionAreTheClosedFormAtEachPlaceOnTheCentreLine) {
  const auto hull = std::make_unique<Hull>();
  const auto transfer = std::make_unique<TransferFunctions>();
  const auto waves = std::make_unique<IncidentWaves>();
  Watch watch;
  synthetic::fill_box(*hull);
  ASSERT_TRUE(list_channels(*hull, hull->loading, synthetic::box_hydrostatics(), SwellUp::kOff, watch).ok());
  synthetic::fill(*transfer, 2, 1.0, 40, synthetic::shiplike);
  list_incident_waves(*transfer, watch, *waves);
  int num_relative = 0;
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    if (!(watch.channels[c].form.wave > 0.0)) {
      continue;
    }
    ++num_relative;
    for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
      const double mu = kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1);
      const WaveThere there = wave_from(waves->of(c), m);
      for (std::size_t f = 0; f < transfer->num_frequencies; ++f) {
        const double k = transfer->omega[f] * transfer->omega[f] / kStandardGravity;
        const auto expected = std::polar(1.0, -k * watch.channels[c].position.x * std::cos(mu));
        const double side = there.is_conjugate ? -1.0 : 1.0;
        EXPECT_NEAR(static_cast<double>(there.wave.re[f]), expected.real(), kSingle) << c << ' ' << m;
        EXPECT_NEAR(side * static_cast<double>(there.wave.im[f]), expected.imag(), kSingle) << c << ' ' << m;
      }
    }
  }
  EXPECT_GT(num_relative, 1);
}

}  // namespace
}  // namespace quickstrip
