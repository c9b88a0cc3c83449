// QS_OWN_SHIP, QS_LOADING and the rest with everything wrong, one thing at a time.
#include "tests/bad_input/bad_messages.hpp"

namespace quickstrip::test {
namespace {

TEST_F(BadMessages, OwnShipsWithEverythingWrongAreRefused) {
  using M = own_ship_t;
  const std::vector<Wrong<M>> list = {
      {"no heading", [](M& m) { m.valid = 2; }, Refusal::kFieldMissing, "heading_deg"},
      {"no speed", [](M& m) { m.valid = 1; }, Refusal::kFieldMissing, "speed_through_water_kn"},
      {"heading 725", [](M& m) { m.heading_deg = 725.0; }, Refusal::kDirection, "heading_deg"},
      {"heading 360", [](M& m) { m.heading_deg = 360.0; }, Refusal::kDirection, "heading_deg"},
      {"100 kn", [](M& m) { m.speed_through_water_kn = 100.0; }, Refusal::kOutOfRange,
       "speed_through_water_kn"},
      {"astern", [](M& m) { m.speed_through_water_kn = -20.0; }, Refusal::kOutOfRange,
       "speed_through_water_kn"},
      {"over ground",
       [](M& m) {
         m.valid = 1 + 4;
         m.speed_over_ground_kn = -1.0;
       },
       Refusal::kOutOfRange, "speed_over_ground_kn"},
      {"course",
       [](M& m) {
         m.valid |= M::VALID_COURSE;
         m.course_over_ground_deg = -0.001;
       },
       Refusal::kDirection, "course_over_ground_deg"},
      {"rate of turn",
       [](M& m) {
         m.valid |= M::VALID_RATE_OF_TURN;
         m.rate_of_turn_deg_min = 1e6;
       },
       Refusal::kOutOfRange, "rate_of_turn_deg_min"},
      {"latitude",
       [](M& m) {
         m.valid |= M::VALID_POSITION;
         m.lat_deg = -90.5;
       },
       Refusal::kOutOfRange, "lat_deg"},
      {"above the water",
       [](M& m) {
         m.valid |= M::VALID_DEPTH;
         m.depth_m = -5.0;
       },
       Refusal::kOutOfRange, "depth_m"},
      {"wind",
       [](M& m) {
         m.valid |= M::VALID_WIND;
         m.wind_from_deg = 361.0;
       },
       Refusal::kDirection, "wind_from_deg"},
      {"stabiliser", [](M& m) { m.stabiliser = 4; }, Refusal::kUnknownKind, "stabiliser"},
      {"unknown bit", [](M& m) { m.valid |= 256; }, Refusal::kUnknownKind, "valid"},
      {"sign bit", [](M& m) { m.valid = std::numeric_limits<std::int32_t>::min() + 3; },
       Refusal::kUnknownKind, "valid"}};
  const auto expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "OWN_SHIP", Input::kOwnShip, bytes, refusal, field);
  };
  const M good = ship(kStart, 0.0, 15.0);
  expect_each<M>(list, good, expect);
  expect_each<M>(wrong_times<M>(), good, expect);
  expect_each<M>(from_the_future<M>(), good, expect);
  EXPECT_EQ(bridge_->cycle(kStart + kSecond).no_advice, 0) << "what is held stays";
}

