#include "firmware/cortex-m7/board/mps2_an500.hpp"

#include "firmware/cortex-m7/board/stack.hpp"

namespace quickstrip::board {
namespace {

constexpr std::uint64_t kTicksPerMicrosecond = 25;  // the board's clock is 25 MHz

struct Timer {
  std::uint32_t control;
  std::uint32_t value;  // counts down
  std::uint32_t reload;
  std::uint32_t interrupt;
};

struct Uart {
  std::uint32_t data;
  std::uint32_t state;
  std::uint32_t control;
  std::uint32_t interrupt;
  std::uint32_t baud_divider;
};
constexpr std::uint32_t kTransmitFull = 1;
constexpr std::uint32_t kReceiveFull = 2;
constexpr std::uint32_t kReceiveOverrun = 8;

volatile Timer& timer() {
  return *reinterpret_cast<volatile Timer*>(0x40000000u);
}

volatile Uart& uart() {
  return *reinterpret_cast<volatile Uart*>(0x40004000u);
}

}  // namespace

void Mps2An500::start() {
  constexpr std::uint32_t kEnable = 1;
  constexpr std::uint32_t kBothWays = 3;
  constexpr std::uint32_t kDivider = 217;  // 115,200 baud
  timer().reload = 0xFFFFFFFFu;
  timer().value = 0xFFFFFFFFu;
  timer().control = kEnable;
  last_value_ = timer().value;
  uart().baud_divider = kDivider;
  uart().control = kBothWays;
}

std::uint8_t Mps2An500::next_byte() {
  while ((uart().state & kReceiveFull) == 0) {
  }
  if ((uart().state & kReceiveOverrun) != 0) {
    ++num_lost_;
    uart().state = kReceiveOverrun;
  }
  return static_cast<std::uint8_t>(uart().data);
}

void Mps2An500::put(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    while ((uart().state & kTransmitFull) != 0) {
    }
    uart().data = byte;
  }
}

// Right while it is asked at least every 171 s of work: what lies between cycles does not matter.
std::uint64_t Mps2An500::timer_us() {
  const std::uint32_t value = timer().value;
  ticks_ += last_value_ - value;
  last_value_ = value;
  return ticks_ / kTicksPerMicrosecond;
}

std::uint32_t Mps2An500::stack_high_water() {
  return board::stack_high_water();
}

}  // namespace quickstrip::board
