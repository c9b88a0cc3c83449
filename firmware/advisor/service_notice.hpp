// Tells the service manager how it goes: ready, still alive, stopping (sd_notify(3), whose protocol is a
// datagram of NAME=VALUE lines to the socket that $NOTIFY_SOCKET names, and is promised to stay). Not
// libsystemd: it would bring compression and encryption libraries on board for thirty lines. Without
// $NOTIFY_SOCKET every call does nothing. Never waits: a manager that does not read loses lines.
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace quickstrip {

class ServiceNotice {
 public:
  /// Opens the socket that the environment names, if it does.
  ServiceNotice();
  ~ServiceNotice();
  ServiceNotice(const ServiceNotice&) = delete;
  ServiceNotice& operator=(const ServiceNotice&) = delete;

  /// "READY=1", "STOPPING=1", "WATCHDOG=1", "STATUS=..."
  void tell(std::string_view line) const;

  /// How often WATCHDOG=1 is wanted: a third of what the manager waits for ($WATCHDOG_USEC); none: never.
  [[nodiscard]] std::optional<std::chrono::microseconds> watchdog_period() const { return watchdog_period_; }

 private:
  int socket_ = -1;
  std::optional<std::chrono::microseconds> watchdog_period_;
};

}  // namespace quickstrip
