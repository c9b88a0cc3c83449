// The sending half of the advisor's bus: the cycle puts its messages into a ring and goes on; one thread
// takes them out in order and publishes them. So a bus that is slow or gone never holds up a cycle. liblcm's
// lock and its system calls are this thread's alone.
//
// By the machine's clock a message that finds the ring full is lost and counted (health's publish_failures).
// By log time nothing may be lost and nothing is late: has_room_for_a_cycle says when to go on.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <semaphore>
#include <thread>

#include "firmware/advisor/message_ring.hpp"
#include "firmware/session/outbox.hpp"

namespace quickstrip {

class Publisher final : public Outbox {
 public:
  /// Of the ring: five of the largest cycles and more are kept while the bus stalls (tests/advisor).
  static constexpr std::size_t kBytes = 1U << 20U;

  /// `bus` is used by the publishing thread alone; it must outlive this object.
  explicit Publisher(Outbox& bus) : bus_(bus) {}
  ~Publisher() override { stop(); }

  void start();
  /// After what is in the ring has been given to the bus.
  void stop();

  /// From the cycle's thread.
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] bool has_room_for_a_cycle() const { return ring_.free() >= kBytes / 2; }

  /// Messages that the bus refused. Any thread.
  [[nodiscard]] std::int64_t num_refused_by_bus() const { return refused_.load(std::memory_order_relaxed); }

 private:
  void publish();

  Outbox& bus_;
  MessageRing<kBytes> ring_;
  std::counting_semaphore<> has_come_{0};
  std::atomic<bool> is_running_{false};
  std::atomic<std::int64_t> refused_{0};
  std::thread thread_;
};

}  // namespace quickstrip
