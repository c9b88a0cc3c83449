#include "msgs/convert/outlook_message.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/advice/steadiness.hpp"
#include "core/base/angles.hpp"
#include "msgs/convert/change_text.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kUnknown = -1.0;

std::int16_t num_exceeded(const StepOutput& output, double heading, double speed) {
  const CellIndex at = nearest_cell(output.grid, {heading}, speed);
  return static_cast<std::int16_t>(output.ensemble.num_exceeded(at.speed, at.heading));
}

void put_nothing(outlook_t& out) {
  out.present_exceeded = -1;
  out.next_criterion = -1;
  out.next_margin = kUnknown;
  out.expect_s = kExpectAhead_s;
  std::fill(std::begin(out.expected_max), std::end(out.expected_max), kUnknown);
  out.expected_max_roll_deg = kUnknown;
  out.expected_max_pitch_deg = kUnknown;
  out.expected_max_heave_m = kUnknown;
  out.roll_period_low_s = kUnknown;
  out.roll_period_high_s = kUnknown;
  out.unknown_share = kUnknown;
  for (auto& row : out.exceeded) {
    std::fill(std::begin(row), std::end(row), std::int8_t{-1});
  }
  for (std::size_t i = 0; i < kMaxChanges; ++i) {
    out.change_exceeded[i] = -1;
    out.change_kind[i] = outlook_t::CHANGE_OTHER;
    out.change_next_criterion[i] = -1;
    out.change_next_margin[i] = kUnknown;
    out.turn_time_s[i] = kUnknown;
    out.turn_exceeded_s[i] = kUnknown;
    out.turn_worst_heading_deg[i] = kUnknown;
    out.turn_worst_speed_kn[i] = kUnknown;
    out.turn_worst_criterion[i] = -1;
    out.turn_worst_margin[i] = kUnknown;
    out.turn_max_roll_deg[i] = kUnknown;
  }
}

/// Of the highest system: what a person asks for when asking how uncertain the sea is.
void put_deviations(const StepOutput& output, std::uint32_t assumed, outlook_t& out) {
  std::size_t highest = 0;
  for (std::size_t s = 1; s < output.num_systems; ++s) {
    highest = output.systems[s].hs > output.systems[highest].hs ? s : highest;
  }
  const Uncertainty& of = output.ensemble.uncertainty;
  out.std_height_part = of.height_part[highest];
  out.std_period_part = of.period_part[highest];
  out.std_dir_deg = degrees(of.direction[highest]);
  out.std_gm_m = of.gm;
  out.std_roll_damping_part = of.roll_damping_part;
  out.std_assumed = static_cast<std::int32_t>(assumed);
}

void put_ensemble(const StepOutput& output, std::uint32_t assumed, outlook_t& out) {
  out.num_members = static_cast<std::int16_t>(output.ensemble.num_members());
  if (out.num_members == 0) {
    return;
  }
  put_deviations(output, assumed, out);
  for (std::size_t v = 0; v < output.grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      out.exceeded[v][h] = static_cast<std::int8_t>(output.ensemble.num_exceeded(v, h));
    }
  }
}

const QuantityResponse* find_response(const CellResponse& cell, Quantity quantity, std::uint8_t place) {
  const auto* const found =
      std::find_if(cell.quantities.begin(), cell.quantities.end(),
                   [&](const QuantityResponse& r) { return r.quantity == quantity && r.place == place; });
  return found != cell.quantities.end() ? found : nullptr;
}

double expected(const CellResponse& cell, Quantity quantity, std::uint8_t place) {
  const QuantityResponse* const response = find_response(cell, quantity, place);
  return response == nullptr ? kUnknown
                             : to_rim(expected_largest(*response, kExpectAhead_s), rim_unit(quantity));
}

/// People who tip to either side.
double expected_interruptions(const CellResponse& cell, std::uint8_t place) {
  double sum = 0.0;
  for (const QuantityResponse& response : cell.quantities) {
    if (response.quantity == Quantity::kMotionInterruptions && response.place == place) {
      sum += expected_largest(response, kExpectAhead_s);
    }
  }
  return sum;
}

