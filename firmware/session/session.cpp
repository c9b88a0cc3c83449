#include "firmware/session/session.hpp"

#include <algorithm>
#include <bit>

#include "core/strip/section_table.hpp"
#include "msgs/convert/advice_message.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/limits_message.hpp"
#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr Conversion kForeign{Refusal::kForeignSource, "source_id", -1};

// A number that tells two runs apart by their hull table, too; without one it stays as it is.
std::uint64_t with_table(std::uint64_t number, const HullTable* table) {
  if (table == nullptr) {
    return number;
  }
  Fnv1a fnv;
  fnv.add(std::bit_cast<double>(number));
  fnv.add(std::bit_cast<double>(table->checksum()));
  return fnv.value();
}

}  // namespace

void Session::set_digest_of_hull(const Loading& loading) {
  const auto of_hull = static_cast<std::uint64_t>(hull_digest(*hull_, loading));
  hull_digest_ = static_cast<std::int64_t>(with_table(of_hull, options_.table));
}

SelfTestItem Session::self_test(const HullTable* table, Hull& barge) {
  note_self_test(run_self_test(advisor_, barge, table));
  return self_test_failed_;
}

Status Session::configure(const Hull& hull, const Criteria& criteria, const SessionOptions& options) {
  hull_ = &hull;
  criteria_ = criteria;
  options_ = options;
  inputs_.configure(hull, options.stale_after);
  // Inputs need a while to come in after a start: no alert on their absence before they would be stale.
  alerts_.configure(options.source_id, options.stale_after.own_ship_s);
  queries_.clear();
  forget_predicted();
  is_comparison_due_ = false;
  uncertainty_ = StatedUncertainty{};
  output_ = nullptr;
  set_digest_of_hull(hull.loading);
  table_checksum_ = static_cast<std::int64_t>(with_table(section_table_checksum(), options.table));
  cycle_ = 0;
  response_seq_ = 0;
  limits_sent_ = 0;
  health_sent_ = 0;
  publish_failures_ = 0;
  figures_ = {};
  limits_ = limits_t{};
  to_message(criteria, hull, options.profile.view(), limits_);
  limits_.seq = 1;
  limits_.source_id = options.source_id;
  limits_change_ = logbook_t{};
  is_limits_change_due_ = false;
  return advisor_.configure(hull, criteria, options.method, {}, options.table);
}

Conversion Session::accept(const sea_state_t& message, std::int64_t now, InputUse use) {
  return !admits(Input::kSeaState, message.source_id) ? kForeign : inputs_.accept(message, now, use);
}

Conversion Session::accept(const wave_spectrum_t& message, std::int64_t now, InputUse use) {
  return !admits(Input::kWaveSpectrum, message.source_id) ? kForeign : inputs_.accept(message, now, use);
}

Conversion Session::accept(const own_ship_t& message, std::int64_t now, InputUse use) {
  return !admits(Input::kOwnShip, message.source_id) ? kForeign : inputs_.accept(message, now, use);
}

Conversion Session::accept(const loading_t& message, std::int64_t now, InputUse use) {
  return !admits(Input::kLoading, message.source_id) ? kForeign : inputs_.accept(message, now, use);
}

Conversion Session::accept(const query_t& message, std::int64_t /*now*/) {
  if (!admits(Input::kQuery, message.source_id)) {
    return kForeign;
  }
  Query query;
  const Conversion conversion = to_query(message, query);
  InputCounters& counters = inputs_.counters(Input::kQuery);
  counters.count(conversion);
  if (conversion.ok() && !queries_.push_back(query)) {
    ++counters.dropped;
  }
  return conversion;
}

Conversion Session::accept(const alert_t& acknowledgement, std::int64_t now) {
  if (!admits(Input::kAlertAck, acknowledgement.source_id)) {
    return kForeign;
  }
  const Conversion conversion = alerts_.accept(acknowledgement, now);
  inputs_.counters(Input::kAlertAck).count(conversion);
  return conversion;
}

/// One from the future by more than the tolerance is refused, as HeldInput does.
Conversion Session::count_measured(Input input, const Conversion& conversion, std::int64_t utime,
                                   std::int64_t now) {
  const bool is_early =
      conversion.ok() && !(seconds_between(utime, now) >= -options_.stale_after.future_tolerance_s);
  const Conversion result = is_early ? Conversion{Refusal::kFromTheFuture, "utime"} : conversion;
  count(input, result);
  return result;
}

