// QS_SEA_STATE, QS_WAVE_SPECTRUM and QS_SEA_FORECAST with everything wrong, one thing at a time.
#include "tests/bad_input/bad_messages.hpp"

namespace quickstrip::test {
namespace {

TEST_F(BadMessages, SeaStatesWithEverythingWrongAreRefused) {
  using M = sea_state_t;
  const std::vector<Wrong<M>> list = {
      {"no system", [](M& m) { m.num_systems = 0; }, Refusal::kCount, "num_systems"},
      {"seven", [](M& m) { m.num_systems = 7; }, Refusal::kCount, "num_systems"},
      {"negative", [](M& m) { m.num_systems = -128; }, Refusal::kCount, "num_systems"},
      {"40 m", [](M& m) { m.hs_m[0] = 40.0; }, Refusal::kHeight, "hs_m"},
      {"no height", [](M& m) { m.hs_m[0] = 0.0; }, Refusal::kHeight, "hs_m"},
      {"negative height", [](M& m) { m.hs_m[0] = -3.0; }, Refusal::kHeight, "hs_m"},
      {"1e308", [](M& m) { m.hs_m[0] = 1e308; }, Refusal::kHeight, "hs_m"},
      {"two of 25 m",
       [](M& m) {
         m.num_systems = 2;
         m.hs_m[0] = m.hs_m[1] = 25.0;
         m.period_s[1] = 9.0;
       },
       Refusal::kHeight, "hs_m"},
      {"period 0", [](M& m) { m.period_s[0] = 0.0; }, Refusal::kPeriod, "period_s"},
      {"negative period", [](M& m) { m.period_s[0] = -11.0; }, Refusal::kPeriod, "period_s"},
      {"a frequency for a period", [](M& m) { m.period_s[0] = 0.09; }, Refusal::kPeriod, "period_s"},
      {"kind of period", [](M& m) { m.period_kind[0] = 3; }, Refusal::kUnknownKind, "period_kind"},
      {"direction 725", [](M& m) { m.dir_from_deg[0] = 725.0; }, Refusal::kDirection, "dir_from_deg"},
      {"direction 360", [](M& m) { m.dir_from_deg[0] = 360.0; }, Refusal::kDirection, "dir_from_deg"},
      {"direction -1", [](M& m) { m.dir_from_deg[0] = -1.0; }, Refusal::kDirection, "dir_from_deg"},
      {"spreading",
       [](M& m) {
         m.valid = M::VALID_SPREADING;
         m.spreading_deg[0] = 90.0;
       },
       Refusal::kOutOfRange, "spreading_deg"},
      {"shape",
       [](M& m) {
         m.valid = M::VALID_SHAPE;
         m.shape[0] = 9;
       },
       Refusal::kUnknownKind, "shape"},
      {"peakedness 0", [](M& m) { m.valid = M::VALID_PEAKEDNESS; }, Refusal::kOutOfRange, "peakedness"},
      {"kind of system", [](M& m) { m.system_kind[0] = 77; }, Refusal::kUnknownKind, "system_kind"},
      {"kind of source", [](M& m) { m.source_kind = 6; }, Refusal::kUnknownKind, "source_kind"},
      {"unknown bit", [](M& m) { m.valid = 1 << 20; }, Refusal::kUnknownKind, "valid"},
      {"every bit", [](M& m) { m.valid = -1; }, Refusal::kUnknownKind, "valid"},
      {"ceased before it was measured",
       [](M& m) {
         m.valid = M::VALID_UNTIL;
         m.valid_until_utime = m.utime - 1;
       },
       Refusal::kInconsistent, "valid_until_utime"},
      {"ceases never",
       [](M& m) {
         m.valid = M::VALID_UNTIL;
         m.valid_until_utime = -kNever - 1;
       },
       Refusal::kTime, "valid_until_utime"},
      {"off the globe",
       [](M& m) {
         m.valid = M::VALID_POSITION;
         m.lat_deg = 91.0;
       },
       Refusal::kOutOfRange, "lat_deg"},
      {"negative deviation",
       [](M& m) {
         m.valid = M::VALID_STD;
         m.hs_std_m[0] = -0.1;
       },
       Refusal::kOutOfRange, "hs_std_m, period_std_s or dir_std_deg"}};
  const auto expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "SEA_STATE", Input::kSeaState, bytes, refusal, field);
  };
  const M good = swell(kStart, 3.0, 90.0);
  expect_each<M>(list, good, expect);
  expect_each<M>(wrong_times<M>(), good, expect);
  expect_each<M>(from_the_future<M>(), good, expect);
  EXPECT_EQ(bridge_->cycle(kStart + kSecond).no_advice, 0) << "what is held stays";
}

