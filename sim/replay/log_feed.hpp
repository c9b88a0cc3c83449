// Gives the events of a log to a session: decoded by channel, refused and unknown ones counted.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/session/session.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {

enum class Fed : std::uint8_t {
  kTaken,    // an input of the session
  kRefused,  // an input that does not decode or is implausible
  kOther,    // a channel of ours that is no input: advice, grid, ... or not used yet
  kUnknown,  // not ours
};

/// The name of a channel of ours without the prefix; empty when it is not ours.
std::string_view name_without_prefix(std::string_view channel, std::string_view prefix);

/// Whether the name (without prefix) is that of an input.
bool is_input(std::string_view name);

/// `now`: the log's time. The messages are decoded in place: keep one feed for a whole log.
class LogFeed {
 public:
  explicit LogFeed(std::string prefix) : prefix_(std::move(prefix)) {}
  Fed feed(const LogEvent& event, std::int64_t now, Session& session, InputUse use = InputUse::kLive);
  /// Whether `inputs` would take an own ship or a loading; they stay as they are.
  bool is_acceptable(const LogEvent& event, std::int64_t now, const Inputs& inputs);

 private:
  template <typename Message>
  Fed take(const LogEvent& event, std::int64_t now, Input input, Message& message, Session& session,
           InputUse use);

  /// No cycle of its own: nothing depends on it.
  template <typename Message>
  Fed take_unused(const LogEvent& event, std::int64_t now, Input input, Message& message, Session& session);

  std::string prefix_;
  sea_state_t sea_state_{};
  wave_spectrum_t wave_spectrum_{};
  own_ship_t own_ship_{};
  loading_t loading_{};
  query_t query_{};
  alert_t acknowledgement_{};
  motion_t motion_{};
  sea_forecast_t forecast_{};
};

}  // namespace quickstrip
