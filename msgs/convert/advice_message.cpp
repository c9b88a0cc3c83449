#include "msgs/convert/advice_message.hpp"

#include <cmath>
#include <cstddef>

#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kSameSpeed = 1.0e-3;    // m/s
constexpr double kSameHeading = 1.0e-3;  // rad
constexpr double kUnknown = -1.0;

double probability(float value) {
  return to_rim(static_cast<double>(value), RimUnit::kProbability);
}

void put_header(const AdviceContext& context, advice_t& out) {
  out.utime = context.utime;
  out.seq = context.seq;
  out.source_id = context.source_id;
  out.valid_until_utime = context.valid_until_utime;
  out.limits_digest = context.limits_digest;
  out.hull_digest = context.hull_digest;
  put_text(context.hull_name, out.hull_name);
  put_text(context.profile_name, out.profile_name);
  for (std::size_t i = 0; i < kNumAdviceInputs; ++i) {
    const UsedInput& input = context.inputs[i];
    const bool is_used = input.use != InputUse::kNone;
    out.input_use[i] = static_cast<std::int8_t>(input.use);
    out.input_source_id[i] = is_used ? input.source_id : std::int16_t{0};
    out.input_seq[i] = is_used ? input.seq : 0;
    out.input_utime[i] = is_used ? input.utime : 0;
  }
  out.sea_assumptions = static_cast<std::int32_t>(context.sea_assumptions);
}

// What "not known" looks like in every field after speed_kind.
void put_nothing(advice_t& out) {
  out.governing = -1;
  out.governing_value = kUnknown;
  out.governing_limit = kUnknown;
  out.margin = kUnknown;
  out.governing_system = -1;
  out.roll_rms_deg = kUnknown;
  out.bridge_vertical_rms_m_s2 = kUnknown;
  out.roll_exceedance = kUnknown;
  out.slam_probability = kUnknown;
  out.slams_per_hour = kUnknown;
  out.wetness_probability = kUnknown;
  for (double& value : out.criterion_value) {
    value = kUnknown;
  }
}

void put_present(const Cell& cell, const Criteria& criteria, advice_t& out) {
  out.verdict = static_cast<std::int8_t>(cell.verdict);
  out.governing = index_or_none(cell.governing);
  out.governing_system = index_or_none(cell.governing_system);
  out.hazards = cell.hazards;
  out.quality = static_cast<std::int32_t>(cell.quality);
  out.roll_rms_deg = to_rim(static_cast<double>(cell.rms_roll), RimUnit::kDegree);
  out.bridge_vertical_rms_m_s2 =
      to_rim(static_cast<double>(cell.rms_bridge_vertical), RimUnit::kMetrePerSecondSquared);
  out.roll_exceedance = probability(cell.roll_exceedance);
  out.slam_probability = probability(cell.slam_probability);
  out.slams_per_hour = to_rim(static_cast<double>(cell.slams_per_hour), RimUnit::kPerHour);
  out.wetness_probability = probability(cell.wetness_probability);
  out.num_criteria = static_cast<std::int16_t>(criteria.size());
  for (std::size_t c = 0; c < criteria.size(); ++c) {
    const RimUnit unit = rim_unit(criteria[c].quantity, criteria[c].statistic);
    out.criterion_value[c] =
        criteria[c].is_watched() ? to_rim(static_cast<double>(cell.values[c]), unit) : kUnknown;
  }
  if (cell.governing < criteria.size()) {
    const Criterion& criterion = criteria[cell.governing];
    put_text(criterion.name.view(), out.governing_name);
    out.governing_value = out.criterion_value[cell.governing];
    out.governing_limit = to_rim(criterion.limit, rim_unit(criterion.quantity, criterion.statistic));
  }
  const bool knows_margin = cell.verdict != Verdict::kUnknown || cell.governing != kNoCriterion;
  out.margin = knows_margin ? static_cast<double>(cell.margin) : kUnknown;
}

