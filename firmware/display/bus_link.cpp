#include "firmware/display/bus_link.hpp"

#include <utility>

#include "firmware/display/mail_route.hpp"

namespace quickstrip {
namespace {

constexpr int kQueueCapacity = 256;  // messages between two turns of the receiving thread
constexpr int kWait_ms = 100;        // how long a stop may take
constexpr int kMaxFailuresInRow = 10;

}  // namespace

BusLink::BusLink(lcm::LCM& bus, std::string prefix, Mailbox& mailbox)
    : bus_(bus), prefix_(std::move(prefix)), mailbox_(mailbox) {
  for (const std::string_view channel : shown_channels()) {
    lcm::Subscription* const subscription = bus_.subscribeFunction<BusLink*>(
        prefix_ + std::string(channel),
        [](const lcm::ReceiveBuffer* buffer, const std::string& name, BusLink* link) {
          const auto* const bytes = static_cast<const std::uint8_t*>(buffer->data);
          route(std::string_view(name).substr(link->prefix_.size()), {bytes, buffer->data_size},
                link->mailbox_);
        },
        this);
    subscription->setQueueCapacity(kQueueCapacity);
  }
  thread_ = std::thread([this] { receive(); });
}

BusLink::~BusLink() {
  is_running_ = false;
  thread_.join();
}

bool BusLink::send(std::string_view channel, std::span<const std::uint8_t> bytes) {
  return bus_.publish(prefix_ + std::string(channel), bytes.data(),
                      static_cast<unsigned int>(bytes.size())) == 0;
}

void BusLink::receive() {
  int failures = 0;
  while (is_running_.load(std::memory_order_relaxed)) {
    failures = bus_.handleTimeout(kWait_ms) < 0 ? failures + 1 : 0;
    if (failures >= kMaxFailuresInRow) {
      has_failed_ = true;
      return;
    }
  }
}

}  // namespace quickstrip
