#include "msgs/convert/sea_message.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

sea_state_t crossing_sea() {
  sea_state_t m{};
  m.utime = 1'567'600'000'000'000;
  m.source_kind = sea_state_t::SOURCE_RADAR;
  m.num_systems = 2;
  m.valid = sea_state_t::VALID_SPREADING;
  m.valid |= sea_state_t::VALID_SHAPE;
  m.valid |= sea_state_t::VALID_PEAKEDNESS;
  m.hs_m[0] = 4.5;
  m.period_s[0] = 11.0;
  m.period_kind[0] = sea_state_t::PERIOD_TP;
  m.dir_from_deg[0] = 90.0;
  m.spreading_deg[0] = 20.0;
  m.shape[0] = sea_state_t::SHAPE_JONSWAP;
  m.peakedness[0] = 2.0;
  m.hs_m[1] = 2.0;
  m.period_s[1] = 7.0;
  m.period_kind[1] = sea_state_t::PERIOD_TM02;
  m.dir_from_deg[1] = 359.5;
  m.spreading_deg[1] = 0.0;
  m.peakedness[1] = 3.3;
  return m;
}

Conversion convert(const sea_state_t& m) {
  SeaState sea;
  std::uint32_t assumed = 0;
  return to_sea_state(m, sea, assumed);
}

TEST(SeaMessage, SystemsArriveInSiUnits) {
  SeaState sea;
  std::uint32_t assumed = 99;
  ASSERT_TRUE(to_sea_state(crossing_sea(), sea, assumed).ok());
  EXPECT_EQ(assumed, 0u);
  ASSERT_EQ(sea.systems.size(), 2u);
  EXPECT_EQ(sea.systems[0].hs, 4.5);
  EXPECT_EQ(sea.systems[0].period_kind, PeriodKind::kPeak);
  EXPECT_DOUBLE_EQ(sea.systems[0].from.radians, 1.5707963267948966);
  EXPECT_EQ(sea.systems[0].shape, SpectrumShape::kJonswap);
  EXPECT_EQ(sea.systems[1].period_kind, PeriodKind::kZeroCrossing);
  EXPECT_EQ(sea.systems[1].spreading, 0.0);
}

TEST(SeaMessage, WhatIsNotGivenIsAssumedAndSaid) {
  sea_state_t m = crossing_sea();
  m.valid = 0;
  SeaState sea;
  std::uint32_t assumed = 0;
  ASSERT_TRUE(to_sea_state(m, sea, assumed).ok());
  EXPECT_EQ(assumed, std::uint32_t{kAssumedSpreading} | std::uint32_t{kAssumedShape});
  EXPECT_DOUBLE_EQ(sea.systems[1].spreading, radians(kAssumedSpreading_deg));
  EXPECT_EQ(sea.systems[0].shape, SpectrumShape::kBretschneider);
  m.valid = sea_state_t::VALID_SHAPE;
  ASSERT_TRUE(to_sea_state(m, sea, assumed).ok());
  EXPECT_EQ(assumed, std::uint32_t{kAssumedSpreading} | std::uint32_t{kAssumedPeakednessOfJonswap});
}

TEST(SeaMessage, RoundTripKeepsEveryFigure) {
  SeaState sea;
  std::uint32_t assumed = 0;
  ASSERT_TRUE(to_sea_state(crossing_sea(), sea, assumed).ok());
  sea_state_t back{};
  back.utime = 1;
  to_message(sea, back);
  std::uint8_t bytes[1000];
  sea_state_t received{};
  ASSERT_TRUE(decode(encode(back, bytes), received));
  SeaState again;
  ASSERT_TRUE(to_sea_state(received, again, assumed).ok());
  ASSERT_EQ(again.systems.size(), sea.systems.size());
  for (std::size_t i = 0; i < sea.systems.size(); ++i) {
    EXPECT_EQ(again.systems[i].hs, sea.systems[i].hs);
    EXPECT_EQ(again.systems[i].period, sea.systems[i].period);
    EXPECT_EQ(again.systems[i].period_kind, sea.systems[i].period_kind);
    // two roundings of degrees to radians and back
    EXPECT_NEAR(again.systems[i].from.radians, sea.systems[i].from.radians, 1e-14);
    EXPECT_NEAR(again.systems[i].spreading, sea.systems[i].spreading, 1e-15);
    EXPECT_EQ(again.systems[i].shape, sea.systems[i].shape);
    EXPECT_EQ(again.systems[i].peakedness, sea.systems[i].peakedness);
  }
}

