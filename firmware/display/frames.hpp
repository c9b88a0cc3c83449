// What the page gets, as JSON on one line each. Numbers as they are on the wire (rim units); -1 and its kind
// become null: the page never has to know which number says "not known". Text that is no UTF-8 is mended.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/display/manual_entries.hpp"
#include "firmware/display/shown.hpp"

namespace quickstrip {

struct FrameContext {
  std::int64_t utime = 0;  // our clock
  std::string start_id;    // of this start of the display: a page of another one loads itself again
  bool is_recorded = false;
  bool has_bus = true;
};

/// Once or twice a second: the pulse by which the page knows that all is alive.
std::string beat_frame(const Shown& shown, const FrameContext& context, Shown::Clock::time_point now);
std::string state_frame(const Shown& shown, const EntriesInForce& entries, const FrameContext& context);
std::string grid_frame(const Shown& shown);
std::string trends_frame(const Shown& shown);
/// `response` as the page explains it.
std::string answer_frame(const Shown& shown);

}  // namespace quickstrip
