// The display without sockets and without a bus: mail in, frames out, entries judged.
//
// Threads: `turn` is called by one thread over and over; `post` and `newest` by any. What they share lies
// under a mutex that is never held while anything is sent to a browser; the bus's thread only touches the
// mailbox.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "core/hull/hull.hpp"
#include "firmware/display/event_hub.hpp"
#include "firmware/display/frames.hpp"
#include "firmware/display/mailbox.hpp"
#include "firmware/display/manual_entries.hpp"
#include "firmware/display/pending_entries.hpp"
#include "firmware/display/shown.hpp"

namespace quickstrip {

/// Publishes on the bus; false when the bytes are known to be lost.
using SendMessage = std::function<bool(std::string_view channel, std::span<const std::uint8_t> bytes)>;

struct DisplayOptions {
  std::int16_t source_id = 2;
  const Hull* hull = nullptr;  // checks loadings; nullptr: ranges of any ship
  bool is_recorded = false;    // a moment of a log: nothing can be entered
  std::string start_id;
};

struct Answer {
  int status = 200;
  std::string body;  // JSON
};

class Display {
 public:
  Display(DisplayOptions options, SendMessage send);

  Mailbox& mailbox() { return mailbox_; }
  EventHub& hub() { return hub_; }

  /// Takes what came within `patience` and makes frames of it; `utime` is our clock's.
  void turn(std::int64_t utime, std::chrono::milliseconds patience);

  /// A form of the page: PATH without "/api/", "sea".
  Answer post(std::string_view path, std::string_view body, std::int64_t utime);

 private:
  Answer read_back_sea(std::string_view body, std::int64_t utime);
  Answer read_back_loading(std::string_view body, std::int64_t utime);
  Answer confirm(std::string_view body, std::int64_t utime);
  Answer withdraw(std::string_view body, std::int64_t utime);
  Answer mark(std::string_view body, std::int64_t utime);
  Answer query(std::string_view body, std::int64_t utime);
  Answer acknowledge(std::string_view body, std::int64_t utime);
  bool publish(const DueMessages& due);
  template <typename Message>
  bool send(std::string_view channel, const Message& message);
  [[nodiscard]] FrameContext context(std::int64_t utime) const;

  DisplayOptions options_;
  SendMessage send_;
  Mailbox mailbox_;
  EventHub hub_;
  std::unique_ptr<Mail> mail_;
  Shown::Clock::time_point beat_sent_;

  std::mutex mutex_;  // of all below
  std::unique_ptr<Shown> shown_;
  ManualEntries entries_;
  PendingEntries pending_;
  std::int64_t last_query_ = 0;
  std::int32_t seq_ = 0;
  bool has_new_entry_ = false;
};

}  // namespace quickstrip
