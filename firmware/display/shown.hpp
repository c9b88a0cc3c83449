// Everything that the page shows, newest of each, out of messages that were checked. One thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "firmware/display/mailbox.hpp"
#include "firmware/display/shown_sea.hpp"
#include "firmware/display/trends.hpp"

namespace quickstrip {

struct Shown {
  using Clock = std::chrono::steady_clock;

  std::optional<advice_t> advice;
  std::optional<grid_t> grid;
  std::optional<outlook_t> outlook;
  std::optional<limits_t> limits;
  std::optional<health_t> health;
  std::optional<comparison_t> comparison;
  std::optional<own_ship_t> own_ship;
  std::optional<loading_t> loading;
  std::optional<response_t> answer;                                 // the last one to a query
  std::map<std::pair<std::int32_t, std::int32_t>, alert_t> alerts;  // by alert_id, instance
  std::map<std::pair<std::int32_t, std::int32_t>, Clock::time_point> alert_came;
  std::deque<logbook_t> notes;  // the newest last
  ShownSea sea_of_state;
  ShownSea sea_of_spectrum;
  Trends trends;
  Clock::time_point advice_came;  // by our clock: silence is judged by this
  std::uint64_t num_refused = 0;  // malformed or out of range

  /// The sea that the advice rests on; without advice the newer one.
  [[nodiscard]] const ShownSea& sea() const;
};

/// What changed, so that only that is sent.
struct Changed {
  bool state = false;
  bool grid = false;
  bool trends = false;
  bool answer = false;
};

/// Takes in what is in range, counts the rest.
Changed take_in(Mail& mail, Shown::Clock::time_point now, Shown& shown);

/// An active alert is repeated every ten seconds: one that is not for thirty is no longer shown.
bool drop_silent_alerts(Shown::Clock::time_point now, Shown& shown);

}  // namespace quickstrip
