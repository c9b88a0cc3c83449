// Publishes a session's messages on LCM by the raw call, from the session's own buffer: no allocation of ours
// (liblcm's udpm publish of up to 64 kB allocates none either, platform figures in tests/system).
#pragma once

#include <array>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "firmware/session/outbox.hpp"

namespace quickstrip {

class BusOutbox : public Outbox {
 public:
  BusOutbox(lcm::LCM& bus, const std::string& prefix) : bus_(bus) {
    for (std::size_t c = 0; c < kNumOutChannels; ++c) {
      names_[c] = prefix + std::string(kOutChannelNames[c]);
    }
  }
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override {
    return bus_.publish(names_[static_cast<std::size_t>(channel)], bytes.data(),
                        static_cast<unsigned int>(bytes.size())) == 0;
  }

 private:
  lcm::LCM& bus_;
  std::array<std::string, kNumOutChannels> names_;
};

}  // namespace quickstrip
