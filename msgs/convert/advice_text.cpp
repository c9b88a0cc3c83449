#include "msgs/convert/advice_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"
#include "msgs/convert/quality_text.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kMinute_s = 60.0;
constexpr double kHour_s = 3600.0;
constexpr double kTwoHours_s = 7200.0;  // what the model of 1974 means
constexpr double kDay_s = 86'400.0;
constexpr double kNoChange = 1.0e-6;  // of speed [m/s] or heading [rad]: rounding of a grid node

void add_percent(double probability, Sentence& out) {
  const double percent = 100.0 * probability;
  if (percent >= 10.0) {
    out.add("{:.0f} %", percent);
  } else if (percent >= 0.1 || percent == 0.0) {
    out.add("{:.1f} %", percent);
  } else {
    out.add("below 0.1 %");
  }
}

void add_rate(double per_hour, Sentence& out) {
  if (per_hour >= 10.0 || per_hour == 0.0) {
    out.add("{:.0f}/h", per_hour);
  } else {
    out.add("{:.1f}/h", per_hour);
  }
}

void add_value(double core_value, RimUnit unit, Sentence& out) {
  const double value = to_rim(core_value, unit);
  switch (unit) {
    case RimUnit::kMetre:
      return out.add("{:.1f} m", value);
    case RimUnit::kDegree:
      return out.add("{:.1f}°", value);
    case RimUnit::kMetrePerSecondSquared:
      return out.add("{:.3f} g", value / kStandardGravity);  // a limit of 0.12 g is met or not at 0.001 g
    case RimUnit::kProbability:
      return add_percent(value, out);
    case RimUnit::kPerHour:
      return add_rate(value, out);
    case RimUnit::kShareOfPeople:
      add_percent(value, out);
      return out.add(" of people");
    case RimUnit::kPerMinute:
      return out.add("{:.2f}/min", value);
  }
}

void add_speed(double metres_per_second, Sentence& out) {
  const double knots = to_knots(metres_per_second);
  if (std::abs(knots - std::round(knots)) < 0.05) {
    out.add("{:.0f} kn", knots);
  } else {
    out.add("{:.1f} kn", knots);
  }
}

// 360 after rounding is north.
double whole_degrees(double heading) {
  return std::fmod(std::round(degrees(wrap_two_pi(heading))), 360.0);
}

const char* subject(NoAdvice reason) {
  switch (reason) {
    case NoAdvice::kSeaMissing:
    case NoAdvice::kSeaStale:
    case NoAdvice::kSeaImplausible:
      return "the sea state";
    case NoAdvice::kOwnShipMissing:
    case NoAdvice::kOwnShipStale:
    case NoAdvice::kOwnShipImplausible:
      return "the ship's heading and speed";
    default:
      return "the loading condition";
  }
}

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

bool governs(const Cell& cell, const Criteria& criteria) {
  return cell.governing < criteria.size() && cell.values[cell.governing] >= 0.0F;
}

// Singular verb for "heading and speed", which are one message.
bool is_plural(NoAdvice reason) {
  return reason == NoAdvice::kOwnShipMissing || reason == NoAdvice::kOwnShipStale ||
         reason == NoAdvice::kOwnShipImplausible;
}

void add_why(const Advice& advice, const Criteria& criteria, Sentence& out) {
  const Cell& cell = advice.present;
  const bool has_governing = governs(cell, criteria);
  switch (cell.verdict) {
    case Verdict::kGood:
      out.add("{}", has_governing ? "All limits kept; nearest: " : "All limits kept");
      break;
    case Verdict::kCaution:
      out.add("{}", has_governing ? "Near a limit: " : "Near a limit");
      break;
    case Verdict::kExceeded:
      out.add("{}", has_governing ? "" : "A limit is exceeded");
      break;
    case Verdict::kUnknown: {
      const auto* const missing =
          std::find_if(criteria.begin(), criteria.end(), [](const Criterion& c) { return !c.is_watched(); });
      if (missing != criteria.end()) {
        out.add("Not judged: the hull file gives no place for \"{}\"", missing->name.view());
      } else {
        out.add("Not judged");
      }
      out.add("{}", has_governing ? "; nearest: " : "");
      break;
    }
  }
  if (has_governing) {
    add_criterion(criteria[cell.governing], static_cast<double>(cell.values[cell.governing]), cell, out);
  }
  out.capitalise();
}

void add_notes(const Cell& cell, Sentence& out) {
  out.add("{}", (cell.hazards & kHazardNoSteerage) != 0 ? ". Below steerage speed" : "");
  out.add("{}", (cell.hazards & kHazardFollowingUnwatched) != 0
                    ? ". Following sea: slow motions are not fully covered"
                    : "");
  for (const QualityWords& words : kQualityWords) {
    if ((cell.quality & words.bit) != 0 && *words.bridge != '\0') {
      out.add(". {}", words.bridge);
    }
  }
}

}  // namespace

