#include "core/advice/grid.hpp"

#include <algorithm>

#include "core/advice/quality.hpp"
#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr double kTailWorthSaying = 0.01;  // of m0

Needs needs_of(const GridInputs& inputs) {
  Needs needs{};
  for (std::size_t c = 0; c < inputs.watch.channels.size(); ++c) {
    if (inputs.channels.is_needed[c]) {
      needs[c] = inputs.channels.is_watched[c] ? Need::kVarianceAndLowEncounter : Need::kVariance;
    }
  }
  return needs;
}

ResponseMoments moments_at(const ChannelMoments& all, std::size_t h, std::size_t num_systems) {
  ResponseMoments out{.m0 = all.m0[h], .m2 = all.m2[h], .m0_low_encounter = all.m0_low_encounter[h]};
  for (std::size_t s = 0; s < num_systems; ++s) {
    out.m0_by_system[s] = all.m0_by_system[s][h];
  }
  return out;
}

/// Of a member of an ensemble: what limits are on, and nothing that only tells why or is only shown.
Needs needs_of_member(const GridInputs& inputs) {
  Needs needs{};
  for (std::size_t c = 0; c < inputs.watch.channels.size(); ++c) {
    needs[c] = inputs.channels.is_watched[c] ? Need::kVariance : Need::kNone;
  }
  return needs;
}

/// Verdict on the motions of one cell; h: its heading as a direction index.
Cell judge_motions(const GridInputs& inputs, std::size_t h, double speed, GridWorkspace& workspace) {
  const auto moments = std::span(workspace.cell).first(inputs.watch.channels.size());
  for (std::size_t c = 0; c < moments.size(); ++c) {
    if (workspace.needs[c] != Need::kNone) {
      moments[c] = moments_at(workspace.moments.channel[c], h, inputs.sea.num_systems);
    }
  }
  const Heading heading{kTwoPi * static_cast<double>(h) / static_cast<double>(kNumDirections)};
  const double m0 = inputs.sea.hs * inputs.sea.hs / 16.0;
  const double share = workspace.moments.slow_wave_energy[h] / m0;
  const HeadingDamping& roll = workspace.moments.roll_damping;
  const RollDampingInUse damping{.added = roll.added[h], .residual = roll.residual[h]};
  Cell cell = judge(inputs.criteria, inputs.channels, inputs.watch, moments,
                    circumstances(inputs, heading, speed, share, damping));
  if (cell.governing != kNoCriterion) {
    const std::size_t channel = inputs.channels.of_criterion[cell.governing];
    cell.governing_system = largest_system(moments_of(inputs.criteria[cell.governing], channel, moments));
  }
  return cell;
}

Cell judge_cell(const GridInputs& inputs, std::size_t h, double speed, GridWorkspace& workspace) {
  Cell cell = judge_motions(inputs, h, speed, workspace);
  const HeadingResistance& resistance = workspace.resistance;
  cell.added_resistance = static_cast<float>(resistance.strip[h]);
  if (resistance.has_empirical) {
    cell.added_resistance_empirical = static_cast<float>(resistance.empirical[h]);
  }
  return cell;
}

/// Moments on every heading, speed by speed; visit(v) after each.
template <typename Visit>
void for_each_speed(const GridInputs& inputs, const Needs& needs, bool counts_slow_waves,
                    GridWorkspace& workspace, const Visit& visit) {
  workspace.needs = needs;
  workspace.cell.fill(ResponseMoments{});
  const SweepOptions options{counts_slow_waves, inputs.is_stabilised, inputs.roll_shift};
  for (std::size_t v = 0; v < inputs.transfer.num_speeds; ++v) {
    list_heading_moments(inputs.transfer, v, inputs.watch, inputs.waves, workspace.needs, inputs.sea, options,
                         workspace.sweep, workspace.moments);
    visit(v);
  }
}

bool is_empty(const SeaEnergy& sea) {
  const auto takes_nothing = [](const SystemEnergy& part) { return part.count == 0; };
  return std::all_of(sea.part.begin(), sea.part.begin() + static_cast<std::ptrdiff_t>(sea.num_systems),
                     takes_nothing);
}

