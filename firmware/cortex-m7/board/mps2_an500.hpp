// UART 0 and timer 0 of Arm's MPS2 board with AN500, as QEMU has them (Cortex-M System Design Kit).
#pragma once

#include <cstdint>
#include <span>

#include "firmware/cortex-m7/serial/serial_session.hpp"

namespace quickstrip::board {

class Mps2An500 final : public Board {
 public:
  void start();
  /// Waits for it.
  std::uint8_t next_byte();
  void put(std::span<const std::uint8_t> bytes) override;
  std::uint64_t timer_us() override;
  std::uint32_t stack_high_water() override;
  std::uint32_t lost_bytes() override { return num_lost_; }

 private:
  std::uint64_t ticks_ = 0;
  std::uint32_t last_value_ = 0;
  std::uint32_t num_lost_ = 0;
};

}  // namespace quickstrip::board
