// The advisor: configure once, then one step a cycle. Owns all of its memory but the hull (6.4 MB: make it
// static, never on the stack); allocates nothing, knows no clock, reads no file.
//
//   static Advisor advisor;
//   advisor.configure(hull, criteria, method);        // builds the loaded hull's transfer functions
//   for each cycle:
//     const StepOutput& output = advisor.step(inputs);
//     publish(output);
//     if (advisor.is_rebuild_due()) advisor.rebuild(); // a new loading: the step said kLoadingChanged
//
// Cost on one x86-64 core, S-175, default criteria, 25 speeds x 72 headings (processor time): tests/bench
// prints it. It depends on the sea through the number of its bands and systems only. Deepest stack frame here
// 8 kB. All loops are bounded by capacity.hpp. Not thread-safe: one thread steps and rebuilds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "core/advice/criteria.hpp"
#include "core/advice/ensemble.hpp"
#include "core/advice/grid.hpp"
#include "core/advice/ranking.hpp"
#include "core/advice/steadiness.hpp"
#include "core/advice/step.hpp"
#include "core/advice/verdict.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/hazard/zones.hpp"
#include "core/hull/hull.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/hull_table.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/loading_summary.hpp"
#include "core/strip/method.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

class Advisor {
 public:
  /// With the hull's own loading. `table`: compiled for this hull, or null (Lewis forms). Hull and table must
  /// outlive the advisor: they are not copied. Errors: those of check_criteria, load, list_channels,
  /// list_people_channels, solve_transfer_functions; kOutOfRange or kTooMany for the grid definition. After
  /// an error not configured.
  Status configure(const Hull& hull, const Criteria& criteria, const StripMethod& method,
                   const SteadinessOptions& steadiness = {}, const HullTable* table = nullptr);
  Status configure(const Hull&& hull, const Criteria& criteria, const StripMethod& method,
                   const SteadinessOptions& steadiness = {}, const HullTable* table = nullptr) = delete;

  /// One cycle. The reference stays valid until the next step or rebuild.
  const StepOutput& step(const StepInputs& inputs);

  /// A step met a loading that is not the one in force.
  [[nodiscard]] bool is_rebuild_due() const { return state_ == State::kRebuildDue; }

  /// Builds the transfer functions for the loading that the last step met; after success steps give advice
  /// for it. After an error they say kLoadingImplausible until another loading comes. Ok and idle when none
  /// is due.
  Status rebuild();

  /// Every quantity at any course and speed of the grid, in the sea of the last step that gave advice or said
  /// kSpeedOutsideGrid; the verdict is no better than the shown one of the nearest cell. Errors:
  /// kNotConfigured (no such step), kSpeedOutOfGrid, kNotFinite.
  Status respond_at(Heading heading, double speed, CellResponse& out) const;

  [[nodiscard]] const Criteria& criteria() const { return criteria_; }
  /// Of the loading in force.
  [[nodiscard]] const LoadingSummary& loading_summary() const { return loaded_; }
  /// Quality bits of the hull and the loading in force.
  [[nodiscard]] std::uint32_t hull_quality() const { return hull_quality_; }
  [[nodiscard]] const TransferFunctions& transfer_functions() const { return transfer_; }
  [[nodiscard]] const ZoneShip& zone_ship() const { return zone_ship_; }
  /// In the sea of the last step that gave advice.
  [[nodiscard]] const Zones& zones() const { return zones_; }

 private:
  // A change of loading and a cycle are never at once: one memory for both.
  struct BuildMemory {
    LoadedHull loaded;
    TransferWorkspace work;
  };
  struct CycleMemory {
    IncidentWaves waves;  // of the loading
    SeaEnergy sea;
    GridWorkspace grid;
    StepOutput output;
  };
  enum class State : std::uint8_t { kNotConfigured, kReady, kRebuildDue, kLoadingRefused };

  Status build(const Loading& loading);
  Status solve_speeds(BuildMemory& memory);
  NoAdvice take_loading(const StepInputs& inputs);
  NoAdvice take_inputs(const StepInputs& inputs, SeaEnergy& sea);
  NoAdvice place_sea(const StepInputs& inputs, SeaEnergy& sea);
  Status place_sea(const SeaState* state, const DirectionalSpectrum* spectrum, SeaEnergy& sea) const;
  NoAdvice advise(const StepInputs& inputs, CycleMemory& cycle);
  void advise_at(const Present& present, StepOutput& output);
  [[nodiscard]] Present present_of(const OwnShip& ship, const CycleMemory& cycle) const;
  void sweep_ensemble(const StepInputs& inputs, CycleMemory& cycle);
  Status sweep_member(const StepInputs& inputs, std::size_t member, CycleMemory& cycle);
  void place_zones(const OwnShip& ship, const MeasuredMotion* motion, const SeaEnergy& sea);
  void withhold(NoAdvice reason, StepOutput& output);
  [[nodiscard]] GridInputs grid_inputs(const CycleMemory& cycle) const;

  State state_ = State::kNotConfigured;
  bool has_sea_ = false;
  bool is_stabilised_ = false;  // in the last step that gave advice
  const Hull* hull_ = nullptr;
  Criteria criteria_;
  StripMethod method_;
  const HullTable* table_ = nullptr;
  Loading loading_;  // in force, due or refused: see state_
  std::size_t num_headings_ = 0;
  LoadingSummary loaded_;
  std::uint32_t hull_quality_ = 0;
  TransferFunctions transfer_;
  Watch watch_;
  CriteriaChannels channels_;
  Steadiness steadiness_;
  ZoneShip zone_ship_;
  Zones zones_;  // of the sea
  std::variant<BuildMemory, CycleMemory> memory_;
  // The ensemble: the member to compute next, when each was, and the sea of the one in hand.
  std::size_t next_member_ = 0;
  std::array<double, kEnsembleMembers> member_time_{};
  struct ShiftedSea {
    SeaState state;
    DirectionalSpectrum spectrum;
  };
  std::array<ShiftedSea, kEnsembleMembers == 0 ? 0 : 1> shifted_{};
};

static_assert(sizeof(Advisor) + kMaxHullTableBytes <= kMostAdvisorBytes, "the advisor's memory is a promise");

}  // namespace quickstrip
