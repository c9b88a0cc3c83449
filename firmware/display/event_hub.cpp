#include "firmware/display/event_hub.hpp"

#include <utility>

namespace quickstrip {

void EventHub::publish(Topic topic, std::string frame) {
  auto newest = std::make_shared<const std::string>(std::move(frame));
  {
    const std::lock_guard lock(mutex_);
    const auto t = static_cast<std::size_t>(topic);
    frames_[t].swap(newest);
    ++versions_[t];
  }
  changed_.notify_all();
}

EventHub::Frame EventHub::newest(Topic topic) const {
  const std::lock_guard lock(mutex_);
  return frames_[static_cast<std::size_t>(topic)];
}

bool EventHub::has_newer(const Seen& seen) const {
  return seen.version != versions_;
}

std::string EventHub::next(Seen& seen, std::chrono::milliseconds patience) {
  std::array<Frame, kNumTopics> newer;
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return is_closed_ || has_newer(seen); });
    if (is_closed_) {
      return {};
    }
    for (std::size_t t = 0; t < kNumTopics; ++t) {
      if (versions_[t] != seen.version[t]) {
        newer[t] = frames_[t];
      }
    }
    seen.version = versions_;
  }
  std::string text;
  for (std::size_t t = 0; t < kNumTopics; ++t) {
    if (newer[t]) {
      text += "event: ";
      text += kTopicNames[t];
      text += "\ndata: ";
      text += *newer[t];  // JSON on one line
      text += "\n\n";
    }
  }
  return text;
}

void EventHub::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  changed_.notify_all();
}

bool EventHub::is_closed() const {
  const std::lock_guard lock(mutex_);
  return is_closed_;
}

}  // namespace quickstrip
