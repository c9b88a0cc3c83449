#include "core/advisor.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/advice/quality.hpp"
#include "core/advice/speed_loss.hpp"
#include "core/hull/physical_range.hpp"

namespace quickstrip {
namespace {

/// The memory asked for; afresh if the other one was alive.
template <typename Wanted, typename Memory>
Wanted& alive(Memory& memory) {
  Wanted* const there = std::get_if<Wanted>(&memory);
  return there != nullptr ? *there : memory.template emplace<Wanted>();
}

bool is_from_astern(const SeaEnergy& sea, std::uint8_t system, Heading heading) {
  return system < sea.num_systems &&
         std::cos(encounter_angle(heading, sea.system[system].from).radians) > 0.0;
}

Result<std::size_t> count_headings(const GridDefinition& grid) {
  if (!(grid.heading_step > 0.0) || !(grid.heading_step <= kTwoPi)) {
    return Error::kOutOfRange;
  }
  const double count = kTwoPi / grid.heading_step;
  const auto rounded = static_cast<std::size_t>(std::lround(count));
  const bool divides = rounded <= kNumDirections && kNumDirections % rounded == 0;
  constexpr double kRounding = 1e-6;  // degrees converted to radians
  if (!divides || std::abs(count - static_cast<double>(rounded)) > kRounding) {
    return Error::kOutOfRange;
  }
  return rounded;
}

struct SpeedList {
  std::size_t count = 0;
  std::array<double, kMaxSpeeds> speeds{};
};

Result<SpeedList> list_speeds(const GridDefinition& grid) {
  if (!(grid.speed_from >= 0.0) || !(grid.speed_to >= grid.speed_from) || !std::isfinite(grid.speed_to)) {
    return Error::kOutOfRange;
  }
  constexpr double kRounding = 1e-6;  // of a step: knots converted to m/s
  const double range = grid.speed_to - grid.speed_from;
  if (range > 0.0 && !(grid.speed_step > 0.0 && std::isfinite(grid.speed_step))) {
    return Error::kOutOfRange;
  }
  const double steps = range > 0.0 ? std::floor(range / grid.speed_step + kRounding) : 0.0;
  if (!(steps < static_cast<double>(kMaxSpeeds))) {
    return Error::kTooMany;
  }
  SpeedList list{.count = static_cast<std::size_t>(steps) + 1};
  for (std::size_t v = 0; v < list.count; ++v) {
    list.speeds[v] = grid.speed_from + grid.speed_step * static_cast<double>(v);
  }
  return list;
}

}  // namespace

Status Advisor::configure(const Hull& hull, const Criteria& criteria, const StripMethod& method,
                          const SteadinessOptions& steadiness, const HullTable* table) {
  state_ = State::kNotConfigured;
  steadiness_.configure(steadiness);
  has_sea_ = false;
  hull_ = &hull;
  criteria_ = criteria;
  method_ = method;
  table_ = table;
  loading_ = hull.loading;
  if (const Status status = check_criteria(criteria_, *hull_); !status) {
    return status;
  }
  const Result<std::size_t> headings = count_headings(hull_->grid);
  if (!headings) {
    return headings.error();
  }
  num_headings_ = *headings;
  if (const Status status = build(loading_); !status) {
    return status;
  }
  state_ = State::kReady;
  return {};
}

Status Advisor::build(const Loading& loading) {
  if (const Status status = check_physical_range(*hull_); !status) {
    return status;
  }
  if (const Status status = check_physical_range(loading, hull_->lpp); !status) {
    return status;
  }
  BuildMemory& memory = alive<BuildMemory>(memory_);
  if (const Status status = load(*hull_, loading, method_, memory.loaded, table_); !status) {
    return status;
  }
  loaded_ = summary_of(memory.loaded);
  hull_quality_ = quickstrip::hull_quality(memory.loaded, loading);
  if (const Status status = list_channels(*hull_, loading, loaded_.hydrostatics, method_.swell_up, watch_);
      !status) {
    return status;
  }
  if (const Status status = list_people_channels(criteria_, watch_); !status) {
    return status;
  }
  channels_ = bind_criteria(criteria_, watch_);
  if (const Status status = solve_speeds(memory); !status) {
    return status;
  }
  // Here and not in the first cycle, that every cycle takes the same time.
  list_incident_waves(transfer_, watch_, memory_.emplace<CycleMemory>().waves);
  return {};
}

Status Advisor::solve_speeds(BuildMemory& memory) {
  const Result<SpeedList> list = list_speeds(hull_->grid);
  if (!list) {
    return list.error();
  }
  const auto speeds = std::span(list->speeds).first(list->count);
  list_zone_ship(*hull_, loading_, memory.loaded, speeds, zone_ship_);
  return solve_transfer_functions(memory.loaded, speeds, memory.work, transfer_);
}

Status Advisor::rebuild() {
  if (state_ == State::kNotConfigured) {
    return Error::kNotConfigured;
  }
  if (state_ != State::kRebuildDue) {
    return {};
  }
  has_sea_ = false;  // it was placed on the frequencies of the former loading
  steadiness_.forget();
  const Status status = build(loading_);
  state_ = status ? State::kReady : State::kLoadingRefused;
  return status;
}

const StepOutput& Advisor::step(const StepInputs& inputs) {
  CycleMemory& cycle = alive<CycleMemory>(memory_);
  const NoAdvice reason = take_inputs(inputs, cycle.sea);
  if (reason != NoAdvice::kNone) {
    withhold(reason, cycle.output);
    return cycle.output;
  }
  if (const NoAdvice refused = advise(inputs, cycle); refused != NoAdvice::kNone) {
    withhold(refused, cycle.output);
    return cycle.output;
  }
  if constexpr (kEnsembleMembers > 0) {
    sweep_ensemble(inputs, cycle);
  }
  return cycle.output;
}

NoAdvice Advisor::take_inputs(const StepInputs& inputs, SeaEnergy& sea) {
  has_sea_ = false;
  if (state_ == State::kNotConfigured) {
    return NoAdvice::kNotConfigured;
  }
  // A new loading is taken up even while another input is missing: the hull is ready when that comes back.
  const NoAdvice loading = take_loading(inputs);
  if (inputs.no_advice != NoAdvice::kNone) {
    return inputs.no_advice;
  }
  if (loading != NoAdvice::kNone) {
    return loading;
  }
  if (inputs.own_ship == nullptr) {
    return NoAdvice::kOwnShipMissing;
  }
  if (!std::isfinite(inputs.own_ship->heading.radians) || !std::isfinite(inputs.own_ship->speed)) {
    return NoAdvice::kOwnShipImplausible;
  }
  return place_sea(inputs, sea);
}

NoAdvice Advisor::take_loading(const StepInputs& inputs) {
  if (inputs.loading != nullptr && !(*inputs.loading == loading_)) {
    if (!(*inputs.loading == *inputs.loading)) {  // NOLINT(misc-redundant-expression): unequal to itself
      return NoAdvice::kLoadingImplausible;       // holds a NaN: would be new every time
    }
    loading_ = *inputs.loading;
    state_ = State::kRebuildDue;
  }
  if (state_ == State::kLoadingRefused) {
    return NoAdvice::kLoadingImplausible;
  }
  return state_ == State::kRebuildDue ? NoAdvice::kLoadingChanged : NoAdvice::kNone;
}

Status Advisor::place_sea(const SeaState* state, const DirectionalSpectrum* spectrum, SeaEnergy& sea) const {
  const auto omega = std::span(transfer_.omega).first(transfer_.num_frequencies);
  return spectrum != nullptr ? place_on_grid(*spectrum, omega, sea) : place_on_grid(*state, omega, sea);
}

NoAdvice Advisor::place_sea(const StepInputs& inputs, SeaEnergy& sea) {
  if (inputs.spectrum == nullptr && inputs.sea_state == nullptr) {
    return NoAdvice::kSeaMissing;
  }
  constexpr double kLeastHeight = 1e-9;  // m: a sea without energy is none, shares of it would be no numbers
  has_sea_ = place_sea(inputs.sea_state, inputs.spectrum, sea).ok() && sea.hs >= kLeastHeight;
  return has_sea_ ? NoAdvice::kNone : NoAdvice::kSeaImplausible;
}

void Advisor::place_zones(const OwnShip& ship, const MeasuredMotion* motion, const SeaEnergy& sea) {
  prepare_zones(zone_ship_, sea, std::span(transfer_.omega).first(transfer_.num_frequencies), zones_);
  if (motion != nullptr) {
    confirm_zones(zone_ship_, ship.heading, ship.speed,
                  {.roll_rms = motion->roll_rms,
                   .roll_period = motion->roll_period,
                   .pitch_rms = motion->pitch_rms,
                   .pitch_period = motion->pitch_period},
                  zones_);
  }
}

NoAdvice Advisor::advise(const StepInputs& step, CycleMemory& cycle) {
  const SeaEnergy& sea = cycle.sea;
  StepOutput& output = cycle.output;
  const OwnShip& ship = *step.own_ship;
  output.quality = hull_quality_ | depth_quality(ship.water_depth, sea, loading_) |
                   (ship.speed_over_ground ? kQualitySpeedOverGround : std::uint32_t{0});
  is_stabilised_ = ship.is_stabilised;
  place_zones(ship, step.motion, sea);
  const GridInputs inputs = grid_inputs(cycle);
  output.hs = sea.hs;
  output.lost_tail = sea.lost_tail;
  output.num_systems = sea.num_systems;
  output.systems = sea.system;
  if (!sweep_grid(inputs, cycle.grid, output.grid)) {
    return NoAdvice::kInternal;
  }
  fill_speed_loss(hull_->resistance, output.grid);
  constexpr int kSpectrum = -1;
  steadiness_.begin(step.time, step.spectrum != nullptr ? kSpectrum : step.sea_source);
  steadiness_.steady(criteria_, output.grid);
  output.unknown_share = unknown_share(output.grid);
  output.roll_period = zone_ship_.roll;
  const Status status = respond(inputs, ship.heading, ship.speed, output.present);
  if (status.error() == Error::kSpeedOutOfGrid) {
    output.advice =
        Advice{.no_advice = NoAdvice::kSpeedOutsideGrid, .heading = ship.heading, .speed = ship.speed};
    output.present = CellResponse{.heading = ship.heading, .speed = ship.speed};
    return NoAdvice::kNone;  // the grid stays
  }
  if (!status) {
    return NoAdvice::kInternal;
  }
  advise_at(present_of(ship, cycle), output);
  return NoAdvice::kNone;
}

/// The steady verdict and the changes.
void Advisor::advise_at(const Present& present, StepOutput& output) {
  Cell& cell = output.present.cell;
  const Verdict now = cell.verdict;
  const Steadiness::Shown shown = steadiness_.present(criteria_, output.grid, present, cell);
  cell.verdict = shown.verdict;
  Advice& advice = output.advice;
  rank_changes(output.grid, present, cell, advice, steadiness_.standing(present));
  steadiness_.follow(advice);
  advice.verdict_now = now;
  advice.better_in = shown.better_in;
}

Present Advisor::present_of(const OwnShip& ship, const CycleMemory& cycle) const {
  const SeaEnergy& sea = cycle.sea;
  Present present{
      .heading = {wrap_two_pi(ship.heading.radians)},
      .speed = ship.speed,
      .following_seas = is_from_astern(sea, cycle.output.present.cell.governing_system, ship.heading),
      .handling = hull_->handling};
  double most_energetic = 0.0;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    if (sea.system[s].hs > most_energetic) {
      most_energetic = sea.system[s].hs;
      present.has_sea_ahead = true;
      present.sea_from = sea.system[s].from;
    }
  }
  if (loading_.measured_roll_period) {
    present.roll_period = *loading_.measured_roll_period;
  } else if (loaded_.roll_natural_frequency > 0.0) {
    present.roll_period = kTwoPi / loaded_.roll_natural_frequency;
  }
  return present;
}

