// The display's ends of the bus: a thread that takes messages off it into the mailbox, and a sender.
#pragma once

#include <atomic>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "firmware/display/mailbox.hpp"

namespace quickstrip {

class BusLink {
 public:
  /// Subscribes to PREFIX + shown_channels(). `bus` and `mailbox` must outlive this object.
  BusLink(lcm::LCM& bus, std::string prefix, Mailbox& mailbox);
  ~BusLink();
  BusLink(const BusLink&) = delete;
  BusLink& operator=(const BusLink&) = delete;

  /// `channel` without the prefix. False when the bytes are known to be lost. Any thread but one at a time.
  bool send(std::string_view channel, std::span<const std::uint8_t> bytes);

  /// True once the bus has failed for good: the thread has ended.
  [[nodiscard]] bool has_failed() const { return has_failed_.load(); }

 private:
  void receive();

  lcm::LCM& bus_;
  std::string prefix_;
  Mailbox& mailbox_;
  std::atomic<bool> is_running_{true};
  std::atomic<bool> has_failed_{false};
  std::thread thread_;
};

}  // namespace quickstrip
