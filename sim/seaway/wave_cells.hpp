// The waves of a block of time: every beam cut into cells of wave frequency whose encounter frequencies fall
// on the bins of the block, n d_omega, d_omega = 2 pi / T. A cell is a piece between the frequencies at which
// omega_e passes from one bin to the next, cut again where that is wide (a following sea folds: at the turn
// of omega_e many wave lengths have one encounter frequency). No energy is lost or moved by more than half a
// bin of omega_e: 0.0009 rad/s for a block of an hour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/angles.hpp"
#include "sim/seaway/beams.hpp"

namespace quickstrip::seaway {

struct WaveCell {
  double omega = 0.0;      // middle of the cell, wave frequency [rad/s]
  double energy = 0.0;     // m2, of the surface
  std::uint32_t beam = 0;  // index
  std::int32_t bin = 0;    // of omega_e, signed: negative when the ship overtakes the waves
};

struct CellGrid {
  Heading heading;
  double speed = 0.0;         // m/s
  double gravity = 0.0;       // m/s2
  double step = 0.0;          // d_omega of the bins [rad/s]
  double widest_cell = 0.01;  // in wave frequency [rad/s]
};

std::vector<WaveCell> wave_cells(const Beams& sea, const CellGrid& grid);

/// The greatest |omega_e| of the sea on this course [rad/s]. step and widest cell are not looked at.
double highest_encounter(const Beams& sea, const CellGrid& grid);

}  // namespace quickstrip::seaway
