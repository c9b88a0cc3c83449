#include "tests/faults/fault_test.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

namespace quickstrip::faults {
namespace {

constexpr int kMostComplaints = 10;
constexpr double kShipEvery_s = 0.1;
constexpr std::size_t kMostRecent = 200;

std::int64_t real_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::int64_t steady_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::int64_t microseconds(double seconds) {
  return std::llround(seconds * 1e6);
}

/// A grid of few cells: a cycle of a millisecond.
std::string coarse_hull() {
  const std::string fine = test::source_text("sim/hulls/s175.hull.toml");
  const std::string slow = test::edited(fine, "to = 24.0, step = 1.0", "to = 24.0, step = 6.0");
  return test::edited(slow, "heading_step_deg = 5.0", "heading_step_deg = 30.0");
}

}  // namespace

FaultTest::FaultTest() {
  hull_file_ = folder_.file("hull.toml", coarse_hull());
  oracle_ = std::make_unique<Oracle>(hull_file_);
  url_ = "udpm://239.255.76.67:" + std::to_string(20'000 + getpid() % 20'000) + "?ttl=0";
  bus_ = std::make_unique<lcm::LCM>(url_);
  if (!bus_->good()) {
    ADD_FAILURE() << url_ << " does not open: run inside tests/support/with_loopback_multicast.sh";
    std::abort();  // nothing here means anything without a bus
  }
  const std::string file = folder_.file("clock_offset", std::string(sizeof(std::int64_t), '\0'));
  const int fd = open(file.c_str(), O_RDWR | O_CLOEXEC);
  clock_offset_ns_ = static_cast<std::int64_t*>(
      mmap(nullptr, sizeof(std::int64_t), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0));
  close(fd);
  for (const char* const channel : {"QS_ADVICE", "QS_GRID", "QS_HEALTH", "QS_ALERT"}) {
    bus_->subscribe(channel, &FaultTest::receive, this);
  }
}

FaultTest::~FaultTest() {
  munmap(clock_offset_ns_, sizeof(std::int64_t));
}

void FaultTest::receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  const std::span<const std::uint8_t> bytes{static_cast<const std::uint8_t*>(buffer->data),
                                            buffer->data_size};
  static const auto advice = std::make_unique<advice_t>();
  static const auto grid = std::make_unique<grid_t>();
  alert_t alert{};
  if (channel == "QS_ADVICE" && decode(bytes, *advice)) {
    take(*advice);
  } else if (channel == "QS_GRID" && decode(bytes, *grid)) {
    take(*grid);
  } else if (channel == "QS_HEALTH" && decode(bytes, health_)) {
    ++num_healths_;
  } else if (channel == "QS_ALERT" && decode(bytes, alert)) {
    alerts_[alert.alert_id] = alert;
  } else {
    complain(channel + ": does not decode", 0);
  }
}

std::vector<std::string> FaultTest::usual_options() const {
  const std::string cycle_s = std::to_string(promises_.cycle_s);
  return {"--hull", hull_file_, "--url", url_, "--cycle-s", cycle_s, "--ensemble-per-cycle", "0"};
}

bool FaultTest::try_start(Start how) {
  const std::vector<std::string> more = std::move(how.options);
  how.options = usual_options();
  how.options.insert(how.options.end(), more.begin(), more.end());
  while (bus_->handleTimeout(0) > 0) {  // of the run before
  }
  last_seq_ = 0;
  recent_.clear();
  advice_ = advice_t{};
  health_ = health_t{};
  return advisor_.start(how);
}

void FaultTest::start(const std::vector<std::string>& more, const std::vector<std::string>& environment) {
  ASSERT_TRUE(try_start({more, environment})) << advisor_.journal();
}

void FaultTest::start_with_journal_on(int fd) {
  ASSERT_TRUE(try_start({{}, {}, fd}));
  ASSERT_TRUE(until([this] { return num_advices_ > 0; }));
}

std::int64_t FaultTest::now() const {
  return real_us() + *clock_offset_ns_ / 1000;
}

void FaultTest::step_clock(double seconds) {
  former_offset_ns_ = *clock_offset_ns_;
  stepped_at_ = steady_us();
  __atomic_store_n(clock_offset_ns_, former_offset_ns_ + microseconds(seconds) * 1000, __ATOMIC_RELAXED);
}

