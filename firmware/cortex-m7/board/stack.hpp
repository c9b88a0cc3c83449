// How deep the stack has ever been: bytes below its top that no longer hold the paint of the start.
#pragma once

#include <cstdint>

namespace quickstrip::board {

std::uint32_t stack_high_water();

}  // namespace quickstrip::board
