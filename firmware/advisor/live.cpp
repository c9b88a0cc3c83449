#include "firmware/advisor/live.hpp"

#include <algorithm>

#include "firmware/advisor/standard_streams.hpp"
#include "firmware/heap_watch/heap_watch.hpp"

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook{100};  // how long a stop may take

std::int64_t system_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

double seconds_since(Clock::time_point start) {
  return seconds(Clock::now() - start);
}

std::size_t index(Input input) {
  return static_cast<std::size_t>(input);
}

}  // namespace

Live::Live(lcm::LCM& bus, const std::string& prefix, Session& session, const SessionOptions& options,
           InputKeeper* keeper)
    : session_(session),
      options_(options),
      keeper_(keeper),
      inbox_(bus, prefix, options.allowed),
      bus_(bus, prefix) {
  figures_.started_utime = system_utime();
}

Live::~Live() {
  is_stop_asked_ = true;
  if (cycle_thread_.joinable()) {
    cycle_thread_.join();
  }
}

bool Live::run(const LiveOptions& options, const std::atomic<bool>& stop, std::string& why_not) {
  why_not.clear();
  if (options.real_time != RealTime::kOff) {
    const RealTimeResult locked = lock_memory();
    write_line(locked.line);
    if (options.real_time == RealTime::kOn && !locked.is_whole) {
      why_not = locked.line;
      return true;
    }
  }
  inbox_.start();
  publisher_.start();
  journal_writer_.start();
  watch_.sample();
  const RealTimeResult& scheduled = start_cycle_thread(options);
  if (options.real_time != RealTime::kOff) {
    write_line(scheduled.line);
  }
  if (options.real_time == RealTime::kOn && !scheduled.is_whole) {
    why_not = scheduled.line;
  }
  Clock::time_point sampled = Clock::now();
  while (!stop.load() && !inbox_.has_failed() && why_not.empty()) {
    watch_.tell();
    if (Clock::now() - sampled >= std::chrono::seconds(1)) {
      sampled = Clock::now();
      watch_.sample();
    }
    std::this_thread::sleep_for(kLook);
  }
  watch_.tell_stopping();
  is_stop_asked_ = true;
  cycle_thread_.join();
  publisher_.stop();
  journal_writer_.stop();
  inbox_.stop();
  tell_totals();
  return !inbox_.has_failed();
}

/// Waits until the thread has its priority, or not.
const RealTimeResult& Live::start_cycle_thread(const LiveOptions& options) {
  cycle_thread_ = std::thread([this, options] { run_cycle_thread(options); });
  is_scheduled_.acquire();
  return scheduled_;
}

void Live::run_cycle_thread(const LiveOptions& options) {
  prefault_stack();
  if (options.real_time != RealTime::kOff) {
    scheduled_ = schedule_in_real_time(options.priority);
  }
  is_scheduled_.release();
  heap_calls_before_ = heap_calls_of_this_thread();
  if (options_.log_clock) {
    run_by_log_time();
  } else {
    session_.announce(system_utime(), publisher_);
    run_by_system_clock();
  }
  figures_.is_stopping = true;
  session_.set_run_figures(figures_);
  session_.announce(options_.log_clock ? session_.advice().utime : system_utime(), publisher_);
}

void Live::run_by_system_clock() {
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.cycle_period_s));
  Clock::time_point next = Clock::now();
  while (!is_stop_asked_.load()) {
    watch_.note_alive();
    const Clock::time_point now = Clock::now();
    if (now < next) {
      sleep_until(std::min<Clock::time_point>(next, now + kLook));
      continue;
    }
    const std::int64_t utime = system_utime();
    const ThreadUsage used = cycle(utime);
    const Clock::time_point end = Clock::now();
    const double late_s = seconds(now - next);
    next += period;
    if (end >= next) {  // a missed deadline is counted, not caught up with
      ++figures_.num_deadline_misses;
      missed_.note({utime, seconds(period), late_s, seconds(end - now), used.processor_s, used.num_waits});
      next = end + period;
    }
    journal_.follow(missed_, seconds(end.time_since_epoch()));
  }
  journal_.note(missed_);
}

/// What shows the claim, once it can no longer change.
void Live::tell_totals() const {
  tell(
      "{} cycles, {} deadlines missed; within a cycle the processor was given up {} times, {} pages "
      "were touched for the first time, the heap was called {} times",
      num_cycles_, figures_.num_deadline_misses, usage_.num_waits, usage_.num_page_faults,
      figures_.heap_calls_in_cycle);
}

void Live::run_by_log_time() {
  while (!is_stop_asked_.load()) {
    watch_.note_alive();
    if (!publisher_.has_room_for_a_cycle()) {  // the bus is behind: by log time nothing is lost
      sleep_until(Clock::now() + std::chrono::milliseconds(1));
      continue;
    }
    if (!inbox_.time_has_come().try_acquire_for(kLook) || !inbox_.time.newest.take()) {
      continue;
    }
    const clock_t& time = inbox_.time.newest.front();
    if (session_.accept(time).ok()) {  // refusals are counted and told
      cycle(time.utime);
    }
  }
}

template <typename Message>
void Live::count_lost(InboxSlot<Message>& slot, Input input) {
  const std::int64_t malformed = slot.malformed.load(std::memory_order_relaxed);
  session_.count(input, {Refusal::kMalformed, "", -1}, malformed - malformed_seen_[index(input)]);
  malformed_seen_[index(input)] = malformed;
  const std::int64_t foreign = slot.foreign.load(std::memory_order_relaxed);
  session_.count(input, {Refusal::kForeignSource, "source_id", -1}, foreign - foreign_seen_[index(input)]);
  foreign_seen_[index(input)] = foreign;
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

void Live::note_times(double took_s) {
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
}

ThreadUsage Live::cycle(std::int64_t now) {
  const ThreadUsage before = usage_of_this_thread();
  const Clock::time_point start = Clock::now();
  take_inputs(now);
  figures_.page_faults = watch_.page_faults();
  figures_.resident_bytes = watch_.resident_bytes();
  figures_.num_refused_by_bus = publisher_.num_refused_by_bus();
  figures_.heap_calls_in_cycle = heap_calls_of_this_thread() - heap_calls_before_;
  session_.set_run_figures(figures_);
  session_.cycle(now, publisher_);
  note_times(seconds_since(start));
  const advice_t& advice = session_.advice();
  watch_.note_cycle(advice.no_advice, advice.verdict);
  journal_.follow(advice);
  journal_.follow(session_.inputs(), now);
  if (keeper_ != nullptr) {
    keeper_->hand_over(session_.inputs());
  }
  if (session_.is_rebuild_due()) {
    const Clock::time_point rebuild_start = Clock::now();
    session_.rebuild();
    figures_.rebuild_last_s = seconds_since(rebuild_start);
  }
  const ThreadUsage used = usage_of_this_thread() - before;
  usage_ += used;
  return used;
}

}  // namespace quickstrip