std::vector<std::string> FaultTest::clock_environment() const {
  return {"LD_PRELOAD=" QUICKSTRIP_SHIFTED_CLOCK, "QS_CLOCK_OFFSET_FILE=" + folder_.file("clock_offset"),
          "ASAN_OPTIONS=verify_asan_link_order=0"};
}

void FaultTest::send_sea(double hs_m, double age_s) {
  const sea_state_t sea = beam_sea(now() - microseconds(age_s), hs_m, ++seq_);
  sent_.seas[mark_of(sea)] = sea;
  bus_->publish("QS_SEA_STATE", &sea);
}

void FaultTest::send_ship(double age_s) {
  const own_ship_t ship = ship_at(now() - microseconds(age_s), 0.0, ++seq_);
  sent_.ships[mark_of(ship)] = ship;
  bus_->publish("QS_OWN_SHIP", &ship);
}

void FaultTest::send_loading(double kg_m) {
  const loading_t loading = loading_of_kg(now(), kg_m, ++seq_);
  sent_.loadings[mark_of(loading)] = loading;
  bus_->publish("QS_LOADING", &loading);
}

void FaultTest::send_bytes(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
  bus_->publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size()));
}

bool FaultTest::until(const std::function<bool()>& is_so, double patience_s) {
  const std::int64_t end = steady_us() + microseconds(patience_s * kPatience);
  while (true) {
    if (has_sensors_ && steady_us() - ship_sent_at_ >= microseconds(kShipEvery_s)) {
      ship_sent_at_ = steady_us();
      send_ship();
    }
    while (bus_->handleTimeout(10) > 0 && !is_so() && steady_us() < end) {
    }
    if (is_so()) {
      return true;
    }
    if (steady_us() >= end) {
      return false;
    }
  }
}

void FaultTest::listen(double seconds) {
  const std::int64_t end = steady_us() + microseconds(seconds);
  until([end] { return steady_us() >= end; }, seconds + 1.0);
}

bool FaultTest::until_advice(double patience_s) {
  const int before = num_advices_;
  return until([this, before] { return num_advices_ > before && advice_.no_advice == 0; }, patience_s);
}

bool FaultTest::until_good(double patience_s) {
  const int before = num_advices_;
  return until([this, before] { return num_advices_ > before && is_good(advice_); }, patience_s);
}

bool FaultTest::until_no_advice(double patience_s) {
  const int before = num_advices_;
  return until([this, before] { return num_advices_ > before && advice_.no_advice != 0; }, patience_s);
}

std::string FaultTest::why_not() const {
  return {reinterpret_cast<const char*>(advice_.no_advice_text)};
}

void FaultTest::complain(const std::string& fault, std::int32_t seq) {
  if (++num_faults_ <= kMostComplaints) {
    ADD_FAILURE() << "cycle " << seq << ": " << fault;
  }
}

void FaultTest::take(const advice_t& advice) {
  advice_ = advice;
  ++num_advices_;
  if (const std::string fault = fault_of(advice, sent_, promises_, *oracle_); !fault.empty()) {
    complain(fault, advice.seq);
  }
  if (advice.seq <= last_seq_) {
    complain("not later than cycle " + std::to_string(last_seq_), advice.seq);
  }
  last_seq_ = advice.seq;
  // By the present clock, or, shortly after a step, by the former one. A busy machine delivers late.
  constexpr std::int64_t kDelivery_us = 5 * kSecond_us;
  const std::int64_t other = real_us() + former_offset_ns_ / 1000;
  const bool is_by_other = std::abs(other - advice.utime) < kDelivery_us &&
                           steady_us() - stepped_at_ < static_cast<std::int64_t>(kDelivery_us * kPatience);
  if (!is_by_other &&
      !(std::abs(now() - advice.utime) < static_cast<std::int64_t>(kDelivery_us * kPatience))) {
    complain("of another time than the advisor's clock", advice.seq);
  }
  recent_[advice.seq] = advice;
  if (recent_.size() > kMostRecent) {
    recent_.erase(recent_.begin());
  }
}

void FaultTest::take(const grid_t& grid) {
  grid_ = grid;
  ++num_grids_;
  const auto of_cycle = recent_.find(grid.seq);
  if (of_cycle == recent_.end()) {
    return;  // its advice was lost on the way
  }
  if (const std::string fault = fault_of(grid, of_cycle->second, sent_, *oracle_); !fault.empty()) {
    complain(fault, grid.seq);
  }
}

}  // namespace quickstrip::faults