TEST(SeaMessage, NotANumberIsRefusedInEveryFieldUsedOrNot) {
  using Setter = std::function<void(sea_state_t&, double)>;
  const std::pair<const char*, Setter> fields[] = {
      {"lat_deg", [](sea_state_t& m, double v) { m.lat_deg = v; }},
      {"lon_deg", [](sea_state_t& m, double v) { m.lon_deg = v; }},
      {"hs_m", [](sea_state_t& m, double v) { m.hs_m[5] = v; }},
      {"period_s", [](sea_state_t& m, double v) { m.period_s[0] = v; }},
      {"dir_from_deg", [](sea_state_t& m, double v) { m.dir_from_deg[1] = v; }},
      {"spreading_deg", [](sea_state_t& m, double v) { m.spreading_deg[2] = v; }},
      {"peakedness", [](sea_state_t& m, double v) { m.peakedness[3] = v; }},
      {"hs_std_m", [](sea_state_t& m, double v) { m.hs_std_m[0] = v; }},
      {"period_std_s", [](sea_state_t& m, double v) { m.period_std_s[0] = v; }},
      {"dir_std_deg", [](sea_state_t& m, double v) { m.dir_std_deg[0] = v; }}};
  for (const auto& [name, set] : fields) {
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      sea_state_t m = crossing_sea();
      set(m, value);
      const Conversion result = convert(m);
      EXPECT_EQ(result.refusal, Refusal::kNotFinite) << name;
      EXPECT_STREQ(result.field, name);
    }
  }
}

struct Broken {
  Refusal refusal;
  const char* field;
  std::function<void(sea_state_t&)> change;
};

TEST(SeaMessage, WhatIsOutsideItsRangeIsRefusedByName) {
  const Broken cases[] = {
      {Refusal::kTime, "utime", [](sea_state_t& m) { m.utime = 0; }},
      {Refusal::kCount, "num_systems", [](sea_state_t& m) { m.num_systems = 0; }},
      {Refusal::kCount, "num_systems", [](sea_state_t& m) { m.num_systems = 7; }},
      {Refusal::kCount, "num_systems", [](sea_state_t& m) { m.num_systems = -1; }},
      {Refusal::kUnknownKind, "source_kind", [](sea_state_t& m) { m.source_kind = 6; }},
      {Refusal::kUnknownKind, "source_kind", [](sea_state_t& m) { m.source_kind = -1; }},
      {Refusal::kHeight, "hs_m", [](sea_state_t& m) { m.hs_m[1] = 0.0; }},
      {Refusal::kHeight, "hs_m", [](sea_state_t& m) { m.hs_m[1] = 30.1; }},
      // 22 m twice is a sea of 31 m
      {Refusal::kHeight, "hs_m", [](sea_state_t& m) { m.hs_m[0] = m.hs_m[1] = 22.0; }},
      {Refusal::kPeriod, "period_s", [](sea_state_t& m) { m.period_s[1] = 0.9; }},
      {Refusal::kPeriod, "period_s", [](sea_state_t& m) { m.period_s[1] = 41.0; }},
      {Refusal::kUnknownKind, "period_kind", [](sea_state_t& m) { m.period_kind[0] = 3; }},
      {Refusal::kUnknownKind, "period_kind", [](sea_state_t& m) { m.period_kind[0] = -1; }},
      {Refusal::kDirection, "dir_from_deg", [](sea_state_t& m) { m.dir_from_deg[0] = 360.0; }},
      {Refusal::kDirection, "dir_from_deg", [](sea_state_t& m) { m.dir_from_deg[0] = -0.1; }},
      {Refusal::kOutOfRange, "spreading_deg", [](sea_state_t& m) { m.spreading_deg[0] = 81.0; }},
      {Refusal::kUnknownKind, "shape", [](sea_state_t& m) { m.shape[0] = 3; }},
      {Refusal::kOutOfRange, "peakedness", [](sea_state_t& m) { m.peakedness[0] = 0.5; }}};
  for (const Broken& broken : cases) {
    sea_state_t m = crossing_sea();
    broken.change(m);
    const Conversion result = convert(m);
    EXPECT_EQ(result.refusal, broken.refusal) << broken.field;
    EXPECT_STREQ(result.field, broken.field);
  }
}

