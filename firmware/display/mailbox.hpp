// What came off the bus since the display last looked: the newest of each state, and the few things that are
// each of their own (alerts, notes, answers), bounded. The receiving thread copies a message under a lock
// that is otherwise held only for a swap of two pointers: it never waits for a browser, nor for JSON.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>

#include "quickstrip/advice_t.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/comparison_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/health_t.hpp"
#include "quickstrip/limits_t.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/logbook_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/outlook_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/response_t.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {

/// 0.25 MB: not on the stack.
struct Mail {
  std::optional<advice_t> advice;
  std::optional<grid_t> grid;
  std::optional<outlook_t> outlook;
  std::optional<limits_t> limits;
  std::optional<health_t> health;
  std::optional<comparison_t> comparison;
  std::optional<sea_state_t> sea_state;
  std::optional<wave_spectrum_t> wave_spectrum;
  std::optional<own_ship_t> own_ship;
  std::optional<loading_t> loading;
  std::optional<motion_t> motion;
  std::deque<alert_t> alerts;
  std::deque<logbook_t> notes;
  std::deque<response_t> answers;  // to queries; the unasked one of each cycle is not shown
  std::uint64_t num_malformed = 0;
  bool is_empty = true;
};

class Mailbox {
 public:
  void put(const advice_t& m) { put_newest(&Mail::advice, m); }
  void put(const grid_t& m) { put_newest(&Mail::grid, m); }
  void put(const outlook_t& m) { put_newest(&Mail::outlook, m); }
  void put(const limits_t& m) { put_newest(&Mail::limits, m); }
  void put(const health_t& m) { put_newest(&Mail::health, m); }
  void put(const comparison_t& m) { put_newest(&Mail::comparison, m); }
  void put(const sea_state_t& m) { put_newest(&Mail::sea_state, m); }
  void put(const wave_spectrum_t& m) { put_newest(&Mail::wave_spectrum, m); }
  void put(const own_ship_t& m) { put_newest(&Mail::own_ship, m); }
  void put(const loading_t& m) { put_newest(&Mail::loading, m); }
  void put(const motion_t& m) { put_newest(&Mail::motion, m); }
  void put(const alert_t& m) { put_each(&Mail::alerts, m); }
  void put(const logbook_t& m) { put_each(&Mail::notes, m); }
  void put(const response_t& m) {
    if (m.query_id != 0) {
      put_each(&Mail::answers, m);
    }
  }
  void count_malformed();

  /// What came since the last take; `into` is emptied first. False when nothing came within the patience.
  bool take(std::unique_ptr<Mail>& into, std::chrono::milliseconds patience);

 private:
  static constexpr std::size_t kMaxEach = 64;  // between two looks, a tenth of a second apart

  template <typename Message>
  void put_newest(std::optional<Message> Mail::*slot, const Message& message) {
    {
      const std::lock_guard lock(mutex_);
      (*mail_).*slot = message;
      mail_->is_empty = false;
    }
    has_come_.notify_one();
  }
  template <typename Message>
  void put_each(std::deque<Message> Mail::*slot, const Message& message) {
    {
      const std::lock_guard lock(mutex_);
      std::deque<Message>& list = (*mail_).*slot;
      if (list.size() == kMaxEach) {
        list.pop_front();  // the newest count
      }
      list.push_back(message);
      mail_->is_empty = false;
    }
    has_come_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable has_come_;
  std::unique_ptr<Mail> mail_ = std::make_unique<Mail>();
};

}  // namespace quickstrip