Status check_inputs(const GridInputs& inputs) {
  if (inputs.num_headings == 0 || kNumDirections % inputs.num_headings != 0 ||
      inputs.transfer.num_speeds == 0) {
    return Error::kOutOfRange;
  }
  if (inputs.sea.num_frequencies != inputs.transfer.num_frequencies) {
    return Error::kTooMany;
  }
  return is_empty(inputs.sea) ? Status(Error::kEmptySpectrum) : Status();
}

}  // namespace

CellCircumstances circumstances(const GridInputs& inputs, Heading heading, double speed,
                                double low_encounter_share, const RollDampingInUse& damping) {
  const double critical = inputs.transfer.critical_roll_damping;
  CellCircumstances known{.speed = speed,
                          .quality = inputs.quality,
                          .low_encounter_share = low_encounter_share,
                          .roll_damping_ratio = critical > 0.0 ? damping.added / critical : 0.0,
                          .roll_damping_residual = damping.residual};
  // Written so that a residual that is no number counts too.
  if (!(damping.residual < kRollResidualLimit)) {
    known.quality |= kQualityRollNotConverged;
  }
  known.quality |= speed_quality(speed, inputs.lpp, inputs.watch.gravity);
  if (!inputs.watch.swell_up.is_in_range(speed)) {
    known.quality |= kQualitySwellUpRange;
  }
  if (inputs.sea.lost_tail > kTailWorthSaying) {
    known.quality |= kQualityTailLost;
  }
  if (speed < inputs.min_steerage_speed) {
    known.hazards |= kHazardNoSteerage;
  }
  if (inputs.zone_ship != nullptr && inputs.zones != nullptr) {
    known.hazards |= zone_bits(*inputs.zone_ship, *inputs.zones, heading, speed);
  }
  return known;
}

double unknown_share(const Grid& grid) {
  std::size_t num_cells = 0;
  std::size_t num_unknown = 0;
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < grid.num_headings; ++h) {
      const Cell& cell = grid.cells[v][h];
      const bool counts = (cell.hazards & kHazardNoSteerage) == 0;
      num_cells += counts ? 1 : 0;
      num_unknown += counts && cell.verdict == Verdict::kUnknown ? 1 : 0;
    }
  }
  return num_cells > 0 ? static_cast<double>(num_unknown) / static_cast<double>(num_cells) : -1.0;
}

Status sweep_grid(const GridInputs& inputs, GridWorkspace& workspace, Grid& out) {
  if (const Status status = check_inputs(inputs); !status) {
    return status;
  }
  out.num_speeds = inputs.transfer.num_speeds;
  out.num_headings = inputs.num_headings;
  out.speeds = inputs.transfer.speeds;
  const std::size_t directions_per_heading = kNumDirections / inputs.num_headings;
  for_each_speed(inputs, needs_of(inputs), true, workspace, [&](std::size_t v) {
    list_mean_added_resistance(inputs.transfer, v, inputs.sea, workspace.sweep, workspace.resistance);
    for (std::size_t h = 0; h < out.num_headings; ++h) {
      out.cells[v][h] = judge_cell(inputs, h * directions_per_heading, out.speeds[v], workspace);
    }
  });
  return {};
}

Status sweep_member(const GridInputs& inputs, std::size_t member, GridWorkspace& workspace,
                    ExceededMembers& out) {
  QS_CHECK(member < kEnsembleMembers);
  if (const Status status = check_inputs(inputs); !status) {
    return status;
  }
  const auto bit = static_cast<std::uint16_t>(1U << member);
  const std::size_t directions_per_heading = kNumDirections / inputs.num_headings;
  for_each_speed(inputs, needs_of_member(inputs), false, workspace, [&](std::size_t v) {
    const double speed = inputs.transfer.speeds[v];
    for (std::size_t h = 0; h < inputs.num_headings; ++h) {
      const Cell cell = judge_motions(inputs, h * directions_per_heading, speed, workspace);
      const bool is_exceeded = cell.governing != kNoCriterion && cell.margin < 1.0F;
      const auto others = static_cast<std::uint16_t>(out[v][h] & ~bit);
      out[v][h] = is_exceeded ? static_cast<std::uint16_t>(others | bit) : others;
    }
  });
  return {};
}

}  // namespace quickstrip
