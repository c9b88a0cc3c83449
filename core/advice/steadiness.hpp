// Steady advice: what is worse is shown in the same cycle, only what is better waits.
//
// A verdict becomes better (exceeded > unknown > caution > good) when every cycle for `dwell` has been
// better; it becomes the worst of those cycles. Cycles that are better by less than `hysteresis` of wave
// height count a third: 5.99 degrees at a limit of 6 waits three times as long, and is not held for ever. So
// does each cell of the grid and the present course and speed. Where the ship herself goes to another course
// or speed there is nothing to wait for: the present verdict is then that of the cycle, or the shown one of
// the cell that she is in, whichever is worse. The recommended change stands while it will do (ranking.hpp).
//
// Forgotten, so that everything is shown at once: when time goes back or stands still at 0 (not given), after
// a gap longer than the dwell, when the sea comes from another kind of source (at most once a dwell: two
// sources in turn must not make the advice flutter), and for another loading.
//
// The parameters are ours. Figures of a shaken sea: tests/ranking prints them.
// Same inputs, same bytes: times count by their differences, in whole ticks for the cells. Cost: 4 ns a cell.
// Memory: two bytes a cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/ranking.hpp"
#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"

namespace quickstrip {

struct SteadinessOptions {
  double dwell = 1200.0;     // s that better lasts before it is shown; 0: nothing waits
  double hysteresis = 0.05;  // of wave height
};

/// A cycle that is better by less than the hysteresis counts this part.
inline constexpr double kHardlyBetter = 1.0 / 3.0;
/// The ship is on another course or speed when she is this far from where the present verdict began to wait.
inline constexpr double kOtherCourse = radians(10.0);
inline constexpr double kOtherSpeed = 1.5 * (1852.0 / 3600.0);
/// A recommended course or speed is reached when the ship is this near.
inline constexpr double kCourseReached = radians(2.5);
inline constexpr double kSpeedReached = 0.5 * (1852.0 / 3600.0);

/// Whether `cell`, of a verdict better than `shown`, would be so in waves higher by `hysteresis` as far as
/// its governing criterion tells.
bool is_clearly_better(const Cell& cell, Verdict shown, const Criteria& criteria, double hysteresis);

class Steadiness {
 public:
  void configure(const SteadinessOptions& options);

  /// Everything is shown at once.
  void forget();

  /// Once a cycle that gives advice, before all below. `time` [s]; `sea_source`: any number that tells kinds
  /// of source apart.
  void begin(double time, int sea_source);

  /// Puts the shown verdicts into the cells.
  void steady(const Criteria& criteria, Grid& grid);

  struct Shown {
    Verdict verdict = Verdict::kUnknown;
    double better_in = 0.0;  // s; 0: shown as it is
  };
  /// The verdict on the present course and speed; `grid` as steady() left it.
  Shown present(const Criteria& criteria, const Grid& grid, const Present& at, const Cell& cell);

  /// The recommendation that stands; what of it is reached is done with.
  [[nodiscard]] Standing standing(const Present& at) const;
  /// What was recommended in this cycle.
  void follow(const Advice& advice);

 private:
  struct PresentMemory {
    bool is_there = false;
    bool is_waiting = false;
    Heading heading;
    double speed = 0.0;
    Verdict shown = Verdict::kUnknown;
    Verdict worst = Verdict::kGood;  // since it is better
    double waited = 0.0;             // s
  };

  [[nodiscard]] std::uint16_t remembered(std::uint16_t before, const Cell& cell,
                                         const Criteria& criteria) const;
  [[nodiscard]] PresentMemory start(const Grid& grid, const Present& at, const Cell& cell) const;
  void wait(const Criteria& criteria, const Cell& cell, PresentMemory& memory) const;

  SteadinessOptions options_;
  bool has_time_ = false;
  double time_ = 0.0;
  double step_ = 0.0;             // s since the last cycle
  double origin_ = 0.0;           // of the ticks
  std::uint32_t ticks_ = 0;       // in this step, whole ones
  std::uint32_t slow_ticks_ = 0;  // a third of them
  int sea_source_ = 0;
  double source_since_ = 0.0;
  bool has_cells_ = false;
  std::size_t num_speeds_ = 0;
  std::size_t num_headings_ = 0;
  std::array<std::array<std::uint16_t, kMaxHeadings>, kMaxSpeeds> memory_{};
  PresentMemory present_;
  Standing standing_;
};

/// The cell of the grid that is nearest.
struct CellIndex {
  std::size_t speed = 0;
  std::size_t heading = 0;
};
CellIndex nearest_cell(const Grid& grid, Heading heading, double speed);

}  // namespace quickstrip
