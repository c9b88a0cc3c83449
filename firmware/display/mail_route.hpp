// Bytes of a channel into the mailbox: the same for the bus and for a log.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "firmware/display/mailbox.hpp"

namespace quickstrip {

/// The channels that the display shows, without the prefix.
std::span<const std::string_view> shown_channels();

/// Decodes and puts; what does not decode is counted. False for a channel that is not shown.
bool route(std::string_view channel, std::span<const std::uint8_t> bytes, Mailbox& mailbox);

}  // namespace quickstrip
