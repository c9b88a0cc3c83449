#include "firmware/advisor/inbox.hpp"

#include <span>

#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

constexpr int kQueueCapacity = 256;  // messages between two turns of the receiving thread
constexpr int kWait_ms = 100;        // how long a stop may take
constexpr int kMaxFailuresInRow = 10;

template <typename Message>
void take(const lcm::ReceiveBuffer& buffer, InboxSlot<Message>& slot) {
  const auto* const bytes = static_cast<const std::uint8_t*>(buffer.data);
  Message& message = slot.newest.back();
  if (!decode(std::span<const std::uint8_t>{bytes, buffer.data_size}, message)) {
    slot.malformed.fetch_add(1, std::memory_order_relaxed);
  } else if (!slot.allowed->admits(slot.input, message.source_id)) {
    slot.foreign.fetch_add(1, std::memory_order_relaxed);
  } else {
    slot.newest.publish();
  }
}

}  // namespace

Inbox::Inbox(lcm::LCM& bus, const std::string& prefix, const AllowList& allowed)
    : bus_(bus), allowed_(allowed) {
  subscribe(prefix + "SEA_STATE", Input::kSeaState, sea_state);
  subscribe(prefix + "WAVE_SPECTRUM", Input::kWaveSpectrum, wave_spectrum);
  subscribe(prefix + "OWN_SHIP", Input::kOwnShip, own_ship);
  subscribe(prefix + "LOADING", Input::kLoading, loading);
  subscribe(prefix + "QUERY", Input::kQuery, query);
  subscribe(prefix + "ALERT_ACK", Input::kAlertAck, acknowledgement);
  time.allowed = &allowed_;
  time.input = Input::kTime;
  lcm::Subscription* const clock = bus_.subscribeFunction<Inbox*>(
      prefix + "TIME",
      [](const lcm::ReceiveBuffer* buffer, const std::string&, Inbox* inbox) {
        take(*buffer, inbox->time);
        inbox->time_has_come_.release();
      },
      this);
  clock->setQueueCapacity(kQueueCapacity);
  subscribe(prefix + "MOTION", Input::kMotion, motion);
  subscribe(prefix + "SEA_FORECAST", Input::kSeaForecast, forecast);
}

Inbox::~Inbox() {
  stop();
}

template <typename Message>
void Inbox::subscribe(const std::string& channel, Input input, InboxSlot<Message>& slot) {
  slot.allowed = &allowed_;
  slot.input = input;
  lcm::Subscription* const subscription = bus_.subscribeFunction<InboxSlot<Message>*>(
      channel,
      [](const lcm::ReceiveBuffer* buffer, const std::string&, InboxSlot<Message>* to) {
        take(*buffer, *to);
      },
      &slot);
  subscription->setQueueCapacity(kQueueCapacity);
}

void Inbox::start() {
  is_running_ = true;
  thread_ = std::thread([this] { receive(); });
}

void Inbox::stop() {
  is_running_ = false;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void Inbox::receive() {
  int failures = 0;
  while (is_running_.load(std::memory_order_relaxed)) {
    failures = bus_.handleTimeout(kWait_ms) < 0 ? failures + 1 : 0;
    if (failures >= kMaxFailuresInRow) {
      failed_ = true;
      return;
    }
  }
}

}  // namespace quickstrip
