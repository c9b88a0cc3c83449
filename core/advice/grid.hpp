// The cycle: the verdict on every speed and heading of the grid.
//
// For one speed at a time the moments of the channels that criteria and columns need are found on every
// heading (response/heading_moments.hpp), all wave systems apart; then each cell is judged. The same bits on
// every run.
//
// Cost: response/heading_moments.hpp, and some 100 ns a cell for the verdict. Figures: tests/bench.
// Memory: the workspace, 1.9 MB; static.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/ensemble.hpp"
#include "core/advice/verdict.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/hazard/zones.hpp"
#include "core/response/heading_moments.hpp"
#include "core/response/mean_added_resistance.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// What the verdicts rest on; references live as long as the call.
struct GridInputs {
  const TransferFunctions& transfer;
  const Watch& watch;
  const IncidentWaves& waves;  // of these transfer functions and this watch (list_incident_waves())
  const Criteria& criteria;
  const CriteriaChannels& channels;
  const SeaEnergy& sea;
  std::size_t num_headings = kMaxHeadings;  // divides kNumDirections
  double lpp = 0.0;                         // m, for the Froude number
  double min_steerage_speed = 0.0;          // m/s
  std::uint32_t quality = 0;                // bits of the hull and its loading
  bool is_stabilised = false;               // stabilisers work
  RollShift roll_shift{};                   // of a member of an ensemble
  // IMO zones, prepared for this sea (hazard/zones.hpp). Null, both or none: motions alone are judged.
  const ZoneShip* zone_ship = nullptr;
  const Zones* zones = nullptr;
  bool wants_all_bandwidths = false;  // of every quantity in a response, not of the watched ones alone
};

/// Scratch of sweep_grid.
struct GridWorkspace {
  SweepWorkspace sweep;
  HeadingMoments moments;
  HeadingResistance resistance;
  std::array<ResponseMoments, kMaxChannels> cell{};
  Needs needs{};
};

/// Speeds of the grid are those of the transfer functions. Errors: kEmptySpectrum (no energy anywhere),
/// kOutOfRange (num_headings), kTooMany (sea and transfer functions have different frequencies).
Status sweep_grid(const GridInputs& inputs, GridWorkspace& workspace, Grid& out);

/// The same of one member of an ensemble, `inputs.roll_shift` and `inputs.sea` being its own: sets or clears
/// its bit in each cell, by whether a limit on a motion is exceeded there. Not where kEnsembleMembers is 0.
Status sweep_member(const GridInputs& inputs, std::size_t member, GridWorkspace& workspace,
                    ExceededMembers& out);

/// The part of the cells at steerage speed and above whose verdict is unknown; -1 when there is none.
double unknown_share(const Grid& grid);

/// What is known of a cell before its moments are. `low_encounter_share`: of the wave energy.
CellCircumstances circumstances(const GridInputs& inputs, Heading heading, double speed,
                                double low_encounter_share, const RollDampingInUse& damping);

}  // namespace quickstrip
