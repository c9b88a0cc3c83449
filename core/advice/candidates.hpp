// What can be recommended at all: every change of course, of speed and of both that leads to a cell of the
// grid, and what it costs. ranking.hpp says what is chosen among them.
//
// Effort: sqrt((course / 20 degrees)^2 + (speed / 2 kn)^2): 20 degrees of course are as much trouble as 2 kn
// of speed. Speeding up with the governing seas from astern counts double (it brings the ship nearer to the
// speed of the waves). To that comes the turn itself: one unit for each minute in cells that are worse than
// the present one by once the limit (turn.hpp, exposure). The ship turns the shorter way, unless the longer
// one costs less than four fifths of it. Choices of ours; constants below.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/turn.hpp"
#include "core/base/angles.hpp"

namespace quickstrip {

inline constexpr double kEffortCourse = radians(20.0);           // rad for one unit of effort
inline constexpr double kEffortSpeed = 2.0 * (1852.0 / 3600.0);  // m/s for one unit: 2 kn
inline constexpr double kSpeedingUpInFollowingSeas = 2.0;        // factor on the speed term
inline constexpr double kEffortExposure = 60.0;                  // s of exposure for one unit
inline constexpr double kLongWayGain = 0.8;     // the longer way costs less than this part of the shorter one
inline constexpr double kNoTurn = 1e-6;         // rad; less than this is no change of course
inline constexpr double kNoSpeedChange = 1e-6;  // m/s

/// course_change as turned, + to starboard; speed_change signed [m/s]. Without the exposure of the turn.
double change_effort(double course_change, double speed_change, bool following_seas);

struct Present {
  Heading heading;
  double speed = 0.0;           // m/s, within the grid's speeds
  bool following_seas = false;  // the governing wave system comes from abaft the beam
  bool has_sea_ahead = false;   // sea_from is known: the most energetic of those that matter
  WaveFrom sea_from{};
  Handling handling{};
  double roll_period = 0.0;  // s, natural; 0: not known
};

/// Known, at steerage speed, within the engine's power as far as that is known, and in no severe zone that
/// the present cell is not in.
bool may_be_recommended(const Cell& cell, std::uint16_t present_hazards);

/// Signed speeds and headings, no turn yet: effort is change_effort.
class Candidates {
 public:
  Candidates(const Grid& grid, const Present& present, const Cell& present_cell);

  /// visit(Change, Cell): all pure changes of speed, then of course, then the cells. When the present course
  /// or speed lies between two columns or rows, a pure change must hold in both: the worse one speaks.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t v = 0; v < grid_.num_speeds; ++v) {
      const auto& row = grid_.cells[v];
      offer(present_.heading.radians, grid_.speeds[v], worse(row[columns_.first], row[columns_.second]),
            visit);
    }
    for (std::size_t h = 0; h < grid_.num_headings; ++h) {
      offer(heading(h), present_.speed, worse(grid_.cells[rows_.first][h], grid_.cells[rows_.second][h]),
            visit);
    }
    for (std::size_t v = 0; v < grid_.num_speeds; ++v) {
      for (std::size_t h = 0; h < grid_.num_headings; ++h) {
        offer(heading(h), grid_.speeds[v], grid_.cells[v][h], visit);
      }
    }
  }

  /// Counts the turn in: effort and the side of heading_change. `side`: +1 or -1 prefers starboard or port
  /// to the shorter way.
  void count_turn(Change& change, int side = 0) const;

  [[nodiscard]] bool may_be_recommended(const Cell& cell) const {
    return quickstrip::may_be_recommended(cell, present_hazards_);
  }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const Present& present() const { return present_; }
  [[nodiscard]] TurnStart turn_start() const;
  [[nodiscard]] double heading(std::size_t h) const {
    return kTwoPi * static_cast<double>(h) / static_cast<double>(grid_.num_headings);
  }

 private:
  struct Columns {
    std::size_t first = 0;
    std::size_t second = 0;  // the same when the value lies on the grid
  };
  static Columns heading_columns(const Grid& grid, Heading heading);
  static Columns speed_rows(const Grid& grid, double speed);
  [[nodiscard]] const Cell& worse(const Cell& a, const Cell& b) const;
  [[nodiscard]] double effort_of(const Way& way) const;

  template <typename Visit>
  void offer(double heading, double speed, const Cell& cell, const Visit& visit) const {
    Change change{.heading = wrap_two_pi(heading),
                  .speed = speed,
                  .heading_change = wrap_pi(heading - present_.heading.radians),
                  .speed_change = speed - present_.speed,
                  .verdict = cell.verdict,
                  .governing = cell.governing,
                  .margin = cell.margin,
                  .governing_system = cell.governing_system,
                  .hazards = cell.hazards,
                  .next = cell.next,
                  .next_margin = next_margin(cell),
                  .speed_loss = cell.speed_loss};
    if (std::abs(change.heading_change) <= kNoTurn && std::abs(change.speed_change) <= kNoSpeedChange) {
      return;
    }
    change.effort = change_effort(change.heading_change, change.speed_change, present_.following_seas);
    visit(change, cell);
  }

  const Grid& grid_;
  const Present& present_;
  std::uint16_t present_hazards_;
  double present_badness_;
  Columns columns_;
  Columns rows_;
};

/// Less effort; those that differ by rounding only are equal. Ties: slower before faster, then the smaller
/// turn, then starboard before port (COLREG's side).
bool is_smaller(const Change& a, const Change& b);

}  // namespace quickstrip
