#include "msgs/convert/advice_text.hpp"

#include <cmath>

#include "core/base/constants.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kMinute_s = 60.0;
constexpr double kHour_s = 3600.0;
constexpr double kTwoHours_s = 7200.0;  // what the model of 1974 means
constexpr double kDay_s = 86'400.0;

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

// Singular verb for "heading and speed", which are one message.
bool is_plural(NoAdvice reason) {
  return reason == NoAdvice::kOwnShipMissing || reason == NoAdvice::kOwnShipStale ||
         reason == NoAdvice::kOwnShipImplausible;
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
    case NoAdvice::kSelfTestFailed:
      return out.add("the self-test failed: {}", detail.self_test);
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

void add_value_and_limit(const Criterion& criterion, double value, Sentence& out) {
  const RimUnit unit = rim_unit(criterion.quantity, criterion.statistic);
  out.add("{} ", criterion.name.view());
  add_value(value, unit, out);
  out.add(", limit ");
  add_value(criterion.limit, unit, out);
}

void add_speed(double metres_per_second, Sentence& out) {
  const double knots = to_knots(metres_per_second);
  if (std::abs(knots - std::round(knots)) < 0.05) {
    out.add("{:.0f} kn", knots);
  } else {
    out.add("{:.1f} kn", knots);
  }
}

double whole_degrees(double heading) {
  return std::fmod(std::round(degrees(wrap_two_pi(heading))), 360.0);
}

void add_reasons(const Advice& advice, const Criteria& criteria, WaveSystems systems, Sentence& out) {
  const bool waits = advice.better_in > 0.0;
  Cell now = advice.present;
  now.verdict = waits ? advice.verdict_now : now.verdict;
  add_why(now, criteria, systems, out);
  if (advice.change_needed && (advice.no_change_helps || advice.changes.empty())) {
    out.add(": no other course or speed is better");
  } else if (advice.change_needed) {
    out.add("{}", advice.none_is_good ? ": no course and speed keeps all limits; best: " : ": ");
    add_action(advice.changes[0], out);
    if (advice.changes.size() > 1) {
      out.add(", or ");
      add_action(advice.changes[1], out);
    }
  }
  if (waits) {
    Sentence part;
    part.add(". Better only lately: ");
    add_duration(advice.better_in, part);
    part.add(" until it counts");
    out.add_whole(part, kReasonBytes);
  }
  add_notes(now, out);
}

}  // namespace quickstrip
