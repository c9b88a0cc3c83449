#include "msgs/convert/ship_message.hpp"

#include <cmath>

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr Range kRateOfTurn_deg_min{-720.0, 720.0};
constexpr Range kDepth_m{0.0, 12'000.0};
constexpr double kSecondsPerMinute = 60.0;
constexpr std::int32_t kOwnShipBits = 255;   // VALID_HEADING ... VALID_WIND
constexpr std::int32_t kLoadingBits = 2047;  // VALID_DRAUGHTS ... VALID_LCG
static_assert(own_ship_t::VALID_WIND * 2 - 1 == kOwnShipBits && loading_t::VALID_LCG * 2 - 1 == kLoadingBits);

struct RangeCheck {
  std::int32_t bit;
  const char* name;
  double value;
  Range range;
};

template <typename Checks>
Conversion check_ranges(std::int32_t valid, const Checks& checks) {
  for (const RangeCheck& check : checks) {
    if (has(valid, check.bit) && !check.range.holds(check.value)) {
      return {Refusal::kOutOfRange, check.name};
    }
  }
  return {};
}

Conversion check_own_ship(const own_ship_t& m) {
  const Conversion finite = all_finite(
      {field("heading_deg", m.heading_deg), field("speed_through_water_kn", m.speed_through_water_kn),
       field("speed_over_ground_kn", m.speed_over_ground_kn),
       field("course_over_ground_deg", m.course_over_ground_deg),
       field("rate_of_turn_deg_min", m.rate_of_turn_deg_min), field("lat_deg", m.lat_deg),
       field("lon_deg", m.lon_deg), field("depth_m", m.depth_m), field("wind_speed_kn", m.wind_speed_kn),
       field("wind_from_deg", m.wind_from_deg)});
  if (!finite) {
    return finite;
  }
  if (!is_time(m.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (const Conversion known = only_known_bits(m.valid, kOwnShipBits); !known) {
    return known;
  }
  if (m.stabiliser < own_ship_t::STABILISER_NOT_KNOWN || m.stabiliser > own_ship_t::STABILISER_ON) {
    return {Refusal::kUnknownKind, "stabiliser"};
  }
  if (!has(m.valid, own_ship_t::VALID_HEADING)) {
    return {Refusal::kFieldMissing, "heading_deg"};
  }
  if (!has(m.valid, own_ship_t::VALID_SPEED_THROUGH_WATER) &&
      !has(m.valid, own_ship_t::VALID_SPEED_OVER_GROUND)) {
    return {Refusal::kFieldMissing, "speed_through_water_kn"};
  }
  if (!is_direction(m.heading_deg)) {
    return {Refusal::kDirection, "heading_deg"};
  }
  if (has(m.valid, own_ship_t::VALID_COURSE) && !is_direction(m.course_over_ground_deg)) {
    return {Refusal::kDirection, "course_over_ground_deg"};
  }
  if (has(m.valid, own_ship_t::VALID_WIND) && !is_direction(m.wind_from_deg)) {
    return {Refusal::kDirection, "wind_from_deg"};
  }
  using M = own_ship_t;
  const RangeCheck checks[] = {
      {M::VALID_SPEED_THROUGH_WATER, "speed_through_water_kn", m.speed_through_water_kn,
       kSpeedThroughWater_kn},
      {M::VALID_SPEED_OVER_GROUND, "speed_over_ground_kn", m.speed_over_ground_kn, kSpeedOverGround_kn},
      {M::VALID_RATE_OF_TURN, "rate_of_turn_deg_min", m.rate_of_turn_deg_min, kRateOfTurn_deg_min},
      {M::VALID_POSITION, "lat_deg", m.lat_deg, {-90.0, 90.0}},
      {M::VALID_POSITION, "lon_deg", m.lon_deg, {-180.0, 360.0}},
      {M::VALID_DEPTH, "depth_m", m.depth_m, kDepth_m},
      {M::VALID_WIND, "wind_speed_kn", m.wind_speed_kn, {0.0, 200.0}},
  };
  return check_ranges(m.valid, checks);
}

Conversion check_loading(const loading_t& m, const Hull& hull) {
  const Conversion finite =
      all_finite({field("draught_aft_m", m.draught_aft_m), field("draught_fwd_m", m.draught_fwd_m),
                  field("kg_m", m.kg_m), field("free_surface_correction_m", m.free_surface_correction_m),
                  field("gm_m", m.gm_m), field("roll_gyradius_m", m.roll_gyradius_m),
                  field("pitch_gyradius_m", m.pitch_gyradius_m), field("yaw_gyradius_m", m.yaw_gyradius_m),
                  field("measured_roll_period_s", m.measured_roll_period_s),
                  field("water_density_kg_m3", m.water_density_kg_m3),
                  field("displacement_t", m.displacement_t), field("lcg_m", m.lcg_m)});
  if (!finite) {
    return finite;
  }
  if (!is_time(m.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (const Conversion known = only_known_bits(m.valid, kLoadingBits); !known) {
    return known;
  }
  if (m.source_kind < loading_t::SOURCE_NOT_KNOWN || m.source_kind > loading_t::SOURCE_MANUAL) {
    return {Refusal::kUnknownKind, "source_kind"};
  }
  if (m.valid == 0) {
    return {Refusal::kFieldMissing, "valid"};
  }
  using M = loading_t;
  const RangeCheck checks[] = {
      {M::VALID_DRAUGHTS, "draught_aft_m", m.draught_aft_m, draught_range_m(hull)},
      {M::VALID_DRAUGHTS, "draught_fwd_m", m.draught_fwd_m, draught_range_m(hull)},
      {M::VALID_KG, "kg_m", m.kg_m, kg_range_m(hull)},
      {M::VALID_FREE_SURFACE, "free_surface_correction_m", m.free_surface_correction_m,
       free_surface_range_m(hull)},
      {M::VALID_GM, "gm_m", m.gm_m, gm_range_m(hull)},
      {M::VALID_ROLL_GYRADIUS, "roll_gyradius_m", m.roll_gyradius_m, roll_gyradius_range_m(hull)},
      {M::VALID_PITCH_GYRADIUS, "pitch_gyradius_m", m.pitch_gyradius_m, long_gyradius_range_m(hull)},
      {M::VALID_YAW_GYRADIUS, "yaw_gyradius_m", m.yaw_gyradius_m, long_gyradius_range_m(hull)},
      {M::VALID_ROLL_PERIOD, "measured_roll_period_s", m.measured_roll_period_s, kRollPeriod_s},
      {M::VALID_WATER_DENSITY, "water_density_kg_m3", m.water_density_kg_m3, kWaterDensity_kg_m3},
      {M::VALID_DISPLACEMENT, "displacement_t", m.displacement_t, {1.0e-6, 1.0e6}},
      {M::VALID_LCG, "lcg_m", m.lcg_m, {0.0, hull.lpp}},
  };
  return check_ranges(m.valid, checks);
}

// A draught above the highest offset or above the breadth, or one far from the other, is a slip of the hand.
Conversion check_draughts(const loading_t& m, const Hull& hull) {
  const double deck = highest_deck(hull);
  const double greatest = std::fmax(m.draught_aft_m, m.draught_fwd_m);
  const bool fits = (deck < 0.0 || greatest < deck) && greatest < hull.breadth &&
                    is_trim(m.draught_aft_m, m.draught_fwd_m, hull);
  if (has(m.valid, loading_t::VALID_DRAUGHTS) && !fits) {
    return {Refusal::kInconsistent, m.draught_aft_m > m.draught_fwd_m ? "draught_aft_m" : "draught_fwd_m"};
  }
  return {};
}

}  // namespace

Conversion to_own_ship(const own_ship_t& message, OwnShipReading& out) {
  if (const Conversion checked = check_own_ship(message); !checked) {
    return checked;
  }
  OwnShipReading reading;
  const bool through_water = has(message.valid, own_ship_t::VALID_SPEED_THROUGH_WATER);
  reading.ship.heading = {radians(message.heading_deg)};
  reading.ship.speed =
      from_knots(through_water ? message.speed_through_water_kn : message.speed_over_ground_kn);
  reading.ship.speed_over_ground = !through_water;
  reading.ship.is_stabilised = message.stabiliser == own_ship_t::STABILISER_ON;
  if (has(message.valid, own_ship_t::VALID_COURSE)) {
    reading.course = radians(message.course_over_ground_deg);
  }
  if (has(message.valid, own_ship_t::VALID_RATE_OF_TURN)) {
    reading.rate_of_turn = radians(message.rate_of_turn_deg_min) / kSecondsPerMinute;
  }
  if (has(message.valid, own_ship_t::VALID_DEPTH)) {
    reading.ship.water_depth = message.depth_m;
  }
  out = reading;
  return {};
}

Conversion to_loading(const loading_t& message, const Hull& hull, Loading& out) {
  if (const Conversion checked = check_loading(message, hull); !checked) {
    return checked;
  }
  if (const Conversion draughts = check_draughts(message, hull); !draughts) {
    return draughts;
  }
  using M = loading_t;
  const auto given = [&message](std::int32_t bit) { return has(message.valid, bit); };
  Loading loading = hull.loading;
  if (given(M::VALID_DRAUGHTS) || given(M::VALID_KG)) {  // another condition than the default one
    loading.gm.reset();
    loading.measured_roll_period.reset();
  }
  if (given(M::VALID_KG)) {
    loading.free_surface_correction.reset();
  }
  loading.draught_aft = given(M::VALID_DRAUGHTS) ? message.draught_aft_m : loading.draught_aft;
  loading.draught_fwd = given(M::VALID_DRAUGHTS) ? message.draught_fwd_m : loading.draught_fwd;
  loading.kg = given(M::VALID_KG) ? message.kg_m : loading.kg;
  if (given(M::VALID_FREE_SURFACE)) {
    loading.free_surface_correction = message.free_surface_correction_m;
  }
  if (given(M::VALID_GM)) {
    loading.gm = message.gm_m;
  }
  loading.roll_gyradius = given(M::VALID_ROLL_GYRADIUS) ? message.roll_gyradius_m : loading.roll_gyradius;
  loading.pitch_gyradius = given(M::VALID_PITCH_GYRADIUS) ? message.pitch_gyradius_m : loading.pitch_gyradius;
  loading.yaw_gyradius = given(M::VALID_YAW_GYRADIUS) ? message.yaw_gyradius_m : loading.yaw_gyradius;
  if (given(M::VALID_ROLL_PERIOD)) {
    loading.measured_roll_period = message.measured_roll_period_s;
  }
  loading.water_density = given(M::VALID_WATER_DENSITY) ? message.water_density_kg_m3 : loading.water_density;
  out = loading;
  return {};
}

void to_message(const Loading& loading, loading_t& out) {
  using M = loading_t;
  out.valid = bits({M::VALID_DRAUGHTS, M::VALID_KG, M::VALID_ROLL_GYRADIUS, M::VALID_PITCH_GYRADIUS,
                    M::VALID_YAW_GYRADIUS, M::VALID_WATER_DENSITY});
  out.draught_aft_m = loading.draught_aft;
  out.draught_fwd_m = loading.draught_fwd;
  out.kg_m = loading.kg;
  out.roll_gyradius_m = loading.roll_gyradius;
  out.pitch_gyradius_m = loading.pitch_gyradius;
  out.yaw_gyradius_m = loading.yaw_gyradius;
  out.water_density_kg_m3 = loading.water_density;
  out.valid |= loading.free_surface_correction ? std::int32_t{M::VALID_FREE_SURFACE} : 0;
  out.valid |= loading.gm ? std::int32_t{M::VALID_GM} : 0;
  out.valid |= loading.measured_roll_period ? std::int32_t{M::VALID_ROLL_PERIOD} : 0;
  out.free_surface_correction_m = loading.free_surface_correction.value_or(0.0);
  out.gm_m = loading.gm.value_or(0.0);
  out.measured_roll_period_s = loading.measured_roll_period.value_or(0.0);
}

}  // namespace quickstrip
