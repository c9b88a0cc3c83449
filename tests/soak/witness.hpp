// What a machine does to a program that has deadlines, seen by a thread on one processor that does next to
// nothing: it sleeps to absolute times, a millisecond apart, and after each wake does a little known work.
// A late wake is time that the machine took away; known work that takes longer than it did is a machine that
// has become slower (a neighbour on the same core, a lower clock), which no sleep shows.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quickstrip::soak {

std::int64_t now_ns();

/// The most within one window of 100 ms.
struct WorstWindow {
  double taken_s = 0.0;   // from whoever wanted to run
  double slowness = 1.0;  // of known work, against what it took over the last quarter of a minute
};

class Witness {
 public:
  /// On processor `cpu`, with SCHED_FIFO at `priority` where permitted; until `stop`.
  void run(unsigned cpu, int priority, const std::atomic<bool>& stop);
  /// Since the last call; from any thread.
  WorstWindow take_worst();
  [[nodiscard]] bool is_real_time() const { return is_real_time_; }
  /// Of lateness; after run() has ended.
  [[nodiscard]] double quantile_us(double part) const;
  [[nodiscard]] double max_us() const { return 1e-3 * static_cast<double>(max_); }

 private:
  void note_late(std::int64_t now, std::int64_t late);
  void note_work(std::int64_t now, std::int64_t took);
  void close_window();

  static constexpr std::size_t kBins = 100'000;  // of a microsecond
  struct Late {
    std::int64_t at = -1'000'000'000'000;
    std::int64_t by = 0;
  };
  std::array<Late, 128> recent_{};
  std::size_t num_recent_ = 0;
  std::vector<std::uint32_t> bins_ = std::vector<std::uint32_t>(kBins);
  std::int64_t max_ = 0;
  std::int64_t num_wakes_ = 0;
  // Known work: of the window that is open, and the medians of those before.
  std::vector<std::int64_t> work_;
  std::int64_t window_from_ = 0;
  std::array<double, 150> medians_{};
  std::size_t num_windows_ = 0;
  std::atomic<std::int64_t> worst_taken_{0};
  std::atomic<double> worst_slowness_{1.0};
  std::atomic<bool> is_real_time_{false};
};

}  // namespace quickstrip::soak
