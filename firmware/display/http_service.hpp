// The display's page, events and forms over HTTP: every request through the guard, then to the display.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "firmware/display/bounded_server.hpp"
#include "firmware/display/display.hpp"
#include "firmware/display/request_guard.hpp"

namespace quickstrip {

inline constexpr int kMaxEventStreams = 96;

class HttpService {
 public:
  HttpService(Display& display, GuardOptions guard);
  ~HttpService();
  HttpService(const HttpService&) = delete;
  HttpService& operator=(const HttpService&) = delete;

  /// Binds and serves from a thread of its own. `port` 0: any free one. False when the address is taken.
  bool start(const std::string& address, int port);
  void stop();
  [[nodiscard]] int port() const { return guard_.port; }
  [[nodiscard]] int num_event_streams() const { return num_streams_.load(); }

 private:
  void add_routes();
  bool guard(const httplib::Request& request, httplib::Response& response) const;
  void serve_page(httplib::Response& response) const;
  void serve_events(httplib::Response& response);

  Display& display_;
  GuardOptions guard_;
  BoundedServer server_;
  std::thread thread_;
  std::atomic<int> num_streams_{0};
};

}  // namespace quickstrip
