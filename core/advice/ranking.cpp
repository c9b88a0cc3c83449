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

/// What is aimed at, from the best down.
enum class Aim : std::uint8_t { kGood, kCaution, kLeastBad, kNothing };

enum Sort : std::size_t { kSlower, kFaster, kStarboard, kPort, kCombined, kNumSorts };

using Best = std::array<std::optional<Change>, kNumSorts>;

Sort sort_of(const Change& change) {
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

bool goes_to_the_same(const Change& a, const Change& b) {
  return std::abs(wrap_pi(a.heading - b.heading)) <= kNoTurn && std::abs(a.speed - b.speed) <= kNoSpeedChange;
}

bool is_same(const Change& change, const Standing& standing) {
  const bool turns = std::abs(change.heading_change) > kNoTurn;
  const bool changes_speed = std::abs(change.speed_change) > kNoSpeedChange;
  return turns == standing.turns && changes_speed == standing.changes_speed &&
         (!turns || std::abs(wrap_pi(change.heading - standing.heading)) <= kNoTurn) &&
         (!changes_speed || std::abs(change.speed - standing.speed) <= kNoSpeedChange);
}

/// One ranking: the grid, what is aimed at, and what meets it.
class Ranking {
 public:
  Ranking(const Candidates& candidates, const Cell& present_cell)
      : candidates_(candidates), present_cell_(present_cell), aim_(find_aim()) {}

  [[nodiscard]] Aim aim() const { return aim_; }

  [[nodiscard]] Best smallest_of_each_sort() const {
    Best best;
    candidates_.for_each([&](const Change& candidate, const Cell& cell) {
      if (!meets(cell)) {
        return;
      }
      // Its turn can only add to its effort, and a longer way round to another sort.
      std::optional<Change>& expected = best[sort_of(candidate)];
      if (expected && is_smaller(*expected, candidate)) {
        return;
      }
      Change change = candidate;
      candidates_.count_turn(change);
      std::optional<Change>& kept = best[sort_of(change)];
      if (!kept || is_smaller(change, *kept)) {
        kept = change;
      }
    });
    drop_combined_unless_smallest(best);
    return best;
  }

  [[nodiscard]] std::optional<Change> larger_than(const Change& first) const {
    std::optional<Change> best;
    const auto least_margin = static_cast<float>(kMuchMoreMargin * static_cast<double>(first.margin));
    constexpr double kRounding = 1.0 + 1e-9;
    const double most_effort = kRounding * kMuchMoreEffort * first.effort;
    const auto zones = static_cast<unsigned>(first.hazards & kZoneBits);
    candidates_.for_each([&](const Change& candidate, const Cell& cell) {
      const bool buys_much =
          meets(cell) && cell.margin >= least_margin && (cell.hazards & kZoneBits & ~zones) == 0;
      if (!buys_much || candidate.effort > most_effort || (best && cell.margin < best->margin)) {
        return;
      }
      Change change = candidate;
      candidates_.count_turn(change);
      const bool is_better = !best || change.margin > best->margin || is_smaller(change, *best);
      if (change.effort <= most_effort && is_better) {
        best = change;
      }
    });
    return best;
  }

  [[nodiscard]] std::optional<Change> heave_to() const;

  /// The recommendation that stands, if it may go on standing beside the smallest change.
  [[nodiscard]] std::optional<Change> standing(const Standing& standing, const Change& smallest) const {
    std::optional<Change> found;
    candidates_.for_each([&](const Change& candidate, const Cell& cell) {
      if (!found && is_same(candidate, standing) && still_does(cell, smallest)) {
        found = candidate;
        candidates_.count_turn(*found, standing.side);
      }
    });
    if (found && !(found->effort <= kStandingFactor * smallest.effort + kStandingSlack)) {
      found.reset();
    }
    return found;
  }

 private:
  /// Of the cell that a standing recommendation goes to: better than the present one, and not much worse than
  /// where the smallest change leads.
  [[nodiscard]] bool still_does(const Cell& cell, const Change& smallest) const {
    if (meets(cell)) {
      return true;
    }
    const bool is_better = severity(cell.verdict) < severity(present_cell_.verdict) ||
                           badness(cell) * kStandingGain <= badness(present_cell_);
    const bool is_good_enough = cell.verdict == Verdict::kCaution || aim_ == Aim::kLeastBad;
    return candidates_.may_be_recommended(cell) && is_better && is_good_enough &&
           badness(cell) <= kStandingWithin * badness(smallest);
  }

  [[nodiscard]] bool meets(const Cell& cell) const {
    if (!candidates_.may_be_recommended(cell)) {
      return false;
    }
    switch (aim_) {
      case Aim::kGood:
        return cell.verdict == Verdict::kGood;
      case Aim::kCaution:
        return cell.verdict == Verdict::kCaution;
      case Aim::kLeastBad:
        return cell.verdict == Verdict::kExceeded && badness(cell) < badness(present_cell_) &&
               badness(cell) <= kLeastBadWithin * least_badness_;
      case Aim::kNothing:
        break;
    }
    return false;
  }

  Aim find_aim() {
    std::array<bool, 4> any{};  // by verdict
    for (std::size_t v = 0; v < candidates_.grid().num_speeds; ++v) {
      for (std::size_t h = 0; h < candidates_.grid().num_headings; ++h) {
        const Cell& cell = candidates_.grid().cells[v][h];
        if (candidates_.may_be_recommended(cell)) {
          any[static_cast<std::size_t>(cell.verdict)] = true;
          least_badness_ = std::min(least_badness_, badness(cell));
        }
      }
    }
    if (any[static_cast<std::size_t>(Verdict::kGood)]) {
      return Aim::kGood;
    }
    if (present_cell_.verdict != Verdict::kExceeded) {
      return Aim::kNothing;  // caution is no improvement on caution, and nothing is known to beat the unknown
    }
    if (any[static_cast<std::size_t>(Verdict::kCaution)]) {
      return Aim::kCaution;
    }
    return any[static_cast<std::size_t>(Verdict::kExceeded)] ? Aim::kLeastBad : Aim::kNothing;
  }

  static void drop_combined_unless_smallest(Best& best) {
    const bool is_smallest =
        best[kCombined] && std::none_of(best.begin(), best.begin() + kCombined, [&](const auto& pure) {
          return pure && !is_smaller(*best[kCombined], *pure);
        });
    if (!is_smallest) {
      best[kCombined].reset();
    }
  }

  const Candidates& candidates_;
  const Cell& present_cell_;
  double least_badness_ = kWorstBadness;  // of a cell that may be recommended
  Aim aim_;
};

std::optional<Change> Ranking::heave_to() const {
  const Grid& grid = candidates_.grid();
  const Present& present = candidates_.present();
  std::size_t v = 0;
  while (v < grid.num_speeds && (grid.cells[v][0].hazards & kHazardNoSteerage) != 0) {
    ++v;
  }
  if (!present.has_sea_ahead || present_cell_.verdict != Verdict::kExceeded || v == grid.num_speeds) {
    return std::nullopt;
  }
  std::optional<Change> best;
  double best_off = 0.0;
  candidates_.for_each([&](const Change& candidate, const Cell& cell) {
    const double off = std::abs(wrap_pi(candidate.heading - present.sea_from.radians));
    const bool is_there =
        std::abs(candidate.speed - grid.speeds[v]) <= kNoSpeedChange && off <= kHeaveToSector;
    const bool is_better = cell.verdict < present_cell_.verdict || badness(cell) < badness(present_cell_);
    if (!is_there || !candidates_.may_be_recommended(cell) || !is_better) {
      return;
    }
    const bool goes_before =
        !best || cell.verdict < best->verdict ||
        (cell.verdict == best->verdict &&
         (cell.margin > best->margin || (cell.margin == best->margin && off < best_off - kNoTurn)));
    if (goes_before) {
      best = candidate;
      best_off = off;
    }
  });
  if (best) {
    candidates_.count_turn(*best);
    best->kind = ChangeKind::kHeaveTo;
  }
  return best;
}

/// Insertion of a handful: std::sort recurses. The first `fixed` stay where they are.
void insert_in_order(const Change& change, std::size_t fixed, Advice& out) {
  QS_CHECK(out.changes.push_back(change));
  for (std::size_t i = out.changes.size() - 1; i > fixed && is_smaller(out.changes[i], out.changes[i - 1]);
       --i) {
    std::swap(out.changes[i], out.changes[i - 1]);
  }
}

/// One that is there already only gets the name.
void add_named(const std::optional<Change>& change, ChangeKind kind, Advice& out) {
  if (!change) {
    return;
  }
  for (Change& there : out.changes) {
    if (goes_to_the_same(there, *change)) {
      there.kind = there.kind == ChangeKind::kOther ? kind : there.kind;
      return;
    }
  }
  Change named = *change;
  named.kind = kind;
  insert_in_order(named, 1, out);
}

void list_changes(const Ranking& ranking, const Standing& standing, Advice& out) {
  Best best = ranking.smallest_of_each_sort();
  for (const auto& change : best) {
    if (change) {
      insert_in_order(*change, 0, out);
    }
  }
  if (!out.changes.empty() && standing.is_there) {
    if (const auto stands = ranking.standing(standing, out.changes[0])) {
      best[sort_of(*stands)] = stands;
      out.changes.clear();
      insert_in_order(*stands, 0, out);
      for (const auto& change : best) {
        if (change && !goes_to_the_same(*change, *stands)) {
          insert_in_order(*change, 1, out);
        }
      }
    }
  }
  if (!out.changes.empty()) {
    out.changes[0].kind = ChangeKind::kSmallest;
    add_named(ranking.larger_than(out.changes[0]), ChangeKind::kLarger, out);
  }
  const bool little_works =
      out.changes.empty() || ranking.aim() != Aim::kGood || out.changes[0].effort > kLittleWorks;
  if (little_works) {
    const bool is_first = out.changes.empty();
    add_named(ranking.heave_to(), ChangeKind::kHeaveTo, out);
    QS_CHECK(!is_first || out.changes.size() <= 1);
  }
}

}  // namespace

