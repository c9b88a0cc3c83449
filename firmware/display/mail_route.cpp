#include "firmware/display/mail_route.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "msgs/convert/encode.hpp"

namespace quickstrip {
namespace {

template <typename Message>
void put(std::span<const std::uint8_t> bytes, Mailbox& mailbox) {
  const auto message = std::make_unique<Message>();
  if (decode(bytes, *message)) {
    mailbox.put(*message);
  } else {
    mailbox.count_malformed();
  }
}

struct Route {
  std::string_view channel;
  void (*put)(std::span<const std::uint8_t>, Mailbox&);
};

constexpr std::array kRoutes{
    Route{"ADVICE", put<advice_t>},
    Route{"GRID", put<grid_t>},
    Route{"OUTLOOK", put<outlook_t>},
    Route{"LIMITS", put<limits_t>},
    Route{"HEALTH", put<health_t>},
    Route{"COMPARISON", put<comparison_t>},
    Route{"RESPONSE", put<response_t>},
    Route{"ALERT", put<alert_t>},
    Route{"LOGBOOK", put<logbook_t>},
    Route{"SEA_STATE", put<sea_state_t>},
    Route{"WAVE_SPECTRUM", put<wave_spectrum_t>},
    Route{"OWN_SHIP", put<own_ship_t>},
    Route{"LOADING", put<loading_t>},
    Route{"MOTION", put<motion_t>},
};

constexpr std::array<std::string_view, kRoutes.size()> channels_of_routes() {
  std::array<std::string_view, kRoutes.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = kRoutes[i].channel;
  }
  return names;
}

constexpr auto kChannels = channels_of_routes();

}  // namespace

std::span<const std::string_view> shown_channels() {
  return kChannels;
}

bool route(std::string_view channel, std::span<const std::uint8_t> bytes, Mailbox& mailbox) {
  const auto* const found = std::find_if(kRoutes.begin(), kRoutes.end(),
                                         [&](const Route& known) { return known.channel == channel; });
  if (found == kRoutes.end()) {
    return false;
  }
  found->put(bytes, mailbox);
  return true;
}

}  // namespace quickstrip
