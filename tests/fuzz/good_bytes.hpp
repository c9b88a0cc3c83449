// Good messages as bytes, and fuzzed bytes laid over them.
#pragma once

#include <string_view>

#include "tests/fuzz/targets.hpp"

namespace quickstrip::fuzz {

/// Of an incoming channel, by name without prefix.
const Bytes& good_bytes(std::string_view channel);

/// What a session in a sea of 6 m says.
struct OwnMessages {
  Bytes advice;
  Bytes grid;
  Bytes limits;
};
OwnMessages own_messages();

/// `over` in place of what follows the fingerprint; as long as `good`, so that it decodes.
Bytes laid_over(const Bytes& good, std::span<const std::uint8_t> over);

}  // namespace quickstrip::fuzz
