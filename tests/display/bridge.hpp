// A bridge for the tests: messages as an advisor sends them, and a display that is fed and served.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "firmware/display/display.hpp"
#include "firmware/display/http_service.hpp"
#include "msgs/convert/encode.hpp"

namespace quickstrip::test {

std::int64_t utime_now();

/// Heading 065, 14.2 kn, caution by roll: 4.8 of 6 degrees RMS, margin 1.25; two changes.
advice_t advice_at(std::int64_t utime, std::int32_t seq);
/// 25 speeds of 0 ... 24 kn, 72 headings. One sector alone is of each verdict: 030 ... 060 exceeded, 120 ...
/// 150 caution, 210 ... 240 unknown, 300 ... 330 a zone of the IMO guidance; all else good. No mirror image
/// of itself.
grid_t grid_at(std::int64_t utime, std::int32_t seq);
limits_t limits_at(std::int64_t utime);
health_t health_at(std::int64_t utime);
outlook_t outlook_at(std::int64_t utime, std::int32_t seq);
own_ship_t own_ship_at(std::int64_t utime, double heading_deg, double speed_kn);
/// One system: 3.2 m, 11 s.
sea_state_t sea_from(std::int64_t utime, double dir_from_deg);
alert_t warning_at(std::int64_t utime);
comparison_t comparison_at(std::int64_t utime);

/// A display over HTTP on a free port, with an advisor that speaks four times a second while `speaks` is
/// true.
class Bridge {
 public:
  /// `before`: what the display is told before anything else.
  explicit Bridge(bool speaks_at_once = true, const std::function<void(Display&)>& before = {});
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  [[nodiscard]] std::string url() const;
  [[nodiscard]] int port() const { return service_->port(); }
  [[nodiscard]] const std::string& token() const { return token_; }
  Display& display() { return *display_; }
  HttpService& service() { return *service_; }
  void stop_service() { service_->stop(); }

  /// Changes what the advisor says from now on.
  void say(const std::function<void(advice_t&)>& change);
  std::atomic<bool> speaks{true};
  std::atomic<double> dir_from_deg{240.0};
  std::atomic<double> heading_deg{65.0};
  std::atomic<bool> has_outlook{true};
  std::atomic<int> num_turns{0};

  /// The newest message that the display sent on a channel.
  template <typename Message>
  std::optional<Message> sent(const std::string& channel) {
    const std::lock_guard lock(mutex_);
    for (auto it = sent_.rbegin(); it != sent_.rend(); ++it) {
      Message message{};
      if (it->first == channel && decode(it->second, message)) {
        return message;
      }
    }
    return std::nullopt;
  }
  std::size_t num_sent(const std::string& channel);

 private:
  void speak();
  void answer_query();

  std::mutex mutex_;
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> sent_;
  std::function<void(advice_t&)> change_;
  std::string token_ = "0123456789abcdef";
  std::unique_ptr<Display> display_;
  std::unique_ptr<HttpService> service_;
  std::atomic<bool> is_running_{true};
  std::int32_t seq_ = 0;
  std::int64_t answered_ = 0;
  std::thread turns_;
  std::thread advisor_;
};

}  // namespace quickstrip::test
