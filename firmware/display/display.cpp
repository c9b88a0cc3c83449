#include "firmware/display/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "firmware/display/entry_form.hpp"
#include "firmware/display/json_parts.hpp"
#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds kBeatEvery{500};
constexpr std::chrono::milliseconds kSettle{40};  // grid and outlook follow their advice at once
constexpr int kMaxLooks = 4;

std::string dump(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

Answer refused(const FieldErrors& errors) {
  return {422, errors_json(errors)};
}

Answer fault(int status, const char* text) {
  return {status, errors_json({{"", text}})};
}

Answer done(const json& value = json::object()) {
  return {200, dump(value)};
}

/// The node of the grid nearest to the asked one.
json nearest_cell(const grid_t& grid, const query_t& query) {
  if (grid.num_speeds == 0) {
    return nullptr;
  }
  int speed = 0;
  for (int s = 1; s < grid.num_speeds; ++s) {
    const auto gap = [&](int i) { return std::abs(static_cast<double>(grid.speed_kn[i]) - query.speed_kn); };
    speed = gap(s) < gap(speed) ? s : speed;
  }
  const int heading = static_cast<int>(std::lround(query.heading_deg / 360.0 * grid.num_headings));
  return cell_json(grid, speed, heading % grid.num_headings);
}

}  // namespace

Display::Display(DisplayOptions options, SendMessage send)
    : options_(std::move(options)),
      send_(std::move(send)),
      shown_(std::make_unique<Shown>()),
      entries_(options_.source_id) {}

FrameContext Display::context(std::int64_t utime) const {
  return {utime, options_.start_id, options_.is_recorded, send_ != nullptr};
}

template <typename Message>
bool Display::send(std::string_view channel, const Message& message) {
  std::array<std::uint8_t, 4096> bytes{};  // above the largest that we send, loading_t
  const auto encoded = encode(message, bytes);
  return !encoded.empty() && send_ && send_(channel, encoded);
}

bool Display::publish(const DueMessages& due) {
  bool is_sent = true;
  if (due.sea) {
    is_sent = send("SEA_STATE", *due.sea) && is_sent;
  }
  if (due.loading) {
    is_sent = send("LOADING", *due.loading) && is_sent;
  }
  for (const logbook_t& note : due.notes) {
    is_sent = send("LOGBOOK", note) && is_sent;
  }
  return is_sent;
}

void Display::turn(std::int64_t utime, std::chrono::milliseconds patience) {
  bool has_mail = mailbox_.take(mail_, patience);
  const auto now = Shown::Clock::now();
  Changed changed;
  const auto note = [&changed](const Changed& more) {
    changed.state = changed.state || more.state;
    changed.grid = changed.grid || more.grid;
    changed.trends = changed.trends || more.trends;
    changed.answer = changed.answer || more.answer;
  };
  const std::unique_lock lock(mutex_);
  for (int look = 0; has_mail && look < kMaxLooks; ++look) {
    note(take_in(*mail_, now, *shown_));
    const bool waits_for_outlook = !options_.is_recorded && shown_->outlook && shown_->advice &&
                                   shown_->outlook->seq != shown_->advice->seq;
    has_mail = waits_for_outlook && mailbox_.take(mail_, kSettle);
  }
  DueMessages due;
  entries_.repeat(utime, due);
  publish(due);
  changed.state = changed.state || drop_silent_alerts(now, *shown_) || std::exchange(has_new_entry_, false);
  if (changed.state) {
    hub_.publish(Topic::kState, state_frame(*shown_, entries_.in_force(), context(utime)));
  }
  if (changed.grid) {
    hub_.publish(Topic::kGrid, grid_frame(*shown_));
  }
  if (changed.trends) {
    hub_.publish(Topic::kTrends, trends_frame(*shown_));
  }
  if (changed.answer) {
    hub_.publish(Topic::kAnswer, answer_frame(*shown_));
  }
  if (changed.state || now - beat_sent_ >= kBeatEvery) {
    beat_sent_ = now;
    hub_.publish(Topic::kBeat, beat_frame(*shown_, context(utime), now));
  }
}

