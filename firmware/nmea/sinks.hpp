// Where the gateway's messages go: LCM by the raw call, or an LCM log.
#pragma once

#include <array>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "firmware/nmea/gateway.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip::nmea {

inline std::array<std::string, kChannelNames.size()> names_with(const std::string& prefix) {
  std::array<std::string, kChannelNames.size()> names;
  for (std::size_t c = 0; c < names.size(); ++c) {
    names[c] = prefix + std::string(kChannelNames[c]);
  }
  return names;
}

class BusSink : public Sink {
 public:
  BusSink(lcm::LCM& bus, const std::string& prefix) : bus_(bus), names_(names_with(prefix)) {}
  void send(Channel channel, std::int64_t, std::span<const std::uint8_t> bytes) override {
    // A lost message is replaced by the next one in a second.
    static_cast<void>(bus_.publish(names_[static_cast<std::size_t>(channel)], bytes.data(),
                                   static_cast<unsigned int>(bytes.size())));
  }

 private:
  lcm::LCM& bus_;
  std::array<std::string, kChannelNames.size()> names_;
};

/// The first failure is kept, and nothing is written after it. The time of reception is that of measurement.
class LogSink : public Sink {
 public:
  LogSink(LcmLogWriter& log, const std::string& prefix) : log_(log), names_(names_with(prefix)) {}
  void send(Channel channel, std::int64_t utime, std::span<const std::uint8_t> bytes) override {
    if (status_) {
      status_ = log_.append(utime, names_[static_cast<std::size_t>(channel)], bytes);
    }
  }
  [[nodiscard]] const FileStatus& status() const { return status_; }

 private:
  LcmLogWriter& log_;
  std::array<std::string, kChannelNames.size()> names_;
  FileStatus status_;
};

}  // namespace quickstrip::nmea