TEST_F(BadMessages, SpectraWithEverythingWrongAreRefused) {
  using M = wave_spectrum_t;
  const std::vector<Wrong<M>> list = {
      {"2 frequencies", [](M& m) { m.num_frequencies = 2; }, Refusal::kCount, "num_frequencies"},
      {"65", [](M& m) { m.num_frequencies = 65; }, Refusal::kCount, "num_frequencies"},
      {"negative", [](M& m) { m.num_frequencies = -32768; }, Refusal::kCount, "num_frequencies"},
      {"3 directions", [](M& m) { m.num_directions = 3; }, Refusal::kCount, "num_directions"},
      {"73", [](M& m) { m.num_directions = 73; }, Refusal::kCount, "num_directions"},
      {"rad/s for Hz", [](M& m) { m.frequency_hz[7] = 12.0; }, Refusal::kOutOfRange, "frequency_hz"},
      {"swapped", [](M& m) { std::swap(m.frequency_hz[2], m.frequency_hz[3]); }, Refusal::kNotOrdered,
       "frequency_hz"},
      {"the same twice", [](M& m) { m.frequency_hz[3] = m.frequency_hz[2]; }, Refusal::kNotOrdered,
       "frequency_hz"},
      {"direction 725", [](M& m) { m.dir_from_deg[1] = 725.0; }, Refusal::kDirection, "dir_from_deg"},
      {"not even", [](M& m) { m.dir_from_deg[1] = 46.0; }, Refusal::kNotOrdered, "dir_from_deg"},
      {"anticlockwise", [](M& m) { std::swap(m.dir_from_deg[1], m.dir_from_deg[7]); }, Refusal::kNotOrdered,
       "dir_from_deg"},
      {"negative energy", [](M& m) { m.density_m2_hz_deg[3][2] = -1.0F; }, Refusal::kOutOfRange,
       "density_m2_hz_deg"},
      {"no energy",
       [](M& m) {
         for (auto& row : m.density_m2_hz_deg) {
           row[2] = 0.0F;
         }
       },
       Refusal::kEmpty, "density_m2_hz_deg"},
      {"a sea of 300 m", [](M& m) { m.density_m2_hz_deg[3][2] = 1e4F; }, Refusal::kHeight,
       "density_m2_hz_deg"},
      {"unknown bit", [](M& m) { m.valid = 8; }, Refusal::kUnknownKind, "valid"},
      {"kind of source", [](M& m) { m.source_kind = -1; }, Refusal::kUnknownKind, "source_kind"},
      {"ceased before it was measured", [](M& m) { m.valid = M::VALID_UNTIL; }, Refusal::kTime,
       "valid_until_utime"},
      {"off the globe",
       [](M& m) {
         m.valid = M::VALID_POSITION;
         m.lon_deg = 725.0;
       },
       Refusal::kOutOfRange, "lon_deg"},
      {"negative deviation",
       [](M& m) {
         m.valid = M::VALID_STD;
         m.hs_std_m = -1.0;
       },
       Refusal::kOutOfRange, "hs_std_m"}};
  const auto expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "WAVE_SPECTRUM", Input::kWaveSpectrum, bytes, refusal, field);
  };
  const M good = spectrum(kStart, 0.5, 2);
  expect_each<M>(list, good, expect);
  expect_each<M>(wrong_times<M>(), good, expect);
  expect_each<M>(from_the_future<M>(), good, expect);
  const advice_t& advice = bridge_->cycle(kStart + kSecond);
  EXPECT_EQ(advice.no_advice, 0) << "the sea state stays in force";
  EXPECT_EQ(advice.input_use[0], int{advice_t::USE_LIVE});
}

}  // namespace
}  // namespace quickstrip::test