TEST(SeaMessage, ARefusalLeavesTheSeaAsItWas) {
  SeaState sea;
  std::uint32_t assumed = 0;
  ASSERT_TRUE(to_sea_state(crossing_sea(), sea, assumed).ok());
  sea_state_t m = crossing_sea();
  m.hs_m[0] = 9.0;
  m.hs_m[1] = -1.0;
  ASSERT_FALSE(to_sea_state(m, sea, assumed).ok());
  EXPECT_EQ(sea.systems[0].hs, 4.5);
}

// A spectrum flat in direction: 12 directions from 15 degrees on, density 0.01 m2/(Hz deg), 0.05 to 0.15 Hz.
std::unique_ptr<wave_spectrum_t> flat_spectrum() {
  auto m = std::make_unique<wave_spectrum_t>(wave_spectrum_t{});
  m->utime = 1'567'600'000'000'000;
  m->num_frequencies = 11;
  m->num_directions = 12;
  for (int f = 0; f < 11; ++f) {
    m->frequency_hz[f] = 0.05 + 0.01 * f;
    for (int d = 0; d < 12; ++d) {
      m->density_m2_hz_deg[f][d] = 0.01F * static_cast<float>(d + 1);
    }
  }
  for (int d = 0; d < 12; ++d) {
    m->dir_from_deg[d] = std::fmod(195.0 + 30.0 * d, 360.0);
  }
  return m;
}

Refusal refusal_of(const wave_spectrum_t& m) {
  static DirectionalSpectrum spectrum;
  return to_directional_spectrum(m, spectrum).refusal;
}

// m0 = sum of density over directions x 30 degrees x 0.1 Hz = 0.01 x 78 x 30 x 0.1 = 2.34 m2, whatever the
// units.
TEST(SpectrumMessage, EnergyIsTheSameInBothUnits) {
  static DirectionalSpectrum s;
  ASSERT_TRUE(to_directional_spectrum(*flat_spectrum(), s).ok());
  ASSERT_EQ(s.frequencies.size(), 11u);
  ASSERT_EQ(s.directions.size(), 12u);
  double m0 = 0.0;
  for (std::size_t f = 1; f < 11; ++f) {
    for (std::size_t d = 0; d < 12; ++d) {
      m0 += 0.5 * (s.density[f][d] + s.density[f - 1][d]) * (s.frequencies[f] - s.frequencies[f - 1]) *
            kTwoPi / 12.0;
    }
  }
  EXPECT_NEAR(m0, 2.34, 2.34e-6);  // float on the wire
}

TEST(SpectrumMessage, DirectionsComeOutIncreasingWithTheirDensity) {
  static DirectionalSpectrum s;
  ASSERT_TRUE(to_directional_spectrum(*flat_spectrum(), s).ok());
  for (std::size_t d = 1; d < 12; ++d) {
    EXPECT_GT(s.directions[d], s.directions[d - 1]);
  }
  EXPECT_NEAR(s.directions[0], radians(15.0), 1e-12);
  // 15 degrees is the seventh direction of the message (195, 225 ... 345, 15): density 0.07
  EXPECT_NEAR(s.density[3][0] / s.density[3][6], 7.0 / 1.0, 1e-6);  // float; 195 degrees has 0.01
}

