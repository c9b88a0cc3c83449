#include "firmware/advisor/publisher.hpp"

#include <chrono>

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kLook{100};  // how long a stop may take

}  // namespace

void Publisher::start() {
  is_running_ = true;
  thread_ = std::thread([this] { publish(); });
}

void Publisher::stop() {
  is_running_ = false;
  if (thread_.joinable()) {
    thread_.join();
  }
}

bool Publisher::send(OutChannel channel, std::span<const std::uint8_t> bytes) {
  if (!ring_.push(static_cast<std::uint32_t>(channel), bytes)) {
    return false;
  }
  has_come_.release();  // wakes, never waits
  return true;
}

void Publisher::publish() {
  while (true) {
    const bool was_running = is_running_.load();
    static_cast<void>(has_come_.try_acquire_for(kLook));
    RingMessage message;
    while (ring_.front(message)) {
      if (!bus_.send(static_cast<OutChannel>(message.channel), message.bytes)) {
        refused_.fetch_add(1, std::memory_order_relaxed);
      }
      ring_.pop();
    }
    if (!was_running) {
      return;  // after a last look
    }
  }
}

}  // namespace quickstrip