void Advisor::withhold(NoAdvice reason, StepOutput& output) {
  has_sea_ = false;
  output.ensemble.valid = 0;
  output.advice = Advice{.no_advice = reason};
  output.present = CellResponse{};
  output.quality = 0;
  output.hs = 0.0;
  output.lost_tail = 0.0;
  output.unknown_share = -1.0;
  output.roll_period = {};
  output.num_systems = 0;
  output.systems = {};
  output.grid.num_speeds = transfer_.num_speeds;
  output.grid.num_headings = num_headings_;
  output.grid.speeds = transfer_.speeds;
  for (auto& row : output.grid.cells) {
    row.fill(Cell{});  // unknown: never yesterday's green
  }
}

GridInputs Advisor::grid_inputs(const CycleMemory& cycle) const {
  return {.transfer = transfer_,
          .watch = watch_,
          .waves = cycle.waves,
          .criteria = criteria_,
          .channels = channels_,
          .sea = cycle.sea,
          .num_headings = num_headings_,
          .lpp = hull_->lpp,
          .min_steerage_speed = hull_->min_steerage_speed,
          .quality = cycle.output.quality,
          .is_stabilised = is_stabilised_,
          .zone_ship = &zone_ship_,
          .zones = &zones_};
}

Status Advisor::respond_at(Heading heading, double speed, CellResponse& out) const {
  const CycleMemory* const cycle = std::get_if<CycleMemory>(&memory_);
  if (!has_sea_ || cycle == nullptr) {
    return Error::kNotConfigured;
  }
  const Status status = respond(grid_inputs(*cycle), heading, speed, out);
  if (status) {
    const Grid& grid = cycle->output.grid;
    const CellIndex near = nearest_cell(grid, heading, speed);
    const Verdict shown = grid.cells[near.speed][near.heading].verdict;
    out.cell.verdict = severity(shown) > severity(out.cell.verdict) ? shown : out.cell.verdict;
  }
  return status;
}

}  // namespace quickstrip
