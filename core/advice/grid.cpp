#include "core/advice/grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr double kHighFroude = 0.35;       // [Journee1992] §6
constexpr double kTailWorthSaying = 0.01;  // of m0

using ByFrequency = GridWorkspace::ByFrequency;
using ByDirection = GridWorkspace::ByDirection;

bool has_velocity_row(const Channel& channel) {
  return channel.quantity == Quantity::kSlamming || channel.quantity == Quantity::kDeckWetness;
}

void list_rows(const GridInputs& inputs, GridWorkspace& workspace) {
  workspace.rows.clear();
  std::size_t num_peak_rows = 0;
  for (std::size_t c = 0; c < inputs.watch.channels.size(); ++c) {
    if (!inputs.channels.is_needed[c]) {
      continue;
    }
    EnergyRow row{.channel = c};
    if (feels_roll(inputs.watch.channels[c])) {
      row.peak = num_peak_rows++;
    }
    QS_CHECK(num_peak_rows <= kMaxPeakRows && workspace.rows.push_back(row));
    if (has_velocity_row(inputs.watch.channels[c])) {
      QS_CHECK(workspace.rows.push_back({.channel = c, .is_velocity = true}));
    }
  }
}

void list_directions(const SeaEnergy& sea, GridWorkspace& workspace) {
  workspace.directions.clear();
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    const auto end = sea.total[d].begin() + static_cast<std::ptrdiff_t>(sea.num_frequencies);
    if (std::any_of(sea.total[d].begin(), end, [](double energy) { return energy != 0.0; })) {
      QS_CHECK(workspace.directions.push_back(d));
    }
  }
}

/// What the roll peak adds to the rows that feel it, at one relative direction.
void fill_peak(const GridInputs& inputs, std::size_t speed, std::size_t m, GridWorkspace& workspace) {
  const RollPeak& peak = inputs.transfer.peak[speed][solved_direction(m)];
  workspace.peak_of[m] = &peak;
  const std::size_t n = peak.num_points;
  auto points = peak.solved;
  std::array<double, kMaxPeakPoints> wave_numbers{};
  for (std::size_t p = 0; p < n; ++p) {
    wave_numbers[p] = wave_number(peak.omega[p], inputs.watch.gravity);
    if (is_mirrored(m)) {
      points[p] = mirrored(points[p]);
    }
  }
  const std::size_t num_frequencies = inputs.transfer.num_frequencies;
  std::array<double, kMaxPeakPoints> energies{};
  for (std::size_t r = 0; r < workspace.rows.size() && n > 0; ++r) {
    const EnergyRow& row = workspace.rows[r];
    if (row.peak == kNoPeak) {
      continue;
    }
    channel_energies(inputs.watch.channels[row.channel], std::span(points).first(n),
                     std::span(wave_numbers).first(n), relative_direction(m), inputs.watch.gravity,
                     std::span(energies).first(n));
    workspace.peak[row.peak][m] =
        peak_terms(peak, std::span(inputs.transfer.omega).first(num_frequencies),
                   std::span(workspace.energy[r][m]).first(num_frequencies), std::span(energies).first(n));
  }
}

/// Energies of every row at one relative direction.
void fill_direction(const GridInputs& inputs, std::size_t speed, std::size_t m, GridWorkspace& workspace) {
  const std::size_t n = inputs.transfer.num_frequencies;
  auto transfers = inputs.transfer.solved[speed][solved_direction(m)];
  if (is_mirrored(m)) {
    for (std::size_t f = 0; f < n; ++f) {
      transfers[f] = mirrored(transfers[f]);
    }
  }
  workspace.has_low_encounter[m] = false;
  for (std::size_t f = 0; f < n; ++f) {
    workspace.low_encounter[m][f] = transfers[f].low_encounter ? 1.0 : 0.0;
    workspace.has_low_encounter[m] = workspace.has_low_encounter[m] || transfers[f].low_encounter;
  }
  for (std::size_t r = 0; r < workspace.rows.size(); ++r) {
    ByFrequency& row = workspace.energy[r][m];
    if (workspace.rows[r].is_velocity) {
      const ByFrequency& displacement = workspace.energy[r - 1][m];  // listed just before
      for (std::size_t f = 0; f < n; ++f) {
        row[f] = displacement[f] * transfers[f].encounter_frequency * transfers[f].encounter_frequency;
      }
    } else {
      channel_energies(inputs.watch.channels[workspace.rows[r].channel], std::span(transfers).first(n),
                       std::span(inputs.transfer.wave_number).first(n), relative_direction(m),
                       inputs.watch.gravity, std::span(row).first(n));
    }
    std::fill(row.begin() + static_cast<std::ptrdiff_t>(n), row.end(), 0.0);
  }
  fill_peak(inputs, speed, m, workspace);
}

/// Sum of products in eight partial sums, so that the compiler may use vectors without reordering anything.
constexpr std::size_t kLanes = 8;
static_assert(kMaxFrequencies % kLanes == 0);
using Lanes = std::array<double, kLanes>;

void add_products(const ByFrequency& a, const ByFrequency& b, Lanes& lanes) {
  for (std::size_t f = 0; f < kMaxFrequencies; f += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) {
      lanes[j] += a[f + j] * b[f + j];
    }
  }
}

