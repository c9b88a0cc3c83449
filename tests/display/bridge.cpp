#include "tests/display/bridge.hpp"

#include <chrono>

#include "core/hazard/hazard_bits.hpp"
#include "msgs/convert/text.hpp"
#include "quickstrip/query_t.hpp"

namespace quickstrip::test {
namespace {

constexpr std::chrono::milliseconds kTurn{20};
constexpr std::chrono::milliseconds kSpeak{250};
constexpr std::int64_t kSecond_us = 1'000'000;

void set_cell(grid_t& grid, int s, int h) {
  const double heading = 5.0 * h;
  const auto within = [heading](double from, double to) { return heading >= from && heading <= to; };
  std::int8_t verdict = grid_t::VERDICT_GOOD;
  int hazards = 0;
  if (within(30.0, 60.0)) {
    verdict = grid_t::VERDICT_EXCEEDED;
    hazards = kHazardMotions;
  } else if (within(120.0, 150.0)) {
    verdict = grid_t::VERDICT_CAUTION;
    hazards = kHazardMotions;
  } else if (within(210.0, 240.0)) {
    verdict = grid_t::VERDICT_UNKNOWN;
  } else if (within(300.0, 330.0)) {
    verdict = grid_t::VERDICT_CAUTION;
    hazards = kHazardSurfRiding;
  }
  grid.verdict[s][h] = verdict;
  grid.hazards[s][h] = static_cast<std::int16_t>(s < 2 ? hazards | kHazardNoSteerage : hazards);
}

}  // namespace

std::int64_t utime_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

advice_t advice_at(std::int64_t utime, std::int32_t seq) {
  advice_t m{};
  m.utime = utime;
  m.seq = seq;
  m.source_id = 1;
  m.valid_until_utime = utime + 3 * kSecond_us;
  m.limits_digest = 77;
  put_text("Test ship", m.hull_name);
  put_text("Test limits", m.profile_name);
  m.input_use[advice_t::INPUT_SEA_STATE] = advice_t::USE_LIVE;
  m.input_use[advice_t::INPUT_OWN_SHIP] = advice_t::USE_LIVE;
  m.input_use[advice_t::INPUT_LOADING] = advice_t::USE_DEFAULT;
  m.input_utime[advice_t::INPUT_SEA_STATE] = utime - 60 * kSecond_us;
  m.input_utime[advice_t::INPUT_OWN_SHIP] = utime;
  m.heading_deg = 65.0;
  m.speed_kn = 14.2;
  m.speed_kind = advice_t::SPEED_THROUGH_WATER;
  m.verdict = advice_t::VERDICT_CAUTION;
  m.governing = 0;
  put_text("roll", m.governing_name);
  m.governing_value = 4.8;
  m.governing_limit = 6.0;
  m.governing_system = 0;
  m.margin = 1.25;
  m.roll_rms_deg = 4.8;
  m.bridge_vertical_rms_m_s2 = 0.7;
  m.slams_per_hour = 0.0;
  m.num_criteria = 2;
  m.criterion_value[0] = 4.8;
  m.criterion_value[1] = 0.01;
  m.change_needed = 1;
  m.num_changes = 2;
  m.change_to_heading_deg[0] = 95.0;
  m.change_to_speed_kn[0] = 14.0;
  m.change_verdict[0] = advice_t::VERDICT_GOOD;
  put_text("Come 30° to starboard (course 095°): good", m.change_text[0]);
  m.change_to_heading_deg[1] = 65.0;
  m.change_to_speed_kn[1] = 9.0;
  m.change_verdict[1] = advice_t::VERDICT_CAUTION;
  put_text("Reduce to 9 kn: near a limit", m.change_text[1]);
  put_text("Near a limit: roll 4.8° RMS, limit 6.0°", m.reasons_text);
  return m;
}

grid_t grid_at(std::int64_t utime, std::int32_t seq) {
  grid_t m{};
  m.utime = utime;
  m.seq = seq;
  m.limits_digest = 77;
  m.num_speeds = 25;
  m.num_headings = 72;
  for (int s = 0; s < 25; ++s) {
    m.speed_kn[s] = static_cast<float>(s);
    for (int h = 0; h < 72; ++h) {
      set_cell(m, s, h);
      m.margin[s][h] = 125;
      m.governing[s][h] = 0;
      m.roll_rms[s][h] = 480;
      m.bridge_vertical_rms[s][h] = 700;
      m.slam_probability[s][h] = -1;
      m.slams_per_hour[s][h] = -1;
      m.wetness_probability[s][h] = 200;
      m.roll_exceedance[s][h] = -1;
      m.speed_loss[s][h] = -1;
    }
  }
  return m;
}

limits_t limits_at(std::int64_t utime) {
  limits_t m{};
  m.utime = utime;
  m.digest = 77;
  m.num_criteria = 2;
  put_text("roll", m.name[0]);
  m.quantity[0] = 3;
  m.statistic[0] = limits_t::STATISTIC_RMS;
  m.unit[0] = limits_t::UNIT_DEG;
  m.limit[0] = 6.0;
  m.caution_fraction[0] = 0.75;
  m.watched[0] = 1;
  put_text("deck wetness at bow", m.name[1]);
  m.quantity[1] = 10;
  m.statistic[1] = limits_t::STATISTIC_PROBABILITY;
  m.unit[1] = limits_t::UNIT_PROBABILITY;
  m.limit[1] = 0.05;
  m.caution_fraction[1] = 0.5;
  m.watched[1] = 1;
  return m;
}

health_t health_at(std::int64_t utime) {
  health_t m{};
  m.utime = utime;
  m.state = health_t::STATE_RUNNING;
  m.cycle_period_s = 1.0;
  m.cycle_last_s = 0.2;
  m.num_cycles = 10;
  m.input_age_s[0] = 60.0;
  m.input_stale_after_s[0] = 5400.0;
  put_text("0.0.0", m.version);
  return m;
}

outlook_t outlook_at(std::int64_t utime, std::int32_t seq) {
  outlook_t m{};
  m.utime = utime;
  m.seq = seq;
  m.num_members = 16;
  m.present_exceeded = 11;
  m.expect_s = 1800.0;
  m.expected_max_roll_deg = 14.4;
  m.expected_max_pitch_deg = 4.2;
  m.expected_max_heave_m = -1.0;
  m.next_criterion = -1;
  m.unknown_share = 0.1;
  m.std_assumed = 9;  // wave height, GM
  m.roll_period_low_s = 15.8;
  m.roll_period_high_s = 19.3;
  m.roll_period_kind = outlook_t::PERIOD_COMPUTED;
  m.change_exceeded[0] = 2;
  m.turn_max_roll_deg[0] = 18.0;
  put_text("Coming to 095 passes beam-on, 18° likely", m.turn_text[0]);
  return m;
}

own_ship_t own_ship_at(std::int64_t utime, double heading_deg, double speed_kn) {
  own_ship_t m{};
  m.utime = utime;
  m.valid = std::int32_t{own_ship_t::VALID_HEADING} | std::int32_t{own_ship_t::VALID_SPEED_THROUGH_WATER};
  m.heading_deg = heading_deg;
  m.speed_through_water_kn = speed_kn;
  return m;
}

sea_state_t sea_from(std::int64_t utime, double dir_from_deg) {
  sea_state_t m{};
  m.utime = utime;
  m.source_kind = sea_state_t::SOURCE_RADAR;
  m.num_systems = 1;
  m.hs_m[0] = 3.2;
  m.period_s[0] = 11.0;
  m.dir_from_deg[0] = dir_from_deg;
  return m;
}

alert_t warning_at(std::int64_t utime) {
  alert_t m{};
  m.utime = utime;
  m.raised_utime = utime;
  m.priority = alert_t::PRIORITY_WARNING;
  m.state = alert_t::STATE_ACTIVE;
  m.alert_id = 1;
  m.instance = 1;
  m.revision = 3;
  m.criterion = -1;
  put_text("Seakeeping limit", m.title);
  put_text("Roll above its limit", m.text);
  return m;
}

comparison_t comparison_at(std::int64_t utime) {
  comparison_t m{};
  m.utime = utime;
  m.window_s = 3600.0;
  m.confidence = comparison_t::CONFIDENCE_LOWERED;
  m.num_lines = 1;
  m.quantity[0] = 3;
  m.state[0] = comparison_t::ABOVE_PREDICTED;
  m.gap_since_s[0] = 7300.0;
  put_text("roll: predicted 3.1°, measured 4.0° over the last hour", m.text[0]);
  return m;
}

Bridge::Bridge(bool speaks_at_once, const std::function<void(Display&)>& before) {
  speaks = speaks_at_once;
  DisplayOptions options;
  options.start_id = "start";
  display_ = std::make_unique<Display>(
      options, [this](std::string_view channel, std::span<const std::uint8_t> bytes) {
        const std::lock_guard lock(mutex_);
        sent_.emplace_back(channel, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
        return true;
      });
  GuardOptions guard;
  guard.token = token_;
  service_ = std::make_unique<HttpService>(*display_, guard);
  if (!service_->start("127.0.0.1", 0)) {
    throw std::runtime_error("no free port");
  }
  if (before) {
    before(*display_);
  }
  turns_ = std::thread([this] {
    while (is_running_) {
      display_->turn(utime_now(), kTurn);
      ++num_turns;
    }
  });
  advisor_ = std::thread([this] {
    while (is_running_) {
      speak();
      for (int i = 0; i < 5 && is_running_; ++i) {
        std::this_thread::sleep_for(kSpeak / 5);
      }
    }
  });
}

Bridge::~Bridge() {
  is_running_ = false;
  turns_.join();
  advisor_.join();
  service_->stop();
}

std::string Bridge::url() const {
  return "http://127.0.0.1:" + std::to_string(service_->port()) + "/";
}

void Bridge::say(const std::function<void(advice_t&)>& change) {
  const std::lock_guard lock(mutex_);
  change_ = change;
}

std::size_t Bridge::num_sent(const std::string& channel) {
  const std::lock_guard lock(mutex_);
  std::size_t num = 0;
  for (const auto& [name, bytes] : sent_) {
    num += name == channel ? 1U : 0U;
  }
  return num;
}

void Bridge::speak() {
  if (!speaks) {
    return;
  }
  const std::int64_t now = utime_now();
  Mailbox& mailbox = display_->mailbox();
  advice_t advice = advice_at(now, ++seq_);
  advice.heading_deg = heading_deg;
  {
    const std::lock_guard lock(mutex_);
    if (change_) {
      change_(advice);
    }
  }
  mailbox.put(limits_at(now));
  mailbox.put(sea_from(now - 60 * kSecond_us, dir_from_deg));
  mailbox.put(own_ship_at(now, heading_deg, 14.2));
  mailbox.put(health_at(now));
  mailbox.put(advice);
  mailbox.put(grid_at(now, seq_));
  if (has_outlook) {
    mailbox.put(outlook_at(now, seq_));
  }
  answer_query();
}

void Bridge::answer_query() {
  const auto query = sent<query_t>("QUERY");
  if (!query || query->query_id == answered_) {
    return;
  }
  answered_ = query->query_id;
  auto response = std::make_unique<response_t>();
  response->query_id = query->query_id;
  response->query_source_id = query->source_id;
  response->limits_digest = 77;
  response->heading_deg = query->heading_deg;
  response->speed_kn = query->speed_kn;
  response->verdict = response_t::VERDICT_CAUTION;
  response->margin = 1.25;
  response->num_systems = 1;
  response->num_quantities = 1;
  response->quantity[0] = 3;
  put_text("G", response->place_name[0]);
  response->unit[0] = response_t::UNIT_DEG;
  response->rms[0] = 4.87;
  response->significant[0] = 9.74;
  response->tm02_s[0] = 17.3;
  response->probability[0] = -1.0;
  response->per_hour[0] = -1.0;
  response->system_share[0][0] = 1.0F;
  response->criterion[0] = 0;
  display_->mailbox().put(*response);
}

}  // namespace quickstrip::test
