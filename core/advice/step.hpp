// What goes into one cycle and what comes out of it: the door between the session and the advisor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/advice/advice.hpp"
#include "core/advice/cell_response.hpp"
#include "core/advice/ensemble.hpp"
#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"
#include "core/hazard/roll_period_band.hpp"
#include "core/hull/hull.hpp"
#include "core/sea/sea_state.hpp"

namespace quickstrip {

struct OwnShip {
  Heading heading;
  double speed = 0.0;                   // through the water, or over ground and said so [m/s]
  bool speed_over_ground = false;       // fallback: speed through the water is not known
  std::optional<double> water_depth{};  // from the surface [m]; empty: not known
  bool is_stabilised = false;           // own ship says that her stabilisers work
};

/// What an accelerometer felt, without static g; x from the aft perpendicular, y to port, z above the base
/// line [m]; RMS along the ship's axes [m/s2].
struct MeasuredAcceleration {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  std::optional<double> rms_x{};
  std::optional<double> rms_y{};
  std::optional<double> rms_z{};
};

inline constexpr std::size_t kMaxAccelerometers = 4;  // as motion_t

/// What was measured over a window that ended lately; RMS about the mean, zero-crossing periods.
struct MeasuredMotion {
  double window = 0.0;                   // s
  std::optional<double> roll_rms{};      // rad
  std::optional<double> roll_period{};   // s
  std::optional<double> roll_max{};      // rad, greatest single amplitude
  std::optional<double> pitch_rms{};     // rad
  std::optional<double> pitch_period{};  // s
  std::optional<double> heave_rms{};     // m
  std::optional<double> heave_period{};  // s
  StaticVector<MeasuredAcceleration, kMaxAccelerometers> accelerations;
};

/// Core has no clock: age is the session's to judge, and `no_advice` its way to say that an input is missing
/// or stale. Null: not there. Objects live until step() returns.
struct StepInputs {
  const SeaState* sea_state = nullptr;            // one of the two; with both, the measured spectrum is used
  const DirectionalSpectrum* spectrum = nullptr;  // and the session decides which is newer
  const OwnShip* own_ship = nullptr;
  const Loading* loading = nullptr;  // null: the loading in force stays
  NoAdvice no_advice = NoAdvice::kNone;
  int sea_source = 0;                      // kind of source that the sea state comes from: any number each
  double time = 0.0;                       // of this cycle, from any fixed moment [s]: only differences count
  const MeasuredMotion* motion = nullptr;  // null: nothing measured, or too long ago
  // Members of the ensemble to compute in this step, 0 ... kEnsembleMembers, and what they are drawn from.
  std::size_t ensemble_members = 0;
  Uncertainty uncertainty{};
};

/// advice.no_advice says whether the rest is valid. Without advice all cells are unknown, but for
/// kSpeedOutsideGrid, where the grid is valid and the present state is not known. About 370 kB: static.
struct StepOutput {
  Advice advice;
  Grid grid;
  CellResponse present;  // without advice: no quantities, verdict unknown
  std::uint32_t quality = 0;
  double hs = 0.0;              // of the sea that was used [m]
  double lost_tail = 0.0;       // fraction of its m0 outside the frequencies
  double unknown_share = -1.0;  // of the cells at steerage speed and above, 0 ... 1; -1: no grid
  RollPeriodBand roll_period;   // that the zones stand on; without advice: not known
  Ensemble ensemble;
  std::size_t num_systems = 0;
  std::array<WaveSystem, kMaxWaveSystems> systems{};
};

}  // namespace quickstrip
