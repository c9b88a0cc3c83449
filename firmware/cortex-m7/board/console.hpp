// The developer's console by semihosting (a debugger or QEMU listens): start, faults, failed checks. On a
// board alone the instruction is a fault: build with QUICKSTRIP_NO_SEMIHOSTING, and it is silent.
#pragma once

#include <cstdint>

namespace quickstrip::board {

void print(const char* text);
void print_number(std::uint32_t number);
void print_hex(std::uint32_t number);

/// Ends the emulation with this exit code; on a board it stays here until the watchdog resets it.
[[noreturn]] void stop(int code);

}  // namespace quickstrip::board