Standing standing_of(const Change& change) {
  const bool turns = std::abs(change.heading_change) > kNoTurn;
  return {.is_there = true,
          .turns = turns,
          .changes_speed = std::abs(change.speed_change) > kNoSpeedChange,
          .side = !turns ? 0 : (change.heading_change > 0.0 ? 1 : -1),
          .heading = change.heading,
          .speed = change.speed};
}

void rank_changes(const Grid& grid, const Present& present, const Cell& present_cell, Advice& out,
                  const Standing& standing) {
  QS_CHECK(grid.num_speeds > 0 && grid.num_headings > 0);
  out = Advice{.no_advice = NoAdvice::kNone,
               .heading = present.heading,
               .speed = present.speed,
               .present = present_cell,
               .verdict_now = present_cell.verdict,
               .next = present_cell.next,
               .next_margin = next_margin(present_cell),
               .changes = {},
               .change_needed = present_cell.verdict != Verdict::kGood};
  if (!out.change_needed) {
    return;
  }
  const Candidates candidates(grid, present, present_cell);
  const Ranking ranking(candidates, present_cell);
  out.none_is_good = ranking.aim() != Aim::kGood;
  list_changes(ranking, standing, out);
  for (Change& change : out.changes) {
    change.turn = sum_up_turn(grid, candidates.turn_start(), {change.heading_change, change.speed_change});
  }
  out.no_change_helps = out.changes.empty();
}

}  // namespace quickstrip