Answer Display::post(std::string_view path, std::string_view body, std::int64_t utime) {
  struct Route {
    std::string_view path;
    Answer (Display::*post)(std::string_view, std::int64_t);
  };
  static constexpr std::array kRoutes{Route{"sea", &Display::read_back_sea},
                                      Route{"loading", &Display::read_back_loading},
                                      Route{"confirm", &Display::confirm},
                                      Route{"withdraw", &Display::withdraw},
                                      Route{"mark", &Display::mark},
                                      Route{"query", &Display::query},
                                      Route{"acknowledge", &Display::acknowledge}};
  const auto* const found =
      std::find_if(kRoutes.begin(), kRoutes.end(), [&](const Route& route) { return route.path == path; });
  if (found == kRoutes.end()) {
    return fault(404, "no such form");
  }
  if (options_.is_recorded && path != "query") {
    return fault(409, "this is a recorded moment: nothing can be entered");
  }
  const std::lock_guard lock(mutex_);
  return (this->*found->post)(body, utime);
}

Answer Display::read_back_sea(std::string_view body, std::int64_t utime) {
  SeaEntry entry;
  if (const FieldErrors errors = read_sea(body, utime, entry); !errors.empty()) {
    return refused(errors);
  }
  const std::string words = entry.words;
  return done({{"words", words}, {"ticket", pending_.keep(std::move(entry), utime)}});
}

Answer Display::read_back_loading(std::string_view body, std::int64_t utime) {
  LoadingEntry entry;
  if (const FieldErrors errors = read_loading(body, utime, options_.hull, entry); !errors.empty()) {
    return refused(errors);
  }
  const std::string words = entry.words;
  return done({{"words", words}, {"ticket", pending_.keep(std::move(entry), utime)}});
}

Answer Display::confirm(std::string_view body, std::int64_t utime) {
  std::string ticket;
  if (const FieldErrors errors = read_confirm(body, ticket); !errors.empty()) {
    return refused(errors);
  }
  auto entry = pending_.take(ticket, utime);
  if (!entry) {
    return fault(409, "that was read back too long ago: please enter it again");
  }
  DueMessages due;
  if (auto* const sea = std::get_if<SeaEntry>(&*entry)) {
    entries_.enter(std::move(*sea), due);
  } else {
    entries_.enter(std::move(std::get<LoadingEntry>(*entry)), due);
  }
  has_new_entry_ = true;
  return publish(due) ? done() : fault(503, "the bus did not take it; it is sent again within 30 s");
}

Answer Display::withdraw(std::string_view body, std::int64_t utime) {
  WithdrawEntry entry;
  if (const FieldErrors errors = read_withdraw(body, entry); !errors.empty()) {
    return refused(errors);
  }
  DueMessages due;
  if (!entries_.withdraw(entry.kind, entry.author, utime, due)) {
    return fault(409, "nothing of that kind is in force");
  }
  has_new_entry_ = true;
  return publish(due) ? done() : fault(503, "the bus did not take it: please try again");
}

Answer Display::mark(std::string_view body, std::int64_t utime) {
  MarkEntry entry;
  if (const FieldErrors errors = read_mark(body, entry); !errors.empty()) {
    return refused(errors);
  }
  DueMessages due;
  entries_.mark(entry.author, entry.text, utime, due);
  return publish(due) ? done() : fault(503, "the bus did not take it: please try again");
}

Answer Display::query(std::string_view body, std::int64_t utime) {
  query_t query{};
  if (const FieldErrors errors = read_query(body, query); !errors.empty()) {
    return refused(errors);
  }
  query.utime = utime;
  query.seq = ++seq_;
  query.source_id = options_.source_id;
  last_query_ = std::max(last_query_ + 1, utime);  // unique over starts too
  query.query_id = last_query_;
  const bool is_asked = !options_.is_recorded && send("QUERY", query);
  return done({{"query_id", is_asked ? json(std::to_string(query.query_id)) : json(nullptr)},
               {"cell", shown_->grid ? nearest_cell(*shown_->grid, query) : json(nullptr)}});
}

Answer Display::acknowledge(std::string_view body, std::int64_t utime) {
  AcknowledgeEntry entry;
  if (const FieldErrors errors = read_acknowledge(body, entry); !errors.empty()) {
    return refused(errors);
  }
  const auto found = shown_->alerts.find({entry.alert_id, entry.instance});
  if (found == shown_->alerts.end() || found->second.revision != entry.revision) {
    return fault(409, "the alert has changed meanwhile");
  }
  alert_t asked = found->second;
  asked.utime = utime;
  asked.seq = ++seq_;
  asked.source_id = options_.source_id;
  asked.state =
      entry.silence_only ? std::int8_t{alert_t::STATE_SILENCED} : std::int8_t{alert_t::STATE_ACKNOWLEDGED};
  return send("ALERT_ACK", asked) ? done() : fault(503, "the bus did not take it: please try again");
}

}  // namespace quickstrip
