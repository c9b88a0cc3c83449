#include "firmware/display/shown.hpp"

#include <cmath>

#include "msgs/convert/own_messages.hpp"
#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/ship_message.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxAlerts = 32;
constexpr std::size_t kMaxNotes = 24;
constexpr std::chrono::seconds kAlertStale{30};  // CHANNELS.md

template <typename Message>
bool put(std::optional<Message>& from, bool is_fit, std::optional<Message>& to, Shown& shown) {
  if (!from) {
    return false;
  }
  if (!is_fit) {
    ++shown.num_refused;
    return false;
  }
  to = std::move(from);
  return true;
}

bool is_fit(const outlook_t& m) {
  return m.num_members >= 0 && std::isfinite(m.better_in_s) && std::isfinite(m.expect_s);
}

bool is_fit(const comparison_t& m) {
  return m.num_lines >= 0 && m.num_lines <= 15 && std::isfinite(m.window_s);
}

bool is_fit(const health_t& m) {
  return std::isfinite(m.cycle_period_s) && m.cycle_period_s > 0.0;
}

bool is_fit(const response_t& m) {
  return m.num_quantities >= 0 && m.num_quantities <= 96 && m.num_systems >= 0 && m.num_systems <= 6;
}

void take_alerts(const Mail& mail, Shown::Clock::time_point now, Shown& shown) {
  for (const alert_t& alert : mail.alerts) {
    const std::pair key{alert.alert_id, alert.instance};
    const bool is_over = alert.state == alert_t::STATE_NORMAL;
    const bool has_room = shown.alerts.size() < kMaxAlerts || shown.alerts.contains(key);
    if (!check_acknowledgement(alert).ok() || alert.priority < alert_t::PRIORITY_EMERGENCY ||
        alert.priority > alert_t::PRIORITY_CAUTION || !(is_over || has_room)) {
      ++shown.num_refused;
    } else if (is_over) {
      shown.alerts.erase(key);
      shown.alert_came.erase(key);
    } else {
      shown.alerts[key] = alert;
      shown.alert_came[key] = now;
    }
  }
}

/// As the advisor keeps its inputs: an earlier measurement gives way (a radar's beside an entry that is
/// repeated), unless what is held lies in the future, for then the clock was set back or a log begun again.
void keep_newer(ShownSea sea, Shown& shown, ShownSea& kept) {
  constexpr std::int64_t kTolerance_us = 5'000'000;
  if (sea.hs_m < 0.0) {
    ++shown.num_refused;
    return;
  }
  const bool is_held_ahead = shown.advice && kept.utime > shown.advice->utime + kTolerance_us;
  if (sea.utime >= kept.utime || is_held_ahead) {
    kept = std::move(sea);
  }
}

void take_sea(const Mail& mail, Shown& shown) {
  if (mail.sea_state) {
    keep_newer(shown_sea(*mail.sea_state), shown, shown.sea_of_state);
  }
  if (mail.wave_spectrum && mail.wave_spectrum->utime != shown.sea_of_spectrum.utime) {
    keep_newer(shown_sea(*mail.wave_spectrum), shown, shown.sea_of_spectrum);
  }
}

void add_trend(Shown& shown) {
  const advice_t& advice = *shown.advice;
  TrendSample sample;
  const bool has_advice = advice.no_advice == 0;
  sample.margin = has_advice ? advice.margin : -1.0;
  sample.roll_rms_deg = has_advice ? advice.roll_rms_deg : -1.0;
  sample.hs_m = has_advice ? shown.sea().hs_m : -1.0;
  sample.verdict = has_advice ? advice.verdict : -1;
  shown.trends.add(advice.utime, sample);
}

}  // namespace

const ShownSea& Shown::sea() const {
  const bool uses_state = advice && advice->input_use[advice_t::INPUT_SEA_STATE] != advice_t::USE_NONE;
  const bool uses_spectrum = advice && advice->input_use[advice_t::INPUT_WAVE_SPECTRUM] != advice_t::USE_NONE;
  if (uses_state != uses_spectrum) {
    return uses_state ? sea_of_state : sea_of_spectrum;
  }
  return sea_of_state.utime > sea_of_spectrum.utime ? sea_of_state : sea_of_spectrum;
}

Changed take_in(Mail& mail, Shown::Clock::time_point now, Shown& shown) {
  Changed changed;
  changed.state = !mail.is_empty;
  shown.num_refused += mail.num_malformed;
  put(mail.limits, mail.limits && check_limits(*mail.limits).ok(), shown.limits, shown);
  take_sea(mail, shown);
  OwnShipReading reading;
  put(mail.own_ship, mail.own_ship && to_own_ship(*mail.own_ship, reading).ok(), shown.own_ship, shown);
  if (put(mail.advice, mail.advice && check_advice(*mail.advice).ok(), shown.advice, shown)) {
    shown.advice_came = now;
    add_trend(shown);
    changed.trends = true;
  }
  changed.grid = put(mail.grid, mail.grid && check_grid(*mail.grid).ok(), shown.grid, shown);
  if (put(mail.outlook, mail.outlook && is_fit(*mail.outlook), shown.outlook, shown)) {
    changed.grid = changed.grid || shown.outlook->num_members > 0;
  }
  put(mail.health, mail.health && is_fit(*mail.health), shown.health, shown);
  put(mail.comparison, mail.comparison && is_fit(*mail.comparison), shown.comparison, shown);
  put(mail.loading, mail.loading.has_value(), shown.loading, shown);
  take_alerts(mail, now, shown);
  for (const logbook_t& note : mail.notes) {
    shown.notes.push_back(note);
    if (shown.notes.size() > kMaxNotes) {
      shown.notes.pop_front();
    }
  }
  if (!mail.answers.empty() && is_fit(mail.answers.back())) {
    shown.answer = mail.answers.back();
    changed.answer = true;
  }
  return changed;
}

bool drop_silent_alerts(Shown::Clock::time_point now, Shown& shown) {
  const auto is_silent = [&](const auto& came) { return now - came.second > kAlertStale; };
  const std::size_t before = shown.alerts.size();
  std::erase_if(shown.alerts, [&](const auto& alert) {
    const auto came = shown.alert_came.find(alert.first);
    return came == shown.alert_came.end() || is_silent(*came);
  });
  std::erase_if(shown.alert_came, is_silent);
  return shown.alerts.size() != before;
}

}  // namespace quickstrip
