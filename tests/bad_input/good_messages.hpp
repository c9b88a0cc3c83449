// One good message of each incoming type, encoded, and a session of the S-175 that takes them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "msgs/convert/encode.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/sea_forecast_t.hpp"
#include "tests/session/session_fixture.hpp"

namespace quickstrip::test {

inline constexpr std::int64_t kHour = 60 * kMinute;

template <typename Message>
std::vector<std::uint8_t> encoded(const Message& message) {
  static std::array<std::uint8_t, kMaxMessageBytes> buffer;
  const auto bytes = encode(message, buffer);
  return {bytes.begin(), bytes.end()};
}

inline sea_forecast_t forecast(std::int64_t utime) {
  sea_forecast_t out{};
  out.utime = utime;
  out.num_states = 3;
  for (int i = 0; i < 3; ++i) {
    out.states[i] = swell(utime + (i + 1) * kHour, 2.0 + i, 200.0);
  }
  return out;
}

inline motion_t motion(std::int64_t utime) {
  motion_t out{};
  out.utime = utime;
  out.num_accelerometers = 1;
  out.valid = motion_t::VALID_ROLL;
  out.window_s = 600.0;
  out.roll_rms_deg = 2.0;
  out.roll_zero_crossing_s = 18.0;
  out.a_x_rms_m_s2[0] = -1.0;
  return out;
}

inline query_t query(std::int64_t utime, double heading_deg, double speed_kn) {
  query_t out{};
  out.utime = utime;
  out.query_id = 7;
  out.heading_deg = heading_deg;
  out.speed_kn = speed_kn;
  return out;
}

inline alert_t acknowledgement(std::int64_t utime) {
  alert_t out{};
  out.utime = utime;
  out.state = alert_t::STATE_ACKNOWLEDGED;
  out.alert_id = 1;
  out.instance = 1;
  return out;
}

/// What comes in, by channel name without prefix.
struct GoodMessage {
  std::string channel;
  std::string type;
  Input input;
  std::vector<std::uint8_t> bytes;
};

inline std::vector<GoodMessage> good_messages() {
  return {{"SEA_STATE", "sea_state_t", Input::kSeaState, encoded(swell(kStart, 3.0, 90.0))},
          {"WAVE_SPECTRUM", "wave_spectrum_t", Input::kWaveSpectrum, encoded(spectrum(kStart, 0.5, 2))},
          {"SEA_FORECAST", "sea_forecast_t", Input::kSeaForecast, encoded(forecast(kStart))},
          {"OWN_SHIP", "own_ship_t", Input::kOwnShip, encoded(ship(kStart, 30.0, 12.0))},
          {"LOADING", "loading_t", Input::kLoading, encoded(loaded(kStart, 9.4))},
          {"MOTION", "motion_t", Input::kMotion, encoded(motion(kStart))},
          {"QUERY", "query_t", Input::kQuery, encoded(query(kStart, 30.0, 12.0))},
          {"ALERT_ACK", "alert_t", Input::kAlertAck, encoded(acknowledgement(kStart))}};
}

}  // namespace quickstrip::test
