// The advisor: configure once, then one step a cycle. Owns all of its memory (7.6 MB: make it static, never
// on the stack); allocates nothing, knows no clock, reads no file.
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
#include "core/strip/method.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

class Advisor {
 public:
  /// With the hull's own loading. `table`: compiled for this hull, or null (Lewis forms); it must outlive the
  /// advisor. Errors: those of check_criteria, load, list_channels,
  /// list_people_channels, solve_transfer_functions; kOutOfRange or kTooMany for the grid definition. After
  /// an error not configured.
  Status configure(const Hull& hull, const Criteria& criteria, const StripMethod& method,
                   const SteadinessOptions& steadiness = {}, const HullTable* table = nullptr);

  /// One cycle. The reference stays valid until the next step.
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
  [[nodiscard]] const Hull& hull() const { return hull_; }
  [[nodiscard]] const LoadedHull& loaded_hull() const { return loaded_; }
  [[nodiscard]] const TransferFunctions& transfer_functions() const { return transfer_; }
  [[nodiscard]] const ZoneShip& zone_ship() const { return zone_ship_; }
  /// In the sea of the last step that gave advice.
  [[nodiscard]] const Zones& zones() const { return zones_; }

 private:
  enum class State : std::uint8_t { kNotConfigured, kReady, kRebuildDue, kLoadingRefused };

  Status build(const Loading& loading);
  Status solve_speeds();
  NoAdvice take_loading(const StepInputs& inputs);
  NoAdvice take_inputs(const StepInputs& inputs);
  NoAdvice place_sea(const StepInputs& inputs);
  NoAdvice advise(const StepInputs& inputs);
  void advise_at(const Present& present);
  [[nodiscard]] Present present_of(const OwnShip& ship) const;
  Status place_sea(const SeaState* state, const DirectionalSpectrum* spectrum);
  void sweep_ensemble(const StepInputs& inputs);
  Status sweep_member(const StepInputs& inputs, std::size_t member);
  void place_zones(const OwnShip& ship, const MeasuredMotion* motion);
  void withhold(NoAdvice reason);
  [[nodiscard]] GridInputs grid_inputs(std::uint32_t quality) const;
  [[nodiscard]] bool is_from_astern(std::uint8_t system, Heading heading) const;

  State state_ = State::kNotConfigured;
  bool has_sea_ = false;
  bool is_stabilised_ = false;  // in the last step that gave advice
  Hull hull_;
  Criteria criteria_;
  StripMethod method_;
  const HullTable* table_ = nullptr;
  Loading loading_;  // in force, due or refused: see state_
  std::size_t num_headings_ = 0;
  LoadedHull loaded_;
  TransferFunctions transfer_;
  Watch watch_;
  CriteriaChannels channels_;
  SeaEnergy sea_;
  Steadiness steadiness_;
  ZoneShip zone_ship_;
  Zones zones_;  // of the sea
  // Of rebuilding and of a cycle, which are never at once: one memory for both.
  std::variant<TransferWorkspace, GridWorkspace> scratch_;
  StepOutput output_;
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
