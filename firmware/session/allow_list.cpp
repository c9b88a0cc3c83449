#include "firmware/session/allow_list.hpp"

#include <charconv>

namespace quickstrip {
namespace {

/// By Input.
constexpr std::array<std::string_view, kNumInputs> kChannels{"SEA_STATE", "WAVE_SPECTRUM", "SEA_FORECAST",
                                                             "OWN_SHIP",  "LOADING",       "MOTION",
                                                             "TIME",      "QUERY",         "ALERT_ACK"};

}  // namespace

bool AllowList::read(std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto* const channel = std::find(kChannels.begin(), kChannels.end(), text.substr(0, equals));
  if (equals == std::string_view::npos || channel == kChannels.end()) {
    return false;
  }
  const auto input = static_cast<Input>(channel - kChannels.begin());
  AllowList changed = *this;
  const char* next = text.data() + equals + 1;
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i <= kMaxSources; ++i) {
    std::int16_t id = 0;
    const auto [stopped, error] = std::from_chars(next, end, id);
    if (error != std::errc() || !changed.allow(input, id)) {
      return false;
    }
    if (stopped == end) {
      *this = changed;
      return true;
    }
    if (*stopped != ',') {
      return false;
    }
    next = stopped + 1;
  }
  return false;
}

}  // namespace quickstrip
