#include "core/advice/ranking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr std::uint16_t kNeverRecommended = kHazardNoSteerage | kHazardFollowingUnwatched;
constexpr double kNoTurn = 1e-6;         // rad; less than this is no change of course
constexpr double kNoSpeedChange = 1e-6;  // m/s

/// What is aimed at, from the best down.
enum class Aim : std::uint8_t { kGood, kCaution, kGreatestMargin, kNothing };

enum Kind : std::size_t { kSlower, kFaster, kStarboard, kPort, kCombined, kNumKinds };

using Best = std::array<std::optional<Change>, kNumKinds>;

struct Columns {
  std::size_t first = 0;
  std::size_t second = 0;  // the same when the value lies on the grid
};

/// Headings of the grid on either side of the present course.
Columns heading_columns(const Grid& grid, Heading heading) {
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
Columns speed_rows(const Grid& grid, double speed) {
  std::size_t upper = 0;
  while (upper + 1 < grid.num_speeds && grid.speeds[upper] < speed - kNoSpeedChange) {
    ++upper;
  }
  const bool on_grid = upper == 0 || std::abs(grid.speeds[upper] - speed) <= kNoSpeedChange;
  return {on_grid ? upper : upper - 1, upper};
}

bool may_be_recommended(const Cell& cell) {
  return cell.verdict != Verdict::kUnknown && (cell.hazards & kNeverRecommended) == 0;
}

/// The one that speaks for both: not to be recommended, then the worse verdict, then the smaller margin.
const Cell& worse(const Cell& a, const Cell& b) {
  if (may_be_recommended(a) != may_be_recommended(b)) {
    return may_be_recommended(a) ? b : a;
  }
  if (a.verdict != b.verdict) {
    return a.verdict > b.verdict ? a : b;
  }
  return a.margin <= b.margin ? a : b;
}

bool meets(const Cell& cell, Aim aim) {
  if (!may_be_recommended(cell)) {
    return false;
  }
  switch (aim) {
    case Aim::kGood:
      return cell.verdict == Verdict::kGood;
    case Aim::kCaution:
      return cell.verdict == Verdict::kCaution;
    case Aim::kGreatestMargin:
      return cell.verdict == Verdict::kExceeded;
    case Aim::kNothing:
      break;
  }
  return false;
}

/// Efforts that differ by rounding only are equal: the tie rules decide, on every machine alike.
std::int64_t rounded_effort(const Change& change) {
  return std::llround(change.effort * 1e9);
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

bool has_greater_margin(const Change& a, const Change& b) {
  return a.margin != b.margin ? a.margin > b.margin : is_smaller(a, b);
}

Kind kind_of(const Change& change) {
  const bool turns = std::abs(change.heading_change) > kNoTurn;
  const bool changes_speed = std::abs(change.speed_change) > kNoSpeedChange;
  if (turns && changes_speed) {
    return kCombined;
  }
  if (turns) {
    return change.heading_change > 0.0 ? kStarboard : kPort;
  }
  return change.speed_change < 0.0 ? kSlower : kFaster;
}

/// Walks over all candidates of one present state; visit(Change, Cell) for each.
class Candidates {
 public:
  Candidates(const Grid& grid, const Present& present)
      : grid_(grid),
        present_(present),
        columns_(heading_columns(grid, present.heading)),
        rows_(speed_rows(grid, present.speed)) {}

  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t v = 0; v < grid_.num_speeds; ++v) {
      const auto& row = grid_.cells[v];
      offer(present_.heading.radians, grid_.speeds[v], worse(row[columns_.first], row[columns_.second]),
            visit);
    }
    for (std::size_t h = 0; h < grid_.num_headings; ++h) {
      const Cell& cell = worse(grid_.cells[rows_.first][h], grid_.cells[rows_.second][h]);
      offer(heading(h), present_.speed, cell, visit);
    }
    for (std::size_t v = 0; v < grid_.num_speeds; ++v) {
      for (std::size_t h = 0; h < grid_.num_headings; ++h) {
        offer(heading(h), grid_.speeds[v], grid_.cells[v][h], visit);
      }
    }
  }

 private:
  [[nodiscard]] double heading(std::size_t h) const {
    return kTwoPi * static_cast<double>(h) / static_cast<double>(grid_.num_headings);
  }

  template <typename Visit>
  void offer(double heading, double speed, const Cell& cell, const Visit& visit) const {
    Change change{.heading = wrap_two_pi(heading),
                  .speed = speed,
                  .heading_change = wrap_pi(heading - present_.heading.radians),
                  .speed_change = speed - present_.speed,
                  .verdict = cell.verdict,
                  .governing = cell.governing,
                  .margin = cell.margin};
    if (std::abs(change.heading_change) <= kNoTurn && std::abs(change.speed_change) <= kNoSpeedChange) {
      return;
    }
    change.effort = change_effort(change.heading_change, change.speed_change, present_.following_seas);
    visit(change, cell);
  }

  const Grid& grid_;
  const Present& present_;
  Columns columns_;
  Columns rows_;
};