Conversion Session::accept(const motion_t& message, std::int64_t now) {
  if (!admits(Input::kMotion, message.source_id)) {
    return kForeign;
  }
  const std::int64_t former = inputs_.motion_message().utime;
  const Conversion conversion = inputs_.accept(message, now);
  is_comparison_due_ = is_comparison_due_ || (conversion.ok() && inputs_.motion_message().utime != former);
  return conversion;
}

Conversion Session::accept(const sea_forecast_t& message, std::int64_t now) {
  if (!admits(Input::kSeaForecast, message.source_id)) {
    return kForeign;
  }
  return count_measured(Input::kSeaForecast, check_forecast(message), message.utime, now);
}

Conversion Session::accept(const clock_t& message) {
  if (!admits(Input::kTime, message.source_id)) {
    return kForeign;
  }
  const Conversion conversion = check_clock(message);
  count(Input::kTime, conversion);
  return conversion;
}

void Session::count(Input input, const Conversion& conversion, std::int64_t num) {
  inputs_.counters(input).count(conversion, num);
}

bool Session::admits(Input input, std::int16_t source_id) {
  const bool is_allowed = options_.allowed.admits(input, source_id);
  if (!is_allowed) {
    count(input, kForeign);
  }
  return is_allowed;
}

/// Which input stands in the way, if any: the ship herself first, then where she goes, then the sea.
Fitness Session::judge(std::int64_t now, Input& sea_in_force) const {
  const Fitness sea = inputs_.sea(now, sea_in_force);
  if (self_test_failed_ != SelfTestItem::kNone) {
    Fitness unfit{.reason = NoAdvice::kSelfTestFailed};
    unfit.detail.self_test = message(self_test_failed_);
    return unfit;
  }
  if (const Fitness loading = inputs_.loading(now); !loading.ok()) {
    return loading;
  }
  if (const Fitness ship = inputs_.own_ship(now); !ship.ok()) {
    return ship;
  }
  return sea;
}

const StepOutput& Session::step(std::int64_t now, const Fitness& fitness, Input sea_in_force) {
  const bool is_spectrum = sea_in_force == Input::kWaveSpectrum;
  StepInputs step_inputs;
  step_inputs.sea_state = is_spectrum ? nullptr : &inputs_.sea_state().sea;
  step_inputs.spectrum = is_spectrum ? &inputs_.wave_spectrum() : nullptr;
  step_inputs.own_ship = &inputs_.ship().ship;
  step_inputs.loading = &inputs_.present_loading();
  step_inputs.no_advice = fitness.reason;
  step_inputs.sea_source = inputs_.sea_state().source_kind;
  step_inputs.time = seconds_between(0, now);
  step_inputs.motion = inputs_.motion(now);
  step_inputs.ensemble_members = options_.ensemble_per_cycle;
  if (fitness.ok()) {
    uncertainty_ = inputs_.uncertainty(sea_in_force, advisor_.loading_summary().hydrostatics.gm);
    step_inputs.uncertainty = uncertainty_.of;
  }
  return advisor_.step(step_inputs);
}

void Session::note_limits_change(std::string_view author, std::string_view text) {
  limits_change_.kind = logbook_t::KIND_LIMITS_CHANGED;
  limits_change_.digest = limits_.digest;
  put_text(author, limits_change_.author);
  put_text(text, limits_change_.text);
  is_limits_change_due_ = true;
}

void Session::cycle(std::int64_t now, Outbox& outbox) {
  ++cycle_;
  Input sea_in_force = Input::kWaveSpectrum;
  const Fitness fitness = judge(now, sea_in_force);
  output_ = &step(now, fitness, sea_in_force);
  send_limits(now, outbox);
  send_limits_change(now, outbox);
  fill_advice(now, *output_, fitness, sea_in_force);
  send(OutChannel::kAdvice, advice_, outbox);
  send_grid(now, outbox);
  send_outlook(now, outbox);
  send_responses(now, outbox);
  send_comparison(now, outbox);
  send_alerts(now, outbox);
  send_health_when_due(now, outbox);
}

void Session::rebuild() {
  output_ = nullptr;  // its memory serves the rebuild
  const Status status = advisor_.rebuild();
  if (!status) {
    return;  // the next cycles say that the loading is implausible
  }
  set_digest_of_hull(inputs_.present_loading());
}

}  // namespace quickstrip
