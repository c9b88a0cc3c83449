#include "firmware/advisor/live.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook{100};  // how long a stop may take

std::int64_t system_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::size_t index(Input input) {
  return static_cast<std::size_t>(input);
}

}  // namespace

Live::Live(lcm::LCM& bus, const std::string& prefix, Session& session, const SessionOptions& options,
           InputKeeper* keeper)
    : session_(session), options_(options), keeper_(keeper), inbox_(bus, prefix), outbox_(bus, prefix) {
  figures_.started_utime = system_utime();
}

bool Live::run(const std::atomic<bool>& stop) {
  inbox_.start();
  const bool is_well = options_.log_clock ? run_by_log_time(stop) : run_by_system_clock(stop);
  inbox_.stop();
  return is_well;
}

bool Live::run_by_system_clock(const std::atomic<bool>& stop) {
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.cycle_period_s));
  Clock::time_point next = Clock::now();
  while (!stop.load()) {
    if (inbox_.has_failed()) {
      return false;
    }
    const Clock::time_point now = Clock::now();
    if (now < next) {
      std::this_thread::sleep_for(std::min<Clock::duration>(next - now, kLook));
      continue;
    }
    cycle(system_utime());
    next += period;
    if (Clock::now() >= next) {  // a missed deadline is counted, not caught up with
      ++figures_.num_deadline_misses;
      next = Clock::now() + period;
    }
  }
  return true;
}

bool Live::run_by_log_time(const std::atomic<bool>& stop) {
  while (!stop.load()) {
    if (inbox_.has_failed()) {
      return false;
    }
    if (!inbox_.time_has_come().try_acquire_for(kLook) || !inbox_.time.newest.take()) {
      continue;
    }
    const clock_t& time = inbox_.time.newest.front();
    if (session_.accept(time).ok()) {  // refusals are counted and told
      cycle(time.utime);
    }
  }
  return true;
}

template <typename Message>
void Live::count_lost(InboxSlot<Message>& slot, Input input) {
  const std::int64_t malformed = slot.malformed.load(std::memory_order_relaxed);
  for (std::int64_t& seen = malformed_seen_[index(input)]; seen < malformed; ++seen) {
    session_.count(input, {Refusal::kMalformed, "", -1});
  }
  figures_.dropped_before[index(input)] = slot.newest.overtaken();
}

template <typename Message>
void Live::take(InboxSlot<Message>& slot, Input input, std::int64_t now) {
  count_lost(slot, input);
  if (slot.newest.take()) {
    static_cast<void>(session_.accept(slot.newest.front(), now));  // refusals are counted and told
  }
}

void Live::take_inputs(std::int64_t now) {
  take(inbox_.sea_state, Input::kSeaState, now);
  take(inbox_.wave_spectrum, Input::kWaveSpectrum, now);
  take(inbox_.own_ship, Input::kOwnShip, now);
  take(inbox_.loading, Input::kLoading, now);
  take(inbox_.query, Input::kQuery, now);
  take(inbox_.acknowledgement, Input::kAlertAck, now);
  take(inbox_.motion, Input::kMotion, now);
  take(inbox_.forecast, Input::kSeaForecast, now);
  count_lost(inbox_.time, Input::kTime);
}

void Live::cycle(std::int64_t now) {
  const Clock::time_point start = Clock::now();
  take_inputs(now);
  session_.set_run_figures(figures_);
  session_.cycle(now, outbox_);
  const double took_s = seconds_since(start);
  last_cycles_s_[static_cast<std::size_t>(num_cycles_) % last_cycles_s_.size()] = took_s;
  ++num_cycles_;
  const auto num = std::min(static_cast<std::size_t>(num_cycles_), last_cycles_s_.size());
  double sum_s = 0.0;
  for (std::size_t i = 0; i < num; ++i) {
    sum_s += last_cycles_s_[i];
  }
  figures_.cycle_last_s = took_s;
  figures_.cycle_mean_s = sum_s / static_cast<double>(num);
  figures_.cycle_max_s = std::max(figures_.cycle_max_s, took_s);
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) == 0) {
    figures_.page_faults = usage.ru_minflt + usage.ru_majflt;
    figures_.resident_bytes = usage.ru_maxrss * 1024;  // the most it ever was
  }
  journal_.follow(session_.advice());
  journal_.follow(session_.inputs(), now);
  if (keeper_ != nullptr) {
    keeper_->hand_over(session_.inputs());
  }
  if (session_.is_rebuild_due()) {
    const Clock::time_point rebuild_start = Clock::now();
    session_.rebuild();
    figures_.rebuild_last_s = seconds_since(rebuild_start);
  }
}

}  // namespace quickstrip