void put_change_figures(const Cell* cell, std::size_t i, advice_t& out) {
  const Cell unknown{.rms_roll = kNotComputed};
  const Cell& from = cell != nullptr ? *cell : unknown;
  out.change_hazards[i] = from.hazards;
  out.change_roll_rms_deg[i] = to_rim(static_cast<double>(from.rms_roll), RimUnit::kDegree);
  out.change_bridge_vertical_rms_m_s2[i] =
      to_rim(static_cast<double>(from.rms_bridge_vertical), RimUnit::kMetrePerSecondSquared);
  out.change_roll_exceedance[i] = probability(from.roll_exceedance);
  out.change_slam_probability[i] = probability(from.slam_probability);
  out.change_slams_per_hour[i] = to_rim(static_cast<double>(from.slams_per_hour), RimUnit::kPerHour);
  out.change_wetness_probability[i] = probability(from.wetness_probability);
}

void put_changes(const Advice& advice, const Grid& grid, const Criteria& criteria, WaveSystems systems,
                 advice_t& out) {
  out.change_needed = advice.change_needed ? 1 : 0;
  out.none_is_good = advice.none_is_good ? 1 : 0;
  out.no_change_helps = advice.no_change_helps ? 1 : 0;
  out.num_changes = static_cast<std::int16_t>(advice.changes.size());
  for (std::size_t i = 0; i < advice.changes.size(); ++i) {
    const Change& change = advice.changes[i];
    out.change_to_heading_deg[i] = degrees(wrap_two_pi(change.heading));
    out.change_to_speed_kn[i] = to_knots(change.speed);
    out.change_heading_deg[i] = degrees(change.heading_change);
    out.change_speed_kn[i] = to_knots(change.speed_change);
    out.change_effort[i] = change.effort;
    out.change_verdict[i] = static_cast<std::int8_t>(change.verdict);
    out.change_governing[i] = index_or_none(change.governing);
    out.change_margin[i] = static_cast<double>(change.margin);
    const Cell* cell = cell_at(grid, change.heading, change.speed);
    put_change_figures(cell, i, out);
    out.change_speed_loss_kn[i] =
        change.speed_loss >= 0.0F ? to_knots(static_cast<double>(change.speed_loss)) : kUnknown;
    Sentence text;
    add_change(change, cell, criteria, systems, text);
    put_text(text.view(), out.change_text[i]);
  }
}

}  // namespace

const Cell* cell_at(const Grid& grid, double heading, double speed) {
  if (grid.num_headings == 0 || !std::isfinite(heading)) {
    return nullptr;
  }
  const double step = kTwoPi / static_cast<double>(grid.num_headings);
  const double turned = wrap_two_pi(heading);
  const double nearest = std::round(turned / step);
  if (!(std::abs(turned - nearest * step) <= kSameHeading)) {
    return nullptr;
  }
  const std::size_t h = static_cast<std::size_t>(nearest) % grid.num_headings;
  for (std::size_t s = 0; s < grid.num_speeds; ++s) {
    if (std::abs(grid.speeds[s] - speed) <= kSameSpeed) {
      return &grid.cells[s][h];
    }
  }
  return nullptr;
}

void to_message(const Advice& advice, const Grid& grid, const Criteria& criteria,
                const AdviceContext& context, advice_t& out) {
  out = advice_t{};
  put_header(context, out);
  put_nothing(out);
  out.no_advice = static_cast<std::int16_t>(advice.no_advice);
  out.speed_kind = static_cast<std::int8_t>(context.speed_kind);
  if (context.speed_kind != SpeedKind::kNotKnown) {
    out.heading_deg = degrees(wrap_two_pi(advice.heading.radians));
    out.speed_kn = to_knots(advice.speed);
  }
  Sentence text;
  if (advice.no_advice != NoAdvice::kNone) {
    add_no_advice(advice.no_advice, context.no_advice, text);
    put_text(text.view(), out.no_advice_text);
    return;
  }
  put_present(advice.present, criteria, out);
  put_changes(advice, grid, criteria, context.systems, out);
  add_reasons(advice, criteria, context.systems, text);
  put_text(text.view(), out.reasons_text);
}

}  // namespace quickstrip