TEST(SpectrumMessage, RoundTripKeepsDensityToFloat) {
  static DirectionalSpectrum s;
  static DirectionalSpectrum again;
  ASSERT_TRUE(to_directional_spectrum(*flat_spectrum(), s).ok());
  auto m = std::make_unique<wave_spectrum_t>(wave_spectrum_t{});
  m->utime = 1;
  to_message(s, *m);
  ASSERT_TRUE(to_directional_spectrum(*m, again).ok());
  for (std::size_t f = 0; f < 11; ++f) {
    EXPECT_NEAR(again.frequencies[f], s.frequencies[f], 1e-12);
    for (std::size_t d = 0; d < 12; ++d) {
      EXPECT_NEAR(again.density[f][d], s.density[f][d], 1e-7 * s.density[f][d]);  // float: 6e-8
    }
  }
}

TEST(SpectrumMessage, WhatIsBrokenIsRefused) {
  using Change = std::function<void(wave_spectrum_t&)>;
  const std::pair<Refusal, Change> cases[] = {
      {Refusal::kTime, [](wave_spectrum_t& m) { m.utime = -5; }},
      {Refusal::kCount, [](wave_spectrum_t& m) { m.num_frequencies = 65; }},
      {Refusal::kCount, [](wave_spectrum_t& m) { m.num_frequencies = 2; }},
      {Refusal::kCount, [](wave_spectrum_t& m) { m.num_directions = 73; }},
      {Refusal::kCount, [](wave_spectrum_t& m) { m.num_directions = -1; }},
      {Refusal::kUnknownKind, [](wave_spectrum_t& m) { m.source_kind = 9; }},
      {Refusal::kNotFinite, [](wave_spectrum_t& m) { m.frequency_hz[60] = kNan; }},
      {Refusal::kNotFinite, [](wave_spectrum_t& m) { m.dir_from_deg[3] = kNan; }},
      {Refusal::kNotFinite, [](wave_spectrum_t& m) { m.hs_std_m = kNan; }},
      {Refusal::kNotFinite, [](wave_spectrum_t& m) { m.lat_deg = kNan; }},
      {Refusal::kNotFinite,
       [](wave_spectrum_t& m) { m.density_m2_hz_deg[5][5] = std::numeric_limits<float>::quiet_NaN(); }},
      {Refusal::kNotFinite,
       [](wave_spectrum_t& m) { m.density_m2_hz_deg[63][71] = std::numeric_limits<float>::infinity(); }},
      {Refusal::kOutOfRange, [](wave_spectrum_t& m) { m.density_m2_hz_deg[5][5] = -1e-6F; }},
      {Refusal::kOutOfRange, [](wave_spectrum_t& m) { m.frequency_hz[0] = 0.0; }},
      {Refusal::kNotOrdered, [](wave_spectrum_t& m) { m.frequency_hz[4] = m.frequency_hz[3]; }},
      {Refusal::kNotOrdered, [](wave_spectrum_t& m) { m.dir_from_deg[4] += 1.0; }},
      {Refusal::kDirection, [](wave_spectrum_t& m) { m.dir_from_deg[5] = 360.0; }},
      {Refusal::kHeight, [](wave_spectrum_t& m) { m.density_m2_hz_deg[5][5] = 1e6F; }},
      {Refusal::kEmpty, [](wave_spectrum_t& m) {
         for (auto& row : m.density_m2_hz_deg) {
           std::fill(std::begin(row), std::end(row), 0.0F);
         }
       }}};
  EXPECT_EQ(refusal_of(*flat_spectrum()), Refusal::kNone);
  for (const auto& [refusal, change] : cases) {
    auto m = flat_spectrum();
    change(*m);
    EXPECT_EQ(refusal_of(*m), refusal) << message(refusal);
  }
}

TEST(Refusals, EachHasWordsOfItsOwn) {
  for (int i = 0; i <= 15; ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_STRNE(message(static_cast<Refusal>(i)), message(static_cast<Refusal>(j)));
    }
  }
}

}  // namespace
}  // namespace quickstrip
