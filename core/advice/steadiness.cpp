#include "core/advice/steadiness.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

// Of a cell's memory: two bits each for the verdict that is shown and the worst one while it waits, twelve
// for how long: 4,000 ticks are a dwell.
constexpr std::uint32_t kTicksOfDwell = 4000;
constexpr double kSlowTicks = kHardlyBetter;

constexpr std::array<Verdict, 4> kBySeverity{Verdict::kGood, Verdict::kCaution, Verdict::kUnknown,
                                             Verdict::kExceeded};

std::uint16_t packed(int shown, int worst, std::uint32_t waited) {
  return static_cast<std::uint16_t>(static_cast<std::uint32_t>(shown) |
                                    static_cast<std::uint32_t>(worst) << 2U | waited << 4U);
}

/// Margin at which a criterion turns from caution to good. Of a rate per hour as if 360 encounters an hour:
/// its own number is not at hand, and the hysteresis needs no more.
double caution_margin(const Criterion& criterion) {
  const double part = criterion.caution_fraction;
  switch (criterion.statistic) {
    case Statistic::kProbability:
      return std::sqrt(1.0 + std::log(1.0 / part) / -std::log(criterion.limit));
    case Statistic::kPerHour: {
      constexpr double kEncountersPerHour = 360.0;
      const double probability = std::min(criterion.limit / kEncountersPerHour, 0.5);
      return std::sqrt(1.0 + std::log(1.0 / part) / -std::log(probability));
    }
    default:
      return 1.0 / part;
  }
}

}  // namespace

bool is_clearly_better(const Cell& cell, Verdict shown, const Criteria& criteria, double hysteresis) {
  if (cell.governing >= criteria.size()) {
    return true;
  }
  const auto margin = static_cast<double>(cell.margin);
  const double wanted = cell.verdict == Verdict::kGood ? caution_margin(criteria[cell.governing]) : 1.0;
  // From unknown to caution no margin has been passed.
  const bool has_passed = shown == Verdict::kExceeded || cell.verdict == Verdict::kGood;
  return !has_passed || margin >= (1.0 + hysteresis) * wanted;
}

CellIndex nearest_cell(const Grid& grid, Heading heading, double speed) {
  QS_CHECK(grid.num_speeds > 0 && grid.num_headings > 0);
  const auto n = static_cast<double>(grid.num_headings);
  const auto h =
      static_cast<std::size_t>(std::lround(wrap_two_pi(heading.radians) / kTwoPi * n)) % grid.num_headings;
  std::size_t v = 0;
  while (v + 1 < grid.num_speeds && 0.5 * (grid.speeds[v] + grid.speeds[v + 1]) <= speed) {
    ++v;
  }
  return {v, h};
}

void Steadiness::configure(const SteadinessOptions& options) {
  options_ = options;
  has_time_ = false;
  sea_source_ = 0;
  forget();
}

void Steadiness::forget() {
  has_cells_ = false;
  present_ = {};
  standing_ = {};
}

void Steadiness::begin(double time, int sea_source) {
  const double step = has_time_ ? time - time_ : 0.0;
  const bool is_given = time != 0.0 || step != 0.0;
  // Written so that a time that is no number forgets too.
  const bool follows = has_time_ && is_given && step >= 0.0 && step <= options_.dwell;
  if (!follows) {
    forget();
    origin_ = time;
    source_since_ = time - options_.dwell;
    sea_source_ = sea_source;
  }
  step_ = follows ? step : 0.0;
  const double tick = options_.dwell / kTicksOfDwell;
  const auto whole = [&](double at, double part) {
    return tick > 0.0 ? std::floor(part * (at - origin_) / tick) : 0.0;
  };
  ticks_ = follows ? static_cast<std::uint32_t>(whole(time, 1.0) - whole(time_, 1.0)) : 0U;
  slow_ticks_ = follows ? static_cast<std::uint32_t>(whole(time, kSlowTicks) - whole(time_, kSlowTicks)) : 0U;
  if (sea_source != sea_source_) {
    if (time - source_since_ >= options_.dwell) {
      forget();
    }
    source_since_ = time;
    sea_source_ = sea_source;
  }
  has_time_ = std::isfinite(time);
  time_ = time;
}

void Steadiness::steady(const Criteria& criteria, Grid& grid) {
  const bool is_known = has_cells_ && num_speeds_ == grid.num_speeds && num_headings_ == grid.num_headings;
  num_speeds_ = grid.num_speeds;
  num_headings_ = grid.num_headings;
  has_cells_ = options_.dwell > 0.0;
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < grid.num_headings; ++h) {
      Cell& cell = grid.cells[v][h];
      const std::uint16_t before = is_known ? memory_[v][h] : packed(severity(cell.verdict), 0, 0);
      memory_[v][h] = remembered(before, cell, criteria);
      cell.verdict = kBySeverity[memory_[v][h] & 3U];
    }
  }
}