TEST_F(BadMessages, LoadingsWithEverythingWrongAreRefused) {
  using M = loading_t;
  const auto draughts = [](M& m, double aft, double fwd) {
    m.valid = M::VALID_DRAUGHTS;
    m.draught_aft_m = aft;
    m.draught_fwd_m = fwd;
  };
  const auto marked = [](M& m, std::int32_t bit, double M::*field, double value) {
    m.valid = bit;
    m.*field = value;
  };
  const std::vector<Wrong<M>> list = {
      {"nothing given", [](M& m) { m.valid = 0; }, Refusal::kFieldMissing, "valid"},
      {"unknown bit alone", [](M& m) { m.valid = 1 << 20; }, Refusal::kUnknownKind, "valid"},
      {"no draught", [&](M& m) { draughts(m, 0.0, 9.5); }, Refusal::kOutOfRange, "draught_aft_m"},
      {"negative", [&](M& m) { draughts(m, 9.5, -9.5); }, Refusal::kOutOfRange, "draught_fwd_m"},
      {"above the deck", [&](M& m) { draughts(m, 9.5, 20.0); }, Refusal::kInconsistent, "draught_fwd_m"},
      {"KG 0", [&](M& m) { marked(m, M::VALID_KG, &M::kg_m, 0.0); }, Refusal::kOutOfRange, "kg_m"},
      {"KG 95.5", [&](M& m) { marked(m, M::VALID_KG, &M::kg_m, 95.5); }, Refusal::kOutOfRange, "kg_m"},
      {"GM below zero", [&](M& m) { marked(m, M::VALID_GM, &M::gm_m, -0.3); }, Refusal::kOutOfRange, "gm_m"},
      {"correction", [&](M& m) { marked(m, M::VALID_FREE_SURFACE, &M::free_surface_correction_m, -0.1); },
       Refusal::kOutOfRange, "free_surface_correction_m"},
      {"gyradius above the ship", [&](M& m) { marked(m, M::VALID_ROLL_GYRADIUS, &M::roll_gyradius_m, 30.0); },
       Refusal::kOutOfRange, "roll_gyradius_m"},
      {"pitch gyradius", [&](M& m) { marked(m, M::VALID_PITCH_GYRADIUS, &M::pitch_gyradius_m, 175.0); },
       Refusal::kOutOfRange, "pitch_gyradius_m"},
      {"yaw gyradius", [&](M& m) { marked(m, M::VALID_YAW_GYRADIUS, &M::yaw_gyradius_m, 0.0); },
       Refusal::kOutOfRange, "yaw_gyradius_m"},
      {"roll period 0", [&](M& m) { marked(m, M::VALID_ROLL_PERIOD, &M::measured_roll_period_s, 0.0); },
       Refusal::kOutOfRange, "measured_roll_period_s"},
      {"density in t/m3", [&](M& m) { marked(m, M::VALID_WATER_DENSITY, &M::water_density_kg_m3, 1.025); },
       Refusal::kOutOfRange, "water_density_kg_m3"},
      {"displacement", [&](M& m) { marked(m, M::VALID_DISPLACEMENT, &M::displacement_t, -1.0); },
       Refusal::kOutOfRange, "displacement_t"},
      {"LCG outside", [&](M& m) { marked(m, M::VALID_LCG, &M::lcg_m, 200.0); }, Refusal::kOutOfRange,
       "lcg_m"},
      {"kind of source", [](M& m) { m.source_kind = 6; }, Refusal::kUnknownKind, "source_kind"}};
  const auto expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "LOADING", Input::kLoading, bytes, refusal, field);
  };
  const M good = loaded(kStart, 9.4);
  expect_each<M>(list, good, expect);
  expect_each<M>(wrong_times<M>(), good, expect);
  expect_each<M>(from_the_future<M>(), good, expect);
  const advice_t& advice = bridge_->cycle(kStart + kSecond);
  EXPECT_EQ(advice.no_advice, 0) << "the default loading stays in force";
  EXPECT_EQ(advice.input_use[4], int{advice_t::USE_DEFAULT});
}