bool any_meets(const Grid& grid, Aim aim) {
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    const auto end = grid.cells[v].begin() + static_cast<std::ptrdiff_t>(grid.num_headings);
    if (std::any_of(grid.cells[v].begin(), end, [aim](const Cell& cell) { return meets(cell, aim); })) {
      return true;
    }
  }
  return false;
}

Aim aim_of(const Grid& grid, const Cell& present_cell) {
  if (any_meets(grid, Aim::kGood)) {
    return Aim::kGood;
  }
  if (present_cell.verdict != Verdict::kExceeded) {
    return Aim::kNothing;  // caution is no improvement on caution, and nothing is known to beat the unknown
  }
  if (any_meets(grid, Aim::kCaution)) {
    return Aim::kCaution;
  }
  return any_meets(grid, Aim::kGreatestMargin) ? Aim::kGreatestMargin : Aim::kNothing;
}

Best smallest_of_each_kind(const Candidates& candidates, Aim aim) {
  Best best;
  candidates.for_each([&](const Change& change, const Cell& cell) {
    std::optional<Change>& kept = best[kind_of(change)];
    if (meets(cell, aim) && (!kept || is_smaller(change, *kept))) {
      kept = change;
    }
  });
  const bool combined_is_smallest =
      best[kCombined] && std::none_of(best.begin(), best.begin() + kCombined, [&](const auto& pure) {
        return pure && !is_smaller(*best[kCombined], *pure);
      });
  if (!combined_is_smallest) {
    best[kCombined].reset();
  }
  return best;
}

/// Insertion of a handful: std::sort recurses.
void insert_in_order(const Change& change, Advice& out) {
  QS_CHECK(out.changes.push_back(change));
  for (std::size_t i = out.changes.size() - 1; i > 0 && is_smaller(out.changes[i], out.changes[i - 1]); --i) {
    std::swap(out.changes[i], out.changes[i - 1]);
  }
}

Best greatest_margin(const Candidates& candidates, const Cell& present_cell) {
  Best best;
  std::optional<Change>& kept = best[0];
  candidates.for_each([&](const Change& change, const Cell& cell) {
    if (meets(cell, Aim::kGreatestMargin) && change.margin > present_cell.margin &&
        (!kept || has_greater_margin(change, *kept))) {
      kept = change;
    }
  });
  return best;
}

}  // namespace

double change_effort(double course_change, double speed_change, bool following_seas) {
  const double speeding_up = following_seas && speed_change > 0.0 ? kSpeedingUpInFollowingSeas : 1.0;
  return std::hypot(course_change / kEffortCourse, speeding_up * speed_change / kEffortSpeed);
}

void rank_changes(const Grid& grid, const Present& present, const Cell& present_cell, Advice& out) {
  QS_CHECK(grid.num_speeds > 0 && grid.num_headings > 0);
  out = Advice{.no_advice = NoAdvice::kNone,
               .heading = present.heading,
               .speed = present.speed,
               .present = present_cell,
               .changes = {},
               .change_needed = present_cell.verdict != Verdict::kGood};
  if (!out.change_needed) {
    return;
  }
  const Aim aim = aim_of(grid, present_cell);
  out.none_is_good = aim != Aim::kGood;
  const Candidates candidates(grid, present);
  const Best best = aim == Aim::kGreatestMargin ? greatest_margin(candidates, present_cell)
                                                : smallest_of_each_kind(candidates, aim);
  for (const auto& change : best) {
    if (change) {
      insert_in_order(*change, out);
    }
  }
  out.no_change_helps = out.changes.empty();
}

}  // namespace quickstrip