/// The memory of a cell after this cycle.
std::uint16_t Steadiness::remembered(std::uint16_t before, const Cell& cell, const Criteria& criteria) const {
  const int now = severity(cell.verdict);
  const int shown = before & 3;
  if (now >= shown) {
    return packed(now, 0, 0);
  }
  const std::uint32_t waited = before >> 4;  // 0: not yet, else 1 + ticks
  if (waited == 0) {
    return packed(shown, now, 1);
  }
  const Verdict shown_verdict = kBySeverity[static_cast<std::size_t>(shown)];
  const bool is_clear = is_clearly_better(cell, shown_verdict, criteria, options_.hysteresis);
  const int worst = std::max(now, before >> 2 & 3);
  const std::uint32_t waits = waited + (is_clear ? ticks_ : slow_ticks_);
  return waits > kTicksOfDwell ? packed(worst, 0, 0) : packed(shown, worst, waits);
}

Steadiness::Shown Steadiness::present(const Criteria& criteria, const Grid& grid, const Present& at,
                                      const Cell& cell) {
  PresentMemory& memory = present_;
  const bool stays = memory.is_there && std::abs(at.speed - memory.speed) <= kOtherSpeed &&
                     std::abs(wrap_pi(at.heading.radians - memory.heading.radians)) <= kOtherCourse;
  if (!stays) {
    memory = start(grid, at, cell);
  } else {
    wait(criteria, cell, memory);
  }
  if (!memory.is_waiting) {
    return {memory.shown, 0.0};
  }
  const double rate =
      is_clearly_better(cell, memory.shown, criteria, options_.hysteresis) ? 1.0 : kHardlyBetter;
  return {memory.shown, (options_.dwell - memory.waited) / rate};
}

/// On another course or speed: what is shown of the cell there, and what of its waiting is over.
Steadiness::PresentMemory Steadiness::start(const Grid& grid, const Present& at, const Cell& cell) const {
  PresentMemory memory{
      .is_there = options_.dwell > 0.0, .heading = at.heading, .speed = at.speed, .shown = cell.verdict};
  const CellIndex there = nearest_cell(grid, at.heading, at.speed);
  const Verdict shown = grid.cells[there.speed][there.heading].verdict;
  if (!memory.is_there || severity(shown) <= severity(cell.verdict)) {
    return memory;
  }
  const auto waited = static_cast<std::uint32_t>(memory_[there.speed][there.heading] >> 4);
  memory.is_waiting = true;
  memory.shown = shown;
  memory.worst = cell.verdict;
  memory.waited = waited == 0 ? 0.0 : options_.dwell * static_cast<double>(waited - 1) / kTicksOfDwell;
  return memory;
}

void Steadiness::wait(const Criteria& criteria, const Cell& cell, PresentMemory& memory) const {
  if (severity(cell.verdict) >= severity(memory.shown)) {
    memory.shown = cell.verdict;
    memory.is_waiting = false;
    return;
  }
  if (!memory.is_waiting) {
    memory.is_waiting = true;
    memory.worst = cell.verdict;
    memory.waited = 0.0;
    return;
  }
  const bool is_clear = is_clearly_better(cell, memory.shown, criteria, options_.hysteresis);
  memory.waited += is_clear ? step_ : kHardlyBetter * step_;
  memory.worst = severity(cell.verdict) > severity(memory.worst) ? cell.verdict : memory.worst;
  if (memory.waited >= options_.dwell) {
    memory.shown = memory.worst;
    memory.is_waiting = severity(cell.verdict) < severity(memory.shown);
    memory.worst = cell.verdict;
    memory.waited = 0.0;
  }
}

Standing Steadiness::standing(const Present& at) const {
  Standing out = standing_;
  out.turns = out.turns && std::abs(wrap_pi(out.heading - at.heading.radians)) > kCourseReached;
  out.changes_speed = out.changes_speed && std::abs(out.speed - at.speed) > kSpeedReached;
  out.is_there = out.is_there && (out.turns || out.changes_speed);
  return out;
}

void Steadiness::follow(const Advice& advice) {
  standing_ = advice.changes.empty() || options_.dwell <= 0.0 ? Standing{} : standing_of(advice.changes[0]);
}

}  // namespace quickstrip
