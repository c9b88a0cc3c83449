// From reset to board_main: memory as the linker script lays it out, floating point, faults. No clock set-up:
// the emulated board has none to set.
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/cortex-m7/board/console.hpp"
#include "firmware/cortex-m7/board/stack.hpp"

// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
extern std::uint32_t stack_bottom[];
extern std::uint32_t stack_top[];
extern std::uint32_t data_begin[];
extern std::uint32_t data_end[];
extern const std::uint32_t data_in_flash[];
extern std::uint32_t bss_begin[];
extern std::uint32_t bss_end[];
using Constructor = void (*)();
extern const Constructor init_array_begin[];
extern const Constructor init_array_end[];

int board_main();
[[noreturn]] void reset_handler();
[[noreturn]] void start();
void fault_entry();
[[noreturn]] void fault(const std::uint32_t* frame, std::uint32_t exception);
}
// NOLINTEND(bugprone-reserved-identifier)

namespace {

using namespace quickstrip::board;

constexpr std::uint32_t kPaint = 0xC5C5C5C5u;

volatile std::uint32_t& reg(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

// A fault may come from a stack that is at its end: the handler has one of its own.
std::uint32_t fault_stack[128];

}  // namespace

extern "C" {

// The stack is painted before anything uses it, so that its high water can be read off afterwards.
[[gnu::naked, gnu::used]] void reset_handler() {
  asm volatile(
      "ldr r0, =stack_bottom\n"
      "ldr r1, =stack_top\n"
      "ldr r2, =0xC5C5C5C5\n"
      "1: cmp r0, r1\n"
      "itt lo\n"
      "strlo r2, [r0], #4\n"
      "blo 1b\n"
      "b start\n");
}

void start() {
  constexpr std::uint32_t kCpacr = 0xE000ED88u;
  constexpr std::uint32_t kFullAccessToFpu = 0xFu << 20u;
  reg(kCpacr) = reg(kCpacr) | kFullAccessToFpu;
  asm volatile("dsb\nisb");
  // Flushing to zero is left off: the core's results are those of the host to the last bits.
  const std::uint32_t* from = data_in_flash;
  for (std::uint32_t* to = data_begin; to != data_end; ++to, ++from) {
    *to = *from;
  }
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) {
    *to = 0;
  }
  for (const Constructor* constructor = init_array_begin; constructor != init_array_end; ++constructor) {
    (*constructor)();
  }
  stop(board_main());
}

[[gnu::naked]] void fault_entry() {
  asm volatile(
      "mrs r0, msp\n"
      "mrs r1, ipsr\n"
      "ldr r2, =fault_stack_top\n"
      "ldr sp, [r2]\n"
      "b fault\n");
}

extern std::uint32_t* const fault_stack_top;
[[gnu::used]] std::uint32_t* const fault_stack_top =
    fault_stack + sizeof(fault_stack) / sizeof(fault_stack[0]);

void fault(const std::uint32_t* frame, std::uint32_t exception) {
  constexpr std::uint32_t kConfigurableFaultStatus = 0xE000ED28u;
  const bool is_frame_there = frame >= stack_bottom && frame + 8 <= stack_top;
  print("fault ");
  print_hex(exception);
  print(" status ");
  print_hex(reg(kConfigurableFaultStatus));
  print(is_frame_there ? " at " : " after the stack's end ");
  print_hex(is_frame_there ? frame[6] : 0);
  print("\n");
  stop(70);
}

using Handler = void (*)();
struct Vectors {
  std::uint32_t* stack;
  Handler handlers[15];
};
// Interrupts are not used: the serial line is polled.
extern const Vectors vectors;
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors = {
    stack_top,
    {reset_handler, fault_entry, fault_entry, fault_entry, fault_entry, fault_entry, fault_entry, fault_entry,
     fault_entry, fault_entry, fault_entry, fault_entry, fault_entry, fault_entry, fault_entry}};

// Of classes with a virtual destructor; nothing is ever deleted, nothing pure is ever called.
void __cxa_pure_virtual() {  // NOLINT(bugprone-reserved-identifier)
  print("a pure function was called\n");
  stop(71);
}
}

void operator delete(void* /*memory*/) noexcept {
  print("something was deleted\n");
  stop(72);
}

void operator delete(void* /*memory*/, std::size_t /*size*/) noexcept {
  print("something was deleted\n");
  stop(72);
}

namespace quickstrip::board {

std::uint32_t stack_high_water() {
  const std::uint32_t* lowest = stack_bottom;
  while (lowest != stack_top && *lowest == kPaint) {
    ++lowest;
  }
  return static_cast<std::uint32_t>((stack_top - lowest) * static_cast<std::ptrdiff_t>(sizeof *lowest));
}

}  // namespace quickstrip::board