double expected(const CellResponse& cell, const Criterion& criterion) {
  if (criterion.quantity == Quantity::kMotionSickness) {
    return kUnknown;  // of hours, not of the time ahead
  }
  return criterion.quantity == Quantity::kMotionInterruptions
             ? expected_interruptions(cell, criterion.place)
             : expected(cell, criterion.quantity, criterion.place);
}

void put_expected(const CellResponse& cell, const Criteria& criteria, outlook_t& out) {
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    if (criteria[i].is_watched()) {
      out.expected_max[i] = expected(cell, criteria[i]);
    }
  }
  out.expected_max_roll_deg = expected(cell, Quantity::kRoll, 0);
  out.expected_max_pitch_deg = expected(cell, Quantity::kPitch, 0);
  out.expected_max_heave_m = expected(cell, Quantity::kHeave, 0);
}

void put_turn(const Change& change, std::size_t i, outlook_t& out) {
  const Turn& turn = change.turn;
  if (!turn.is_known) {
    return;
  }
  out.turn_time_s[i] = static_cast<double>(turn.time);
  out.turn_exceeded_s[i] = static_cast<double>(turn.time_exceeded);
  out.turn_worst_heading_deg[i] = degrees(wrap_two_pi(static_cast<double>(turn.worst_heading)));
  out.turn_worst_speed_kn[i] = to_knots(static_cast<double>(turn.worst_speed));
  out.turn_worst_verdict[i] = static_cast<std::int8_t>(turn.worst_verdict);
  out.turn_worst_criterion[i] = index_or_none(turn.worst_governing);
  out.turn_worst_margin[i] = static_cast<double>(turn.worst_margin);
  out.turn_max_roll_deg[i] = to_rim(static_cast<double>(turn.max_roll), RimUnit::kDegree);
}

void put_changes(const StepOutput& output, const Criteria& criteria, outlook_t& out) {
  const WaveSystems systems = std::span(output.systems).first(output.num_systems);
  const auto& changes = output.advice.changes;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Change& change = changes[i];
    out.change_exceeded[i] = num_exceeded(output, change.heading, change.speed);
    out.change_kind[i] = static_cast<std::int8_t>(change.kind);
    out.change_next_criterion[i] = index_or_none(change.next);
    out.change_next_margin[i] = static_cast<double>(change.next_margin);
    put_turn(change, i, out);
    Sentence text;
    add_turn(change, output.advice.present, criteria, systems, text);
    put_text(text.view(), out.turn_text[i]);
  }
}

void put_roll_period(const RollPeriodBand& band, outlook_t& out) {
  if (!band.is_known()) {
    return;
  }
  out.roll_period_low_s = band.shortest;
  out.roll_period_high_s = band.longest;
  const bool is_measured = band.source == RollPeriodSource::kMeasured;
  out.roll_period_kind = is_measured ? outlook_t::PERIOD_MEASURED : outlook_t::PERIOD_COMPUTED;
}

}  // namespace

void to_message(const StepOutput& output, const Criteria& criteria, std::uint32_t assumed, outlook_t& out) {
  out = outlook_t{};
  put_nothing(out);
  const Advice& advice = output.advice;
  if (output.grid.num_speeds > 0 && output.grid.num_headings > 0) {
    out.unknown_share = output.unknown_share;
  }
  if (advice.no_advice != NoAdvice::kNone) {
    return;
  }
  put_roll_period(output.roll_period, out);
  put_ensemble(output, assumed, out);
  out.present_exceeded = num_exceeded(output, advice.heading.radians, advice.speed);
  out.next_criterion = index_or_none(advice.next);
  out.next_margin = static_cast<double>(advice.next_margin);
  out.verdict_now = static_cast<std::int8_t>(advice.verdict_now);
  out.better_in_s = advice.better_in;
  put_expected(output.present, criteria, out);
  put_changes(output, criteria, out);
}

}  // namespace quickstrip
