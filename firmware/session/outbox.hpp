// Where a session's messages go: a bus, a log, a test. The bytes are valid during the call only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace quickstrip {

/// The channels that an advisor publishes on.
enum class OutChannel : std::uint8_t {
  kAdvice,
  kGrid,
  kResponse,
  kAlert,
  kLimits,
  kHealth,
  kOutlook,
  kComparison,
  kLogbook,
};

inline constexpr std::size_t kNumOutChannels = 9;

/// Names without the prefix ("QS_").
inline constexpr std::array<std::string_view, kNumOutChannels> kOutChannelNames{
    "ADVICE", "GRID", "RESPONSE", "ALERT", "LIMITS", "HEALTH", "OUTLOOK", "COMPARISON", "LOGBOOK"};

class Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  virtual ~Outbox() = default;

  /// False when the bytes are known to be lost. Must not use the heap if the session is to keep off it.
  virtual bool send(OutChannel channel, std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace quickstrip