TEST_F(BadMessages, MotionsForecastsQueriesAndAcknowledgementsWithEverythingWrongAreRefused) {
  using Motion = motion_t;
  const std::vector<Wrong<Motion>> motions = {
      {"accelerometers", [](Motion& m) { m.num_accelerometers = 5; }, Refusal::kCount, "num_accelerometers"},
      {"negative", [](Motion& m) { m.num_accelerometers = -1; }, Refusal::kCount, "num_accelerometers"},
      {"unknown bit", [](Motion& m) { m.valid = 32; }, Refusal::kUnknownKind, "valid"},
      {"no window", [](Motion& m) { m.window_s = 0.0; }, Refusal::kOutOfRange, "window_s"},
      {"negative RMS", [](Motion& m) { m.roll_rms_deg = -2.0; }, Refusal::kOutOfRange, "roll_rms_deg"},
      {"RMS 725", [](Motion& m) { m.roll_rms_deg = 725.0; }, Refusal::kOutOfRange, "roll_rms_deg"},
      {"acceleration", [](Motion& m) { m.a_z_rms_m_s2[0] = -2.0; }, Refusal::kOutOfRange,
       "a_x_rms_m_s2, a_y_rms_m_s2 or a_z_rms_m_s2"}};
  const auto motion_expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "MOTION", Input::kMotion, bytes, refusal, field);
  };
  expect_each<Motion>(motions, motion(kStart), motion_expect);
  expect_each<Motion>(wrong_times<Motion>(), motion(kStart), motion_expect);
  expect_each<Motion>(from_the_future<Motion>(), motion(kStart), motion_expect);

  using Forecast = sea_forecast_t;
  const std::vector<Wrong<Forecast>> forecasts = {
      {"none", [](Forecast& m) { m.num_states = 0; }, Refusal::kCount, "num_states"},
      {"49", [](Forecast& m) { m.num_states = 49; }, Refusal::kCount, "num_states"},
      {"out of order", [](Forecast& m) { m.states[2].utime = m.states[1].utime; }, Refusal::kNotOrdered,
       "states.utime"},
      {"40 m", [](Forecast& m) { m.states[1].hs_m[0] = 40.0; }, Refusal::kHeight, "hs_m"}};
  const auto forecast_expect = [this](const auto& what, const auto& bytes, Refusal refusal,
                                      const auto& field) {
    expect_refusal(what, "SEA_FORECAST", Input::kSeaForecast, bytes, refusal, field);
  };
  expect_each<Forecast>(forecasts, forecast(kStart), forecast_expect);
  expect_each<Forecast>(wrong_times<Forecast>(), forecast(kStart), forecast_expect);
  expect_each<Forecast>(from_the_future<Forecast>(), forecast(kStart), forecast_expect);

  // Neither is a measurement: a display may run by another clock than the log's, and is answered all the
  // same.
  const auto query_expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "QUERY", Input::kQuery, bytes, refusal, field);
  };
  expect_each<query_t>(
      {{"id 0", [](query_t& m) { m.query_id = 0; }, Refusal::kOutOfRange, "query_id"},
       {"725", [](query_t& m) { m.heading_deg = 725.0; }, Refusal::kDirection, "heading_deg"},
       {"1e9 kn", [](query_t& m) { m.speed_kn = 1e9; }, Refusal::kOutOfRange, "speed_kn"}},
      query(kStart, 0.0, 10.0), query_expect);
  expect_each<query_t>(wrong_times<query_t>(), query(kStart, 0.0, 10.0), query_expect);
  const auto ack_expect = [this](const auto& what, const auto& bytes, Refusal refusal, const auto& field) {
    expect_refusal(what, "ALERT_ACK", Input::kAlertAck, bytes, refusal, field);
  };
  expect_each<alert_t>({{"id 0", [](alert_t& m) { m.alert_id = 0; }, Refusal::kUnknownKind, "alert_id"},
                        {"id", [](alert_t& m) { m.alert_id = 1 << 30; }, Refusal::kUnknownKind, "alert_id"},
                        {"instance", [](alert_t& m) { m.instance = 2; }, Refusal::kUnknownKind, "alert_id"},
                        {"state", [](alert_t& m) { m.state = 9; }, Refusal::kUnknownKind, "state"}},
                       acknowledgement(kStart), ack_expect);
  expect_each<alert_t>(wrong_times<alert_t>(), acknowledgement(kStart), ack_expect);
  EXPECT_EQ(bridge_->cycle(kStart + kSecond).no_advice, 0) << bridge_->no_advice_text();
}

}  // namespace
}  // namespace quickstrip::test
