#include "core/advice/turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/check.hpp"
#include "core/base/static_vector.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxVisits = kMaxHeadings + kMaxSpeeds + 1;
constexpr int kRollBisections = 24;  // of 6 s: to 4e-7 s

/// A stay in one cell.
struct Visit {
  const Cell& cell;
  double heading = 0.0;  // in the middle of the stay [rad]
  double speed = 0.0;    // m/s
  double time = 0.0;     // s
};

/// Walks along the headings of the grid: units of its step, boundaries at the halves.
class HeadingWalk {
 public:
  HeadingWalk(const Grid& grid, const TurnStart& start, const Way& way)
      : count_(static_cast<std::ptrdiff_t>(grid.num_headings)),
        sign_(way.heading_change < 0.0 ? -1 : 1),
        from_(wrap_two_pi(start.heading.radians) / kTwoPi * static_cast<double>(count_)),
        rate_(start.handling.turn_rate / kTwoPi * static_cast<double>(count_)),
        end_(std::abs(way.heading_change) / start.handling.turn_rate),
        column_(static_cast<std::ptrdiff_t>(std::floor(from_ + 0.5))) {}

  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] std::size_t column() const {
    return static_cast<std::size_t>(((column_ % count_) + count_) % count_);
  }
  /// When the next boundary is crossed.
  [[nodiscard]] double next() const {
    const double boundary = static_cast<double>(column_) + 0.5 * static_cast<double>(sign_);
    return (boundary - from_) * static_cast<double>(sign_) / rate_;
  }
  void advance() { column_ += sign_; }
  [[nodiscard]] double heading(double time) const {
    const double turned = static_cast<double>(sign_) * rate_ * std::min(time, end_);
    return wrap_two_pi((from_ + turned) * kTwoPi / static_cast<double>(count_));
  }

 private:
  std::ptrdiff_t count_;
  std::ptrdiff_t sign_;
  double from_;
  double rate_;  // columns a second
  double end_;
  std::ptrdiff_t column_;
};

/// The same along the speeds; beyond the first and the last there is no boundary.
class SpeedWalk {
 public:
  SpeedWalk(const Grid& grid, const TurnStart& start, const Way& way)
      : grid_(grid),
        faster_(way.speed_change > 0.0),
        from_(start.speed),
        rate_(faster_ ? start.handling.speeding_up : start.handling.slowing),
        end_(std::abs(way.speed_change) / rate_) {
    while (row_ + 1 < grid.num_speeds && is_nearer_to_next(start.speed)) {
      ++row_;
    }
  }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] std::size_t row() const { return row_; }
  [[nodiscard]] double next() const {
    if (faster_ ? row_ + 1 >= grid_.num_speeds : row_ == 0) {
      return end_;
    }
    const std::size_t lower = faster_ ? row_ : row_ - 1;
    const double boundary = 0.5 * (grid_.speeds[lower] + grid_.speeds[lower + 1]);
    return std::abs(boundary - from_) / rate_;
  }
  void advance() { row_ = faster_ ? row_ + 1 : row_ - 1; }
  [[nodiscard]] double speed(double time) const {
    return from_ + (faster_ ? 1.0 : -1.0) * rate_ * std::min(time, end_);
  }

 private:
  /// At a boundary the ship counts to the cell that she goes to.
  [[nodiscard]] bool is_nearer_to_next(double speed) const {
    const double boundary = 0.5 * (grid_.speeds[row_] + grid_.speeds[row_ + 1]);
    return faster_ ? speed >= boundary : speed > boundary;
  }

  const Grid& grid_;
  bool faster_;
  double from_;
  double rate_;  // m/s2
  double end_;
  std::size_t row_ = 0;
};

/// visit(Visit) for each cell in the order of time. Its stays add up to the time of the turn.
template <typename Visitor>
void walk(const Grid& grid, const TurnStart& start, const Way& way, const Visitor& visit) {
  HeadingWalk course(grid, start, way);
  SpeedWalk speed(grid, start, way);
  const double end = std::max(course.end(), speed.end());
  double now = 0.0;
  for (std::size_t i = 0; i < kMaxVisits; ++i) {
    const bool turns_on = course.next() < course.end();
    const bool goes_on = speed.next() < speed.end();
    const double next_course = turns_on ? course.next() : end;
    const double next_speed = goes_on ? speed.next() : end;
    const double until = std::max(now, std::min({next_course, next_speed, end}));
    const double middle = 0.5 * (now + until);
    if (until > now) {
      visit(Visit{grid.cells[speed.row()][course.column()], course.heading(middle), speed.speed(middle),
                  until - now});
    }
    if (!turns_on && !goes_on) {
      return;
    }
    if (turns_on && next_course <= next_speed) {
      course.advance();
    } else {
      speed.advance();
    }
    now = until;
  }
}

