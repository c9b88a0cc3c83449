// Where a sampled periodic series passes a level upwards: when, and how fast.
//
// Between samples the series is the cubic through the four around; an excursion that begins and ends between
// two samples is seen by the parabola through the extreme sample and its neighbours. With omega dt below 0.35
// (omega the mean frequency of the zeros) both the number of crossings and the speeds are within 0.2 %
// (tests/seaway). No state.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace quickstrip::seaway {

struct Crossing {
  double time = 0.0;   // in [0, N dt)
  double speed = 0.0;  // > 0, per second
};

/// In order of time. `sign` +1: x passes `level` upwards; -1: x passes -level downwards (its mirror image).
/// The series continues at its beginning. `out` is emptied first.
void list_crossings(std::span<const double> x, double dt, double level, double sign,
                    std::vector<Crossing>& out);

/// Of events among encounters: how many encounters (from one of `zeros` to the next, the last goes on at the
/// beginning) hold at least one of `events`. Both in order of time.
std::size_t encounters_with_event(std::span<const Crossing> zeros, std::span<const Crossing> events);

}  // namespace quickstrip::seaway