double sum(const Lanes& lanes) {
  return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

/// The relative direction at which waves from compass direction d meet a ship heading for direction h.
std::size_t relative_index(std::size_t h, std::size_t d) {
  return wave_direction(h, d);  // from = heading + pi - mu is its own inverse
}

double variance(const GridWorkspace& workspace, std::size_t row, std::size_t h, const ByDirection& sea,
                const SeaEnergy::Densities& densities) {
  Lanes lanes{};
  for (const std::size_t d : workspace.directions) {
    add_products(workspace.energy[row][relative_index(h, d)], sea[d], lanes);
  }
  const std::size_t peak_row = workspace.rows[row].peak;
  if (peak_row == kNoPeak) {
    return sum(lanes);
  }
  double peak = 0.0;
  for (const std::size_t d : workspace.directions) {
    const std::size_t m = relative_index(h, d);
    peak += peak_variance(*workspace.peak_of[m], workspace.peak[peak_row][m], densities[d]);
  }
  const double whole = sum(lanes) + peak;
  return whole < 0.0 ? 0.0 : whole;  // the cubic of a density may undershoot; a NaN stays one
}

double low_encounter_variance(const GridWorkspace& workspace, std::size_t row, std::size_t h,
                              const ByDirection& sea) {
  Lanes lanes{};
  for (const std::size_t d : workspace.directions) {
    const std::size_t m = relative_index(h, d);
    if (!workspace.has_low_encounter[m]) {
      continue;
    }
    ByFrequency low{};
    for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
      low[f] = workspace.low_encounter[m][f] * sea[d][f];
    }
    add_products(workspace.energy[row][m], low, lanes);
  }
  return sum(lanes);
}

std::size_t row_of(const GridWorkspace& workspace, std::size_t channel) {
  std::size_t r = 0;
  while (workspace.rows[r].channel != channel) {  // a governing channel is needed, hence listed
    ++r;
  }
  return r;
}

std::uint8_t governing_system(const GridInputs& inputs, const GridWorkspace& workspace, std::size_t channel,
                              std::size_t h) {
  const std::size_t row = row_of(workspace, channel);
  std::uint8_t governing = kNoSystem;
  double largest = 0.0;
  for (std::size_t s = 0; s < inputs.sea.num_systems; ++s) {
    const double part = variance(workspace, row, h, inputs.sea.energy[s], inputs.sea.density[s]);
    if (part > largest) {
      largest = part;
      governing = static_cast<std::uint8_t>(s);
    }
  }
  return governing;
}

/// One cell; h: its heading as a direction index.
Cell sweep_cell(const GridInputs& inputs, const GridWorkspace& workspace, std::size_t h,
                const CellCircumstances& known) {
  std::array<ResponseMoments, kMaxChannels> moments{};
  for (std::size_t r = 0; r < workspace.rows.size(); ++r) {
    const EnergyRow& row = workspace.rows[r];
    const double value = variance(workspace, r, h, inputs.sea.total, inputs.sea.total_density);
    (row.is_velocity ? moments[row.channel].m2 : moments[row.channel].m0) = value;
    if (!row.is_velocity && inputs.channels.is_watched[row.channel]) {
      moments[row.channel].m0_low_encounter = low_encounter_variance(workspace, r, h, inputs.sea.total);
    }
  }
  Cell cell = judge(inputs.criteria, inputs.channels, inputs.watch,
                    std::span(moments).first(inputs.watch.channels.size()), known);
  if (cell.governing != kNoCriterion) {
    cell.governing_system =
        governing_system(inputs, workspace, inputs.channels.of_criterion[cell.governing], h);
  }
  return cell;
}

Status check_inputs(const GridInputs& inputs, const GridWorkspace& workspace) {
  if (inputs.num_headings == 0 || kNumDirections % inputs.num_headings != 0 ||
      inputs.transfer.num_speeds == 0) {
    return Error::kOutOfRange;
  }
  if (inputs.sea.num_frequencies != inputs.transfer.num_frequencies) {
    return Error::kTooMany;
  }
  return workspace.directions.empty() ? Status(Error::kEmptySpectrum) : Status();
}

}  // namespace

CellCircumstances circumstances(const GridInputs& inputs, Heading heading, double speed) {
  CellCircumstances known{.quality = inputs.quality};
  if (speed > kHighFroude * std::sqrt(inputs.watch.gravity * inputs.lpp)) {
    known.quality |= kQualityHighFroude;
  }
  if (inputs.sea.lost_tail > kTailWorthSaying) {
    known.quality |= kQualityTailLost;
  }
  if (speed < inputs.min_steerage_speed) {
    known.hazards |= kHazardNoSteerage;
  }
  if (inputs.suppresses_low_encounter) {
    const Result<double> share = low_encounter_wave_share(inputs.transfer, inputs.sea, heading, speed);
    known.low_encounter_share = share ? *share : 1.0;
  }
  return known;
}

Status sweep_grid(const GridInputs& inputs, GridWorkspace& workspace, Grid& out) {
  list_rows(inputs, workspace);
  list_directions(inputs.sea, workspace);
  if (const Status status = check_inputs(inputs, workspace); !status) {
    return status;
  }
  out.num_speeds = inputs.transfer.num_speeds;
  out.num_headings = inputs.num_headings;
  out.speeds = inputs.transfer.speeds;
  const std::size_t directions_per_heading = kNumDirections / inputs.num_headings;
  for (std::size_t v = 0; v < out.num_speeds; ++v) {
    for (std::size_t m = 0; m < kNumDirections; ++m) {
      fill_direction(inputs, v, m, workspace);
    }
    for (std::size_t h = 0; h < out.num_headings; ++h) {
      const Heading heading{kTwoPi * static_cast<double>(h) / static_cast<double>(out.num_headings)};
      out.cells[v][h] = sweep_cell(inputs, workspace, h * directions_per_heading,
                                   circumstances(inputs, heading, out.speeds[v]));
    }
  }
  return {};
}

}  // namespace quickstrip
