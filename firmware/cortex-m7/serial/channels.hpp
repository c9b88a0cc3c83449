// What the frames of the serial line carry: FRAMING.md.
#pragma once

#include <cstddef>
#include <cstdint>

namespace quickstrip {

/// Ids of channels on the line.
enum class SerialChannel : std::uint8_t {
  kSeaState = 1,
  kOwnShip = 2,
  kLoading = 3,
  kTime = 4,
  kFirstOut = 16,  // + OutChannel
  kLineReport = 32,
};

/// What a board tells of itself after each cycle: eight numbers of 32 bits, big-endian as LCM's.
struct LineReport {
  std::uint32_t good_frames = 0;
  std::uint32_t corrupted_frames = 0;
  std::uint32_t too_long_frames = 0;
  std::uint32_t unknown_channels = 0;
  std::uint32_t lost_bytes = 0;   // by the receiver
  std::uint32_t cycle_us = 0;     // of the last cycle, by the board's timer
  std::uint32_t rebuild_us = 0;   // of the last rebuild, the one at the start included
  std::uint32_t stack_bytes = 0;  // high water; 0: not measured
  static constexpr std::size_t kBytes = 32;
};

}  // namespace quickstrip
