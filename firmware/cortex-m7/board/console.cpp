#include "firmware/cortex-m7/board/console.hpp"

#include <array>
#include <cstddef>

namespace quickstrip::board {
namespace {

constexpr std::uint32_t kWriteText = 0x04;
constexpr std::uint32_t kExitExtended = 0x20;
constexpr std::uint32_t kApplicationExit = 0x20026;

void semihosting([[maybe_unused]] std::uint32_t operation, [[maybe_unused]] const void* parameter) {
#if !defined(QUICKSTRIP_NO_SEMIHOSTING)
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = parameter;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
#endif
}

}  // namespace

void print(const char* text) {
  semihosting(kWriteText, text);
}

void print_number(std::uint32_t number) {
  std::array<char, 11> text{};
  std::size_t at = text.size() - 1;
  do {
    text[--at] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0 && at > 0);
  print(&text[at]);
}

void print_hex(std::uint32_t number) {
  std::array<char, 11> text{"0x00000000"};
  for (std::size_t at = 9; at > 1; --at) {
    text[at] = "0123456789abcdef"[number & 0xFu];
    number >>= 4u;
  }
  print(text.data());
}

void stop(int code) {
  const std::array<std::uint32_t, 2> block{kApplicationExit, static_cast<std::uint32_t>(code)};
  semihosting(kExitExtended, block.data());
  for (;;) {
    asm volatile("wfi");
  }
}

}  // namespace quickstrip::board
