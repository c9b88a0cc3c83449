#include "sim/replay/log_feed.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

constexpr std::array<std::string_view, 9> kInputNames{"SEA_STATE", "WAVE_SPECTRUM", "SEA_FORECAST",
                                                      "OWN_SHIP",  "LOADING",       "MOTION",
                                                      "TIME",      "QUERY",         "ALERT_ACK"};

}  // namespace

std::string_view name_without_prefix(std::string_view channel, std::string_view prefix) {
  if (!channel.starts_with(prefix)) {
    return {};
  }
  const std::string_view name = channel.substr(prefix.size());
  const bool is_ours = is_input(name) || std::find(kOutChannelNames.begin(), kOutChannelNames.end(), name) !=
                                             kOutChannelNames.end();
  return is_ours ? name : std::string_view{};
}

bool is_input(std::string_view name) {
  return std::find(kInputNames.begin(), kInputNames.end(), name) != kInputNames.end();
}

template <typename Message>
Fed LogFeed::take(const LogEvent& event, std::int64_t now, Input input, Message& message, Session& session,
                  InputUse use) {
  if (!decode(event.data, message)) {
    session.count(input, {Refusal::kMalformed, "", -1});
    return Fed::kRefused;
  }
  if constexpr (requires { session.accept(message, now, use); }) {
    return session.accept(message, now, use).ok() ? Fed::kTaken : Fed::kRefused;
  } else {
    return session.accept(message, now).ok() ? Fed::kTaken : Fed::kRefused;
  }
}

template <typename Message>
Fed LogFeed::take_unused(const LogEvent& event, std::int64_t now, Input input, Message& message,
                         Session& session) {
  const Fed fed = take(event, now, input, message, session, InputUse::kLive);
  return fed == Fed::kRefused ? Fed::kRefused : Fed::kOther;
}

Fed LogFeed::feed(const LogEvent& event, std::int64_t now, Session& session, InputUse use) {
  const std::string_view name = name_without_prefix(event.channel, prefix_);
  if (name.empty()) {
    return Fed::kUnknown;
  }
  if (name == "SEA_STATE") {
    return take(event, now, Input::kSeaState, sea_state_, session, use);
  }
  if (name == "WAVE_SPECTRUM") {
    return take(event, now, Input::kWaveSpectrum, wave_spectrum_, session, use);
  }
  if (name == "OWN_SHIP") {
    return take(event, now, Input::kOwnShip, own_ship_, session, use);
  }
  if (name == "LOADING") {
    return take(event, now, Input::kLoading, loading_, session, use);
  }
  if (name == "QUERY") {
    return take(event, now, Input::kQuery, query_, session, use);
  }
  if (name == "ALERT_ACK") {
    return take(event, now, Input::kAlertAck, acknowledgement_, session, use);
  }
  if (name == "MOTION") {
    return take_unused(event, now, Input::kMotion, motion_, session);
  }
  if (name == "SEA_FORECAST") {
    return take_unused(event, now, Input::kSeaForecast, forecast_, session);
  }
  return Fed::kOther;
}

bool LogFeed::is_acceptable(const LogEvent& event, std::int64_t now, const Inputs& inputs) {
  const auto trial = std::make_unique<Inputs>(inputs);
  const std::string_view name = name_without_prefix(event.channel, prefix_);
  if (name == "OWN_SHIP") {
    return decode(event.data, own_ship_) && trial->accept(own_ship_, now).ok();
  }
  return name == "LOADING" && decode(event.data, loading_) && trial->accept(loading_, now).ok();
}

}  // namespace quickstrip
