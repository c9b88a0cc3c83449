#include "msgs/convert/response_message.hpp"

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/limits_message.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kWireQuantities = sizeof(response_t::rms) / sizeof(response_t::rms[0]);
static_assert(kMaxChannels <= kWireQuantities);

bool has_place(Quantity quantity) {
  return is_at_point(quantity) || is_event(quantity);
}

std::int16_t criterion_of(const Criteria& criteria, const QuantityResponse& response) {
  for (std::size_t c = 0; c < criteria.size(); ++c) {
    const bool same_place = !has_place(response.quantity) || criteria[c].place == response.place;
    if (criteria[c].is_watched() && criteria[c].quantity == response.quantity && same_place) {
      return static_cast<std::int16_t>(c);
    }
  }
  return -1;
}

void put_quantity(const QuantityResponse& response, const Hull& hull, const Criteria& criteria, std::size_t i,
                  response_t& out) {
  const RimUnit unit = rim_unit(response.quantity);
  out.quantity[i] = static_cast<std::int8_t>(response.quantity);
  out.place[i] = has_place(response.quantity) ? std::int16_t{response.place} : std::int16_t{-1};
  put_text(place_name(hull, response.quantity, response.place), out.place_name[i]);
  out.unit[i] = static_cast<std::int8_t>(unit);
  out.rms[i] = to_rim(response.rms, unit);
  out.significant[i] = to_rim(response.significant, unit);
  out.tm01_s[i] = response.t1;
  out.tm02_s[i] = response.t2;
  out.probability[i] = to_rim(response.probability, RimUnit::kProbability);
  out.per_hour[i] = to_rim(response.per_hour, RimUnit::kPerHour);
  out.low_encounter_share[i] = response.low_encounter_share;
  double total = 0.0;
  for (const double variance : response.variance) {
    total += variance;
  }
  for (std::size_t s = 0; s < kMaxWaveSystems; ++s) {
    out.system_share[i][s] = total > 0.0 ? static_cast<float>(response.variance[s] / total) : 0.0F;
  }
  out.criterion[i] = criterion_of(criteria, response);
}

// Everything zero but what the caller of to_message owns.
void clear(response_t& out) {
  const std::int64_t utime = out.utime;
  const std::int32_t seq = out.seq;
  const std::int16_t source_id = out.source_id;
  const std::int64_t query_id = out.query_id;
  const std::int16_t query_source_id = out.query_source_id;
  out = response_t{};
  out.utime = utime;
  out.seq = seq;
  out.source_id = source_id;
  out.query_id = query_id;
  out.query_source_id = query_source_id;
}

}  // namespace

Conversion to_query(const query_t& message, Query& out) {
  const Conversion finite =
      all_finite({field("heading_deg", message.heading_deg), field("speed_kn", message.speed_kn)});
  if (!finite) {
    return finite;
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (message.query_id <= 0) {
    return {Refusal::kOutOfRange, "query_id"};
  }
  if (!is_direction(message.heading_deg)) {
    return {Refusal::kDirection, "heading_deg"};
  }
  if (!kSpeedThroughWater_kn.holds(message.speed_kn)) {
    return {Refusal::kOutOfRange, "speed_kn"};
  }
  out = {message.query_id, message.source_id, {radians(message.heading_deg)}, from_knots(message.speed_kn)};
  return {};
}

void to_message(const CellResponse& response, const Hull& hull, const Criteria& criteria,
                std::int64_t limits_digest, response_t& out) {
  clear(out);
  const Cell& cell = response.cell;
  out.limits_digest = limits_digest;
  out.heading_deg = degrees(wrap_two_pi(response.heading.radians));
  out.speed_kn = to_knots(response.speed);
  out.verdict = static_cast<std::int8_t>(cell.verdict);
  out.governing = index_or_none(cell.governing);
  out.governing_system = index_or_none(cell.governing_system);
  const bool knows_margin = cell.verdict != Verdict::kUnknown || cell.governing != kNoCriterion;
  out.margin = knows_margin ? static_cast<double>(cell.margin) : -1.0;
  out.hazards = cell.hazards;
  out.quality = static_cast<std::int32_t>(cell.quality);
  out.num_systems = static_cast<std::int16_t>(response.num_systems);
  out.num_quantities = static_cast<std::int16_t>(response.quantities.size());
  for (std::size_t i = 0; i < response.quantities.size(); ++i) {
    put_quantity(response.quantities[i], hull, criteria, i, out);
  }
}

void to_refusal(const Query& query, Refusal refusal, response_t& out) {
  clear(out);
  out.query_id = query.id;
  out.query_source_id = query.source_id;
  out.refusal = static_cast<std::int16_t>(refusal);
  out.heading_deg = degrees(wrap_two_pi(query.heading.radians));
  out.speed_kn = to_knots(query.speed);
}

}  // namespace quickstrip