void add_duration(double seconds, Sentence& out) {
  const double s = seconds >= 0.0 ? std::floor(seconds) : 0.0;
  if (s < 2.0 * kMinute_s) {
    out.add("{:.0f} s", s);
  } else if (s < 2.0 * kHour_s) {
    out.add("{:.0f} min", std::floor(s / kMinute_s));
  } else if (s < 2.0 * kDay_s) {
    const double minutes = std::floor(std::fmod(s, kHour_s) / kMinute_s);
    out.add("{:.0f} h", std::floor(s / kHour_s));
    if (minutes > 0.0) {
      out.add(" {:.0f} min", minutes);
    }
  } else {
    const double hours = std::floor(std::fmod(s, kDay_s) / kHour_s);
    out.add("{:.0f} d", std::floor(s / kDay_s));
    if (hours > 0.0) {
      out.add(" {:.0f} h", hours);
    }
  }
}

void add_no_advice(NoAdvice reason, const NoAdviceDetail& detail, Sentence& out) {
  out.add("No advice, because ");
  switch (reason) {
    case NoAdvice::kNone:
    case NoAdvice::kInternal:
      return out.add("of an internal error");
    case NoAdvice::kNotConfigured:
      return out.add("the advisor is not ready yet");
    case NoAdvice::kSeaMissing:
    case NoAdvice::kOwnShipMissing:
    case NoAdvice::kLoadingMissing:
      return out.add("{} {} not been received", subject(reason), is_plural(reason) ? "have" : "has");
    case NoAdvice::kSeaStale:
    case NoAdvice::kOwnShipStale:
    case NoAdvice::kLoadingStale:
      out.add("{} {} ", subject(reason), is_plural(reason) ? "are" : "is");
      add_duration(detail.age_s, out);
      out.add(" old (limit ");
      add_duration(detail.limit_s, out);
      return out.add(")");
    case NoAdvice::kSeaImplausible:
    case NoAdvice::kOwnShipImplausible:
    case NoAdvice::kLoadingImplausible:
      out.add("{} {} refused", subject(reason), is_plural(reason) ? "were" : "was");
      if (detail.refusal != Refusal::kNone) {
        out.add(": {} ({})", message(detail.refusal), detail.field);
      }
      return;
    case NoAdvice::kLoadingChanged:
      return out.add("the ship's responses are being computed for a new loading");
    case NoAdvice::kSpeedOutsideGrid:
      out.add("the speed ");
      add_speed(detail.speed, out);
      return out.add(" is outside the grid ({:.0f} to {:.0f} kn)", to_knots(detail.grid_from),
                     to_knots(detail.grid_to));
  }
}

void add_criterion(const Criterion& criterion, double value, const Cell& cell, Sentence& out) {
  const RimUnit unit = rim_unit(criterion.quantity, criterion.statistic);
  out.add("{} ", criterion.name.view());
  add_value(value, unit, out);
  switch (criterion.statistic) {
    case Statistic::kRms:
      out.add(" RMS");
      break;
    case Statistic::kSignificant:
      out.add(" significant");
      break;
    case Statistic::kProbability:
      out.add(" of encounters");
      if (criterion.quantity == Quantity::kSlamming && cell.slams_per_hour >= 0.0F) {
        out.add(" (");
        add_rate(static_cast<double>(cell.slams_per_hour), out);
        out.add(")");
      }
      break;
    case Statistic::kPerHour:
    case Statistic::kPerMinute:
      break;
    case Statistic::kShareOfPeople:
      out.add(" sick in ");
      add_duration(criterion.exposure > 0.0 ? criterion.exposure : kTwoHours_s, out);
      break;
  }
  out.add(", limit ");
  add_value(criterion.limit, unit, out);
}

void add_action(const Change& change, Sentence& out) {
  const bool turns = std::abs(change.heading_change) > kNoChange;
  const bool speeds = std::abs(change.speed_change) > kNoChange;
  if (turns) {
    out.add("come {:.0f}° to {}", std::round(degrees(std::abs(change.heading_change))),
            change.heading_change > 0.0 ? "starboard" : "port");
  }
  if (speeds) {
    out.add("{}{} to ", turns ? " and " : "", change.speed_change < 0.0 ? "reduce" : "increase");
    add_speed(change.speed, out);
  }
  if (!turns && !speeds) {
    out.add("keep course and speed");
  }
}

void add_change(const Change& change, const Cell* cell, const Criteria& criteria, Sentence& out) {
  add_action(change, out);
  if (std::abs(change.heading_change) > kNoChange) {
    out.add(" (course {:03.0f}°)", whole_degrees(change.heading));
  }
  out.add(": {}", verdict_words(change.verdict));
  if (cell != nullptr && governs(*cell, criteria)) {
    out.add("; nearest: ");
    add_criterion(criteria[cell->governing], static_cast<double>(cell->values[cell->governing]), *cell, out);
  }
  out.capitalise();
}

void add_reasons(const Advice& advice, const Criteria& criteria, Sentence& out) {
  add_why(advice, criteria, out);
  if (advice.change_needed) {
    const bool is_lost = advice.no_change_helps || advice.changes.empty();
    if (is_lost) {
      out.add(": no other course or speed is better");
    } else {
      out.add("{}", advice.none_is_good ? ": no course and speed keeps all limits; best: " : ": ");
      add_action(advice.changes[0], out);
      if (advice.changes.size() > 1) {
        out.add(", or ");
        add_action(advice.changes[1], out);
      }
    }
  }
  add_notes(advice.present, out);
}

}  // namespace quickstrip