struct RollStay {
  double cycles = 0.0;
  double rms = 0.0;
};
using RollStays = StaticVector<RollStay, kMaxVisits>;

/// E(a) of the header.
double exponent(const RollStays& stays, double level) {
  double sum = 0.0;
  for (const RollStay& stay : stays) {
    if (stay.rms > 0.0) {
      const double ratio = level / stay.rms;
      sum -= stay.cycles * std::log(-std::expm1(-0.5 * ratio * ratio));
    }
  }
  return sum;
}

double most_probable_largest(const RollStays& stays) {
  double greatest = 0.0;
  double cycles = 0.0;
  for (const RollStay& stay : stays) {
    greatest = std::max(greatest, stay.rms);
    cycles += stay.cycles;
  }
  // With all n amplitudes at the greatest RMS the level sought has exp(-a^2 / 2 s^2) = 1 - exp(-1/n), which
  // is more than 1 / (2 n + 2) for every n > 0: bracketed from above.
  double low = 0.0;
  double high = greatest * std::sqrt(2.0 * std::log(2.0 * cycles + 2.0));
  for (int i = 0; i < kRollBisections && greatest > 0.0; ++i) {
    const double level = 0.5 * (low + high);
    (exponent(stays, level) > 1.0 ? low : high) = level;
  }
  return 0.5 * (low + high);
}

double how_bad(Verdict verdict, std::uint8_t governing, float margin, std::uint16_t hazards) {
  const bool says_nothing = governing == kNoCriterion && verdict == Verdict::kUnknown;
  const double by_margin =
      says_nothing ? 1.0 : 1.0 / std::max(static_cast<double>(margin), 1.0 / kWorstBadness);
  double least = 0.0;
  if (verdict == Verdict::kUnknown) {
    least = 1.0;
  } else if (verdict == Verdict::kExceeded && (hazards & kSevereZoneBits) != 0) {
    least = kSevereZoneBadness;
  }
  return std::max(by_margin, least);
}

bool is_worse(const Cell& cell, const Turn& than, double than_badness) {
  return !than.is_known || badness(cell) > than_badness;
}

void note_worst(const Visit& at, Turn& out, double& out_badness) {
  if (!is_worse(at.cell, out, out_badness)) {
    return;
  }
  out.is_known = true;
  out_badness = badness(at.cell);
  out.worst_verdict = at.cell.verdict;
  out.worst_governing = at.cell.governing;
  out.worst_system = at.cell.governing_system;
  out.worst_hazards = at.cell.hazards;
  out.worst_margin = at.cell.margin;
  out.worst_heading = static_cast<float>(at.heading);
  out.worst_speed = static_cast<float>(at.speed);
}

}  // namespace

double badness(const Cell& cell) {
  return how_bad(cell.verdict, cell.governing, cell.margin, cell.hazards);
}

double badness(const Change& change) {
  return how_bad(change.verdict, change.governing, change.margin, change.hazards);
}

int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return 0;
    case Verdict::kCaution:
      return 1;
    case Verdict::kUnknown:
      return 2;
    case Verdict::kExceeded:
      break;
  }
  return 3;
}

double turn_exposure(const Grid& grid, const TurnStart& start, const Way& way, double reference) {
  const double ceiling = std::max(1.0, reference);
  double exposure = 0.0;
  walk(grid, start, way,
       [&](const Visit& at) { exposure += at.time * std::max(0.0, badness(at.cell) - ceiling); });
  return exposure;
}

Turn sum_up_turn(const Grid& grid, const TurnStart& start, const Way& way) {
  Turn out;
  double worst = 0.0;
  double time = 0.0;
  double exceeded = 0.0;
  double unknown = 0.0;
  RollStays stays;
  walk(grid, start, way, [&](const Visit& at) {
    note_worst(at, out, worst);
    time += at.time;
    exceeded += at.cell.verdict == Verdict::kExceeded ? at.time : 0.0;
    unknown += at.cell.verdict == Verdict::kUnknown ? at.time : 0.0;
    const double cycles = start.roll_period > 0.0 ? at.time / start.roll_period : 0.0;
    QS_CHECK(stays.push_back({cycles, static_cast<double>(at.cell.rms_roll)}));
  });
  out.time = static_cast<float>(time);
  out.time_exceeded = static_cast<float>(exceeded);
  out.time_unknown = static_cast<float>(unknown);
  if (out.is_known && start.roll_period > 0.0) {
    out.max_roll = static_cast<float>(most_probable_largest(stays));
  }
  return out;
}

}  // namespace quickstrip
