#include "msgs/convert/change_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/angles.hpp"
#include "msgs/convert/advice_text.hpp"
#include "msgs/convert/hazard_text.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kFieldBytes = 159;  // of change_text and turn_text, beside the final NUL
constexpr double kNoChange = 1.0e-6;      // of speed [m/s] or heading [rad]: rounding of a grid node
// What of a turn is worth a sentence; ours.
constexpr float kWorseThanItsEnds = 0.95F;  // factor on their margins
constexpr double kRollWorthSaying = radians(5.0);
constexpr double kTurnWorthSaying = radians(15.0);
constexpr double kTimeWorthSaying_s = 20.0;

const char* verdict_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kCaution:
      return "near a limit";
    case Verdict::kExceeded:
      return "still above a limit";
    case Verdict::kUnknown:
      return "not judged";
  }
  return "not judged";
}

bool turns(const Change& change) {
  return std::abs(change.heading_change) > kNoChange;
}

/// How the sea comes in on a course; the angle is from the stern.
const char* aspect_words(double heading, const WaveSystem& system) {
  const double mu = std::abs(degrees(encounter_angle({heading}, system.from).radians));
  if (mu < 30.0) {
    return "stern-on";
  }
  if (mu < 75.0) {
    return "through a quartering sea";
  }
  if (mu < 105.0) {
    return "beam-on";
  }
  return mu < 150.0 ? "through a bow sea" : "head-on";
}

/// Where on the way it is worse than at both its ends.
bool passes_worse(const Change& change, const Cell& present) {
  const Turn& turn = change.turn;
  const bool zone = (turn.worst_hazards & kSevereZoneBits & ~static_cast<unsigned>(present.hazards)) != 0;
  const bool unknown = turn.worst_verdict == Verdict::kUnknown && present.verdict != Verdict::kUnknown;
  return zone || unknown || turn.worst_margin < kWorseThanItsEnds * std::min(present.margin, change.margin);
}

/// Where it is worst, and how the sea comes in there.
void add_worst_place(const Change& change, WaveSystems systems, Sentence& out) {
  const auto heading = static_cast<double>(change.turn.worst_heading);
  out.add(" passes {}{:03.0f}°", turns(change) ? "" : "at ", whole_degrees(heading));
  if (change.turn.worst_system < systems.size()) {
    out.add(" {}", aspect_words(heading, systems[change.turn.worst_system]));
  }
}

/// What is worst there.
void add_worst_reason(const Turn& turn, const Criteria& criteria, Sentence& out) {
  Sentence part;
  if (turn.worst_verdict == Verdict::kUnknown) {
    part.add("; not judged there");
  } else if (turn.worst_verdict == Verdict::kExceeded && turn.worst_margin >= 1.0F) {
    const HazardWords* const zone = leading_zone(turn.worst_hazards);
    part.add("; there {}", zone != nullptr ? zone->name : "above a limit");
  } else if (turn.worst_governing < criteria.size()) {
    part.add("; there {}, ", criteria[turn.worst_governing].name.view());
    add_margin(static_cast<double>(turn.worst_margin), part);
  }
  out.add_whole(part, kFieldBytes);
}

/// The governing criterion there, its figure where the change leads to a cell, and its margin.
void add_governing(const Change& change, const Cell* cell, const Criteria& criteria, Sentence& out) {
  if (change.governing >= criteria.size()) {
    return;
  }
  const Criterion& criterion = criteria[change.governing];
  const bool is_there = cell != nullptr && cell->governing == change.governing;
  const float value = is_there ? cell->values[change.governing] : kNotComputed;
  Sentence part;
  part.add("; ");
  if (value >= 0.0F) {
    add_value_and_limit(criterion, static_cast<double>(value), part);
  } else {
    part.add("{}", criterion.name.view());
  }
  out.add_whole(part, kFieldBytes);
  if (change.margin < kMarginUnbounded) {
    Sentence margin;
    margin.add(", ");
    add_margin(static_cast<double>(change.margin), margin);
    out.add_whole(margin, kFieldBytes);
  }
}

}  // namespace

void add_action(const Change& change, Sentence& out) {
  const bool speeds = std::abs(change.speed_change) > kNoChange;
  if (change.kind == ChangeKind::kHeaveTo) {
    out.add("heave to: ");
  }
  if (turns(change)) {
    out.add("come {:.0f}° to {}{}", std::round(degrees(std::abs(change.heading_change))),
            change.heading_change > 0.0 ? "starboard" : "port",
            std::abs(change.heading_change) > kPi + kNoChange ? " (the longer way)" : "");
  }
  if (speeds) {
    out.add("{}{} to ", turns(change) ? " and " : "", change.speed_change < 0.0 ? "reduce" : "increase");
    add_speed(change.speed, out);
  }
  if (!turns(change) && !speeds) {
    out.add("keep course and speed");
  }
}

void add_change(const Change& change, const Cell* cell, const Criteria& criteria, WaveSystems systems,
                Sentence& out) {
  add_action(change, out);
  if (turns(change)) {
    out.add(" (course {:03.0f}°)", whole_degrees(change.heading));
  }
  out.add(": {}", verdict_words(change.verdict));
  if (const HazardWords* const zone = leading_zone(change.hazards)) {
    out.add(", {}", zone->name);
  }
  add_governing(change, cell, criteria, out);
  if (change.governing_system < systems.size()) {
    Sentence part;
    part.add("; {}", systems.size() > 1 ? "mostly " : "");
    add_system(systems[change.governing_system], part);
    out.add_whole(part, kFieldBytes);
  }
  if (change.next < criteria.size() && change.next_margin < kMarginUnbounded) {
    Sentence part;
    part.add("; next {}, ", criteria[change.next].name.view());
    add_margin(static_cast<double>(change.next_margin), part);
    out.add_whole(part, kFieldBytes);
  }
  out.capitalise();
}

void add_turn(const Change& change, const Cell& present, const Criteria& criteria, WaveSystems systems,
              Sentence& out) {
  const Turn& turn = change.turn;
  const bool is_worse = turn.is_known && passes_worse(change, present);
  const bool rolls = static_cast<double>(turn.max_roll) >= kRollWorthSaying &&
                     std::abs(change.heading_change) >= kTurnWorthSaying;
  const bool is_long_way = std::abs(change.heading_change) > kPi + kNoChange;
  if (!turn.is_known || !(is_worse || rolls || is_long_way)) {
    return;
  }
  if (turns(change)) {
    out.add("Coming to {:03.0f}°", whole_degrees(change.heading));
  } else {
    out.add("Changing speed");
  }
  if (is_worse) {
    add_worst_place(change, systems, out);
  }
  out.add(": ");
  if (turn.max_roll > 0.0F) {
    out.add("{:.0f}° roll likely, ", std::round(degrees(static_cast<double>(turn.max_roll))));
  }
  if (static_cast<double>(turn.time_exceeded) >= kTimeWorthSaying_s) {
    add_duration(static_cast<double>(turn.time_exceeded), out);
    out.add(" above a limit, ");
  }
  out.add("takes ");
  add_duration(static_cast<double>(turn.time), out);
  if (is_long_way) {
    out.add("; the shorter way is worse");
  }
  if (is_worse) {
    add_worst_reason(turn, criteria, out);
  }
}

}  // namespace quickstrip
