// What the fault tests share: a folder, a bus, sensors, a running advisor, and the eyes of the bridge, which
// check every advice and grid that comes (never_wrong.hpp) in every test.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "quickstrip/alert_t.hpp"
#include "quickstrip/health_t.hpp"
#include "tests/bad_input/edited_text.hpp"
#include "tests/faults/never_wrong.hpp"
#include "tests/faults/running_advisor.hpp"
#include "tests/faults/sent.hpp"

namespace quickstrip::faults {

inline constexpr double kGoodSea_m = 0.5;
inline constexpr double kBadSea_m = 9.0;

class FaultTest : public testing::Test {
 protected:
  FaultTest();
  ~FaultTest() override;

  /// Options that every start has: hull, bus, cycle of 0.1 s.
  [[nodiscard]] std::vector<std::string> usual_options() const;
  /// `how` with more options. False: it ended before it was on the bus.
  bool try_start(Start how);
  void start(const std::vector<std::string>& more = {}, const std::vector<std::string>& environment = {});
  /// Any standard error. Returns when it speaks.
  void start_with_journal_on(int fd);

  /// The advisor's clock, as far as the test moves it.
  [[nodiscard]] std::int64_t now() const;
  /// By hours, at once. Needs a start with clock_environment().
  void step_clock(double seconds);
  [[nodiscard]] std::vector<std::string> clock_environment() const;

  void send_sea(double hs_m, double age_s = 0.0);
  void send_ship(double age_s = 0.0);
  void send_loading(double kg_m);
  void send_bytes(const std::string& channel, const std::vector<std::uint8_t>& bytes);

  /// Receives; with sensors on, own ship goes out ten times a second. Until `is_so` or for `patience_s` times
  /// kPatience; the last says whether it was so.
  bool until(const std::function<bool()>& is_so, double patience_s = 5.0);
  void listen(double seconds);
  bool until_advice(double patience_s = 5.0);
  bool until_good(double patience_s = 5.0);
  bool until_no_advice(double patience_s = 5.0);
  [[nodiscard]] std::string why_not() const;  // "No advice, because ..."

  test::Folder folder_{"faults"};
  std::string url_;
  std::string hull_file_;  // coarse, so that a cycle takes a millisecond
  bool has_sensors_ = true;
  Promises promises_;
  Sent sent_;
  std::unique_ptr<Oracle> oracle_;
  RunningAdvisor advisor_{folder_.path()};

  // The newest of each, and how many came.
  advice_t advice_{};
  grid_t grid_{};
  health_t health_{};
  std::map<std::int32_t, alert_t> alerts_;  // by alert_id
  int num_advices_ = 0;
  int num_grids_ = 0;
  int num_healths_ = 0;
  int num_faults_ = 0;

 private:
  void take(const advice_t& advice);
  void take(const grid_t& grid);
  void complain(const std::string& fault, std::int32_t seq);
  void receive(const lcm::ReceiveBuffer* buffer, const std::string& channel);

  std::unique_ptr<lcm::LCM> bus_;
  std::map<std::int32_t, advice_t> recent_;  // by seq
  std::int32_t last_seq_ = 0;
  std::int32_t seq_ = 0;
  std::int64_t ship_sent_at_ = 0;
  std::int64_t* clock_offset_ns_ = nullptr;  // shared with the advisor's clock
  std::int64_t former_offset_ns_ = 0;
  std::int64_t stepped_at_ = 0;
};

}  // namespace quickstrip::faults
