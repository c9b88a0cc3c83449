// The sea that is simulated: energy, bins of encounter frequency, directions.
#include "sim/seaway/wave_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sea/dispersion.hpp"
#include "sim/seaway/simulation.hpp"
#include "tests/seaway/scene.hpp"

namespace quickstrip::seaway {
namespace {

constexpr FrequencyRange kRange{0.2, 2.2};

Beams beams_from(double from_deg, double spreading_deg) {
  SeaState sea;
  EXPECT_TRUE(sea.systems.push_back(wave_system(4.0, 8.0, from_deg, spreading_deg)));
  const Result<Beams> out = beams_of(sea, kRange);
  EXPECT_TRUE(out.ok());
  return *out;
}

TEST(Beams, KeepHeightMeanDirectionAndSpreading) {
  for (const double spreading_deg : {3.0, 15.0, 25.0, 60.0}) {
    const Beams sea = beams_from(70.0, spreading_deg);
    double energy = 0.0;
    double cosine = 0.0;
    double sine = 0.0;
    for (const Beam& beam : sea.beams) {
      double m0 = 0.0;
      for (int i = 0; i < 2000; ++i) {
        m0 += 1e-3 * beam.density(0.2 + 1e-3 * (i + 0.5));
      }
      energy += m0;
      cosine += m0 * std::cos(beam.from.radians);
      sine += m0 * std::sin(beam.from.radians);
    }
    EXPECT_NEAR(energy, 1.0, 1e-4) << spreading_deg;  // Hs^2 / 16; midpoint rule
    EXPECT_NEAR(degrees(std::atan2(sine, cosine)), 70.0, 1e-9);
    // Circular standard deviation sqrt(2 (1 - r1)); what is left out is below 1e-4 of the energy.
    EXPECT_NEAR(degrees(std::sqrt(2.0 * (1.0 - std::hypot(cosine, sine) / energy))), spreading_deg,
                0.002 * spreading_deg);
  }
}

TEST(Beams, OfAMeasuredSpectrumAreItsDirections) {
  DirectionalSpectrum spectrum;
  for (const double omega : {0.4, 0.6, 0.8, 1.2}) {
    EXPECT_TRUE(spectrum.frequencies.push_back(omega));
  }
  for (int d = 0; d < 8; ++d) {
    EXPECT_TRUE(spectrum.directions.push_back(kTwoPi * d / 8.0));
  }
  spectrum.density[1][2] = 3.0;
  spectrum.density[2][2] = 1.0;
  const Result<Beams> sea = beams_of(spectrum, kRange);
  ASSERT_TRUE(sea.ok());
  const double sector = kTwoPi / 8.0;
  EXPECT_NEAR(sea->beams[2].from.radians, kPi / 2.0, 1e-12);
  // Kinks of the density lie within panels of the quadrature: 1e-4 of the energy.
  EXPECT_NEAR(sea->beams[2].density(0.7), 2.0 * sector, 1e-3);
  EXPECT_EQ(sea->beams[1].density(0.7), 0.0);
  EXPECT_EQ(sea->beams[2].density(1.3), 0.0);
}

TEST(Beams, RefuseASeaThatIsNotThere) {
  EXPECT_FALSE(beams_of(SeaState{}, kRange).ok());
  SeaState ripples;
  EXPECT_TRUE(ripples.systems.push_back(wave_system(0.1, 1.0, 0.0, 0.0)));  // omega from 4 rad/s on
  EXPECT_FALSE(beams_of(ripples, kRange).ok());
  EXPECT_FALSE(beams_of(DirectionalSpectrum{}, kRange).ok());
}

TEST(WaveCells, KeepTheEnergyAndLieOnTheBinOfTheirEncounterFrequency) {
  const CellGrid grid{
      .heading = Heading{0.0}, .speed = 10.0, .gravity = kStandardGravity, .step = kTwoPi / 3600.0};
  for (const double from_deg : {0.0, 60.0, 90.0, 150.0, 180.0}) {  // head ... following, with its turn
    const Beams sea = beams_from(from_deg, 0.0);
    const EncounterAngle mu = encounter_angle(grid.heading, sea.beams[0].from);
    double energy = 0.0;
    double before = 0.0;
    for (const WaveCell& cell : wave_cells(sea, grid)) {
      const double met = encounter_frequency(cell.omega, wave_number(cell.omega), grid.speed, mu);
      EXPECT_NEAR(met / grid.step, cell.bin, 0.5 + 1e-6) << from_deg << " at " << cell.omega;
      EXPECT_GT(cell.omega, before);
      EXPECT_LE(cell.omega - before, before > 0.0 ? 0.0101 : 1.0);  // no gaps
      before = cell.omega;
      energy += cell.energy;
    }
    EXPECT_NEAR(energy, 1.0, 1e-4) << from_deg;  // Simpson's rule; densities below 1e-7 left out
  }
}

// Of the elevation at two points of the ship 2 m apart, cos^2s spread waves make a slope whose variance along
// the mean direction is (1 + r2)/2 of the whole and across it (1 - r2)/2, r2 = s (s - 1) / ((s + 1)(s + 2)).
TEST(Simulation, WavesAreSpreadAsTheSeaSays) {
  Scene scene(4.0, 9.0, 180.0, 30.0, 0.0);
  Watch two;
  two.gravity = scene.watch.gravity;
  for (const double x : {-1.0, 1.0}) {
    Channel channel{.quantity = Quantity::kDeckWetness, .position = {x, 0.0, 0.0}, .level = 1.0};
    channel.form.wave = 1.0;  // the wave alone
    EXPECT_TRUE(two.channels.push_back(channel));
  }
  scene.watch = two;
  scene.plan.hours = 20.0;
  const auto slope_variance = [&](double heading_deg) {
    scene.plan.heading = Heading{radians(heading_deg)};
    Simulation simulation = scene.simulation();
    double sum = 0.0;
    static_cast<void>(run(simulation, scene.watch, {}, 1, [&](std::size_t, const Series& series) {
      for (std::size_t j = 0; j < series[0].size(); ++j) {
        sum += std::pow(series[1][j] - series[0][j], 2) / static_cast<double>(series[0].size());
      }
    }));
    return sum;
  };
  const double s = 2.0 / std::pow(radians(30.0), 2) - 1.0;
  const double r2 = s * (s - 1.0) / ((s + 1.0) * (s + 2.0));
  // 20 h of some 4 s waves: 18,000, whose energy scatters by 1 %.
  EXPECT_NEAR(slope_variance(90.0) / slope_variance(0.0), (1.0 - r2) / (1.0 + r2), 0.02 * (1.0 - r2));
}

}  // namespace
}  // namespace quickstrip::seaway
