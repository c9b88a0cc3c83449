// The newest frame of each topic, for any number of readers: a slow one gets the newest state when it comes
// back, never a backlog. The writer swaps a pointer and wakes; it waits for nobody.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace quickstrip {

enum class Topic : std::uint8_t { kBeat, kState, kGrid, kTrends, kAnswer };
inline constexpr std::size_t kNumTopics = 5;
inline constexpr std::array<std::string_view, kNumTopics> kTopicNames{"beat", "state", "grid", "trends",
                                                                      "answer"};

class EventHub {
 public:
  using Frame = std::shared_ptr<const std::string>;

  /// What a reader has had: versions by topic.
  struct Seen {
    std::array<std::uint64_t, kNumTopics> version{};
  };

  void publish(Topic topic, std::string frame);
  [[nodiscard]] Frame newest(Topic topic) const;

  /// Frames newer than `seen`, as server-sent events in one text, each topic once; empty after `patience`
  /// without any. `seen` is brought up to date.
  std::string next(Seen& seen, std::chrono::milliseconds patience);

  /// Readers come back at once, with nothing, from now on.
  void close();
  [[nodiscard]] bool is_closed() const;

 private:
  [[nodiscard]] bool has_newer(const Seen& seen) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::array<Frame, kNumTopics> frames_;
  std::array<std::uint64_t, kNumTopics> versions_{};
  bool is_closed_ = false;
};

}  // namespace quickstrip
