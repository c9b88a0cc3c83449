#include "core/advice/candidates.hpp"

#include <cmath>

namespace quickstrip {
namespace {

constexpr std::uint16_t kNeverRecommended = kHazardNoSteerage | kHazardFollowingUnwatched;

/// Efforts that differ by rounding only are equal: the tie rules decide, on every machine alike.
std::int64_t rounded_effort(const Change& change) {
  return std::llround(change.effort * 1e9);
}

}  // namespace

double change_effort(double course_change, double speed_change, bool following_seas) {
  const double speeding_up = following_seas && speed_change > 0.0 ? kSpeedingUpInFollowingSeas : 1.0;
  return std::hypot(course_change / kEffortCourse, speeding_up * speed_change / kEffortSpeed);
}

bool may_be_recommended(const Cell& cell, std::uint16_t present_hazards) {
  const auto new_severe =
      static_cast<std::uint16_t>(cell.hazards & kSevereZoneBits & static_cast<unsigned>(~present_hazards));
  return cell.verdict != Verdict::kUnknown && (cell.hazards & kNeverRecommended) == 0 && new_severe == 0 &&
         (cell.quality & kQualitySpeedNotKept) == 0;
}

bool is_smaller(const Change& a, const Change& b) {
  if (rounded_effort(a) != rounded_effort(b)) {
    return rounded_effort(a) < rounded_effort(b);
  }
  if (std::abs(a.speed_change - b.speed_change) > kNoSpeedChange) {
    return a.speed_change < b.speed_change;
  }
  if (std::abs(std::abs(a.heading_change) - std::abs(b.heading_change)) > kNoTurn) {
    return std::abs(a.heading_change) < std::abs(b.heading_change);
  }
  return a.heading_change > b.heading_change;
}

Candidates::Candidates(const Grid& grid, const Present& present, const Cell& present_cell)
    : grid_(grid),
      present_(present),
      present_hazards_(present_cell.hazards),
      present_badness_(badness(present_cell)),
      columns_(heading_columns(grid, present.heading)),
      rows_(speed_rows(grid, present.speed)) {}

/// Headings of the grid on either side of the present course.
Candidates::Columns Candidates::heading_columns(const Grid& grid, Heading heading) {
  const auto n = static_cast<double>(grid.num_headings);
  const double turned = wrap_two_pi(heading.radians) / kTwoPi * n;
  const double nearest = std::round(turned);
  if (std::abs(turned - nearest) * kTwoPi / n < kNoTurn) {
    const std::size_t column = static_cast<std::size_t>(nearest) % grid.num_headings;
    return {column, column};
  }
  const auto below = static_cast<std::size_t>(std::floor(turned));
  return {below % grid.num_headings, (below + 1) % grid.num_headings};
}

/// Speeds of the grid on either side of the present speed.
Candidates::Columns Candidates::speed_rows(const Grid& grid, double speed) {
  std::size_t upper = 0;
  while (upper + 1 < grid.num_speeds && grid.speeds[upper] < speed - kNoSpeedChange) {
    ++upper;
  }
  const bool on_grid = upper == 0 || std::abs(grid.speeds[upper] - speed) <= kNoSpeedChange;
  return {on_grid ? upper : upper - 1, upper};
}

/// The one that speaks for both: not to be recommended, then the worse verdict, then the smaller margin.
const Cell& Candidates::worse(const Cell& a, const Cell& b) const {
  if (may_be_recommended(a) != may_be_recommended(b)) {
    return may_be_recommended(a) ? b : a;
  }
  if (a.verdict != b.verdict) {
    return a.verdict > b.verdict ? a : b;
  }
  return a.margin <= b.margin ? a : b;
}

TurnStart Candidates::turn_start() const {
  return {present_.heading, present_.speed, present_.handling, present_.roll_period};
}

double Candidates::effort_of(const Way& way) const {
  return change_effort(way.heading_change, way.speed_change, present_.following_seas) +
         turn_exposure(grid_, turn_start(), way, present_badness_) / kEffortExposure;
}

void Candidates::count_turn(Change& change, int side) const {
  const double shorter = wrap_pi(change.heading - present_.heading.radians);
  const Way way{shorter, change.speed_change};
  change.heading_change = shorter;
  change.effort = effort_of(way);
  if (std::abs(shorter) <= kNoTurn) {
    return;
  }
  const Way other{shorter - std::copysign(kTwoPi, shorter), change.speed_change};
  const bool prefers_other = side != 0 && (side > 0) != (shorter > 0.0);
  // Without any exposure it would still cost this much.
  const double least = change_effort(other.heading_change, other.speed_change, present_.following_seas);
  if (!prefers_other && !(least < kLongWayGain * change.effort)) {
    return;
  }
  const double effort = effort_of(other);
  const bool takes_other =
      prefers_other ? !(change.effort < kLongWayGain * effort) : effort < kLongWayGain * change.effort;
  if (takes_other) {
    change.heading_change = other.heading_change;
    change.effort = effort;
  }
}

}  // namespace quickstrip
