#include "msgs/convert/grid_message.hpp"

#include <cstddef>

#include "msgs/convert/quantise.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr std::int16_t kLargestMargin = 9900;  // "99 or more"
static_assert(kMarginUnbounded == 99.0F);
constexpr std::int16_t kCertain = 20'000;  // probability 1

std::int16_t quantised_margin(const Cell& cell) {
  const bool is_known = cell.verdict != Verdict::kUnknown || cell.governing != kNoCriterion;
  return is_known ? quantised<std::int16_t>(static_cast<double>(cell.margin), kMarginStep, kLargestMargin)
                  : std::int16_t{-1};
}

void put_cell(const Cell& cell, std::size_t s, std::size_t h, grid_t& out) {
  const auto probability = [](float value) {
    return quantised<std::int16_t>(static_cast<double>(value), kProbabilityStep, kCertain);
  };
  out.verdict[s][h] = static_cast<std::int8_t>(cell.verdict);
  out.governing[s][h] = static_cast<std::int8_t>(index_or_none(cell.governing));
  out.governing_system[s][h] = static_cast<std::int8_t>(index_or_none(cell.governing_system));
  out.margin[s][h] = quantised_margin(cell);
  out.hazards[s][h] = static_cast<std::int16_t>(cell.hazards);
  out.quality[s][h] = static_cast<std::int32_t>(cell.quality);
  out.roll_exceedance[s][h] = probability(cell.roll_exceedance);
  out.slam_probability[s][h] = probability(cell.slam_probability);
  out.slams_per_hour[s][h] = quantised<std::int16_t>(static_cast<double>(cell.slams_per_hour), kPerHourStep);
  out.wetness_probability[s][h] = probability(cell.wetness_probability);
  out.roll_rms[s][h] =
      quantised<std::int16_t>(to_rim(static_cast<double>(cell.rms_roll), RimUnit::kDegree), kRollStep_deg);
  out.bridge_vertical_rms[s][h] =
      quantised<std::int16_t>(static_cast<double>(cell.rms_bridge_vertical), kAccelerationStep_m_s2);
  out.speed_loss[s][h] =
      quantised<std::int8_t>(to_knots(static_cast<double>(cell.speed_loss)), kSpeedLossStep_kn);
}

}  // namespace

void to_message(const Grid& grid, std::int64_t limits_digest, grid_t& out) {
  Cell nothing;  // beyond the grid
  nothing.rms_roll = kNotComputed;
  out.limits_digest = limits_digest;
  out.num_speeds = static_cast<std::int16_t>(grid.num_speeds);
  out.num_headings = static_cast<std::int16_t>(grid.num_headings);
  for (std::size_t s = 0; s < kMaxSpeeds; ++s) {
    out.speed_kn[s] = s < grid.num_speeds ? static_cast<float>(to_knots(grid.speeds[s])) : 0.0F;
    for (std::size_t h = 0; h < kMaxHeadings; ++h) {
      const bool is_swept = s < grid.num_speeds && h < grid.num_headings;
      put_cell(is_swept ? grid.cells[s][h] : nothing, s, h, out);
    }
  }
}

}  // namespace quickstrip
