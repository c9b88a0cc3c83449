// The receiving half of the advisor's bus: one thread that does nothing but take messages off LCM's queue,
// decode them and put them into triple buffers, so that the cycle never waits for the bus and the bus never
// for the cycle. The newest message of each channel wins; what does not decode and what is overtaken is
// counted.
//
// Queries and acknowledgements share the rule: of two that come within one cycle the later is answered (their
// senders repeat). The heap is used by liblcm in this thread; the cycle's thread only reads the buffers.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <semaphore>
#include <string>
#include <thread>

#include "firmware/advisor/triple_buffer.hpp"
#include "firmware/session/allow_list.hpp"
#include "firmware/session/inputs.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/sea_forecast_t.hpp"

namespace quickstrip {

/// One channel: the newest message of an admitted sender, and how many did not decode or were another's.
template <typename Message>
struct InboxSlot {
  const AllowList* allowed = nullptr;
  Input input = Input::kSeaState;
  TripleBuffer<Message> newest;
  std::atomic<std::int64_t> malformed{0};
  std::atomic<std::int64_t> foreign{0};
};

/// The channels that are received. 110 kB of messages three times over: not on the stack.
class Inbox {
 public:
  /// Subscribes to PREFIX + names on `bus`, which must outlive this object. What a sender who is not allowed
  /// sends is left out here: in the buffer it would take the place of what the allowed one has sent.
  Inbox(lcm::LCM& bus, const std::string& prefix, const AllowList& allowed);
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  void start();
  void stop();
  /// True once the bus has failed for good (a closed socket): the thread has ended.
  [[nodiscard]] bool has_failed() const { return failed_.load(); }
  /// Counts up with each QS_TIME; the cycle of `--clock log` waits here.
  std::counting_semaphore<>& time_has_come() { return time_has_come_; }

  InboxSlot<sea_state_t> sea_state;
  InboxSlot<wave_spectrum_t> wave_spectrum;
  InboxSlot<own_ship_t> own_ship;
  InboxSlot<loading_t> loading;
  InboxSlot<query_t> query;
  InboxSlot<alert_t> acknowledgement;
  InboxSlot<clock_t> time;
  InboxSlot<motion_t> motion;
  InboxSlot<sea_forecast_t> forecast;

 private:
  template <typename Message>
  void subscribe(const std::string& channel, Input input, InboxSlot<Message>& slot);
  void receive();

  lcm::LCM& bus_;
  AllowList allowed_;
  std::atomic<bool> is_running_{false};
  std::atomic<bool> failed_{false};
  std::counting_semaphore<> time_has_come_{0};
  std::thread thread_;
};

}  // namespace quickstrip
