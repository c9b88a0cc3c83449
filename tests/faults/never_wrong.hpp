// What must hold of every advice and grid that the bridge receives, whatever has gone wrong: the common
// checker of the fault tests. Each function gives the first promise that is broken, in words, or an empty
// string.
//
//   advice: decodes, in range, digest its own; no advice comes with its reason and with nothing else; advice
//   rests on a sea, a ship and a loading that were sent as such (source, number, time), none of them too old
//   or from the future; is valid into the future of its time; its numbers are those of the oracle for these
//   inputs, and its verdict is no better. grid: of an advice's cycle; without advice every cell unknown; with
//   advice the oracle's numbers, and no cell better.
#pragma once

#include <string>

#include "quickstrip/advice_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "tests/faults/oracle.hpp"
#include "tests/faults/sent.hpp"

namespace quickstrip::faults {

struct Promises {
  double own_ship_stale_after_s = 10.0;
  double sea_stale_after_s = 5400.0;
  double loading_stale_after_s = 86400.0;
  double cycle_s = 0.1;
  std::int16_t source_id = 1;
};

/// `now_us`: the advisor's clock when the message came, as far as the test knows.
std::string fault_of(const advice_t& advice, const Sent& sent, const Promises& promises, Oracle& oracle);

/// `advice`: of the same cycle.
std::string fault_of(const grid_t& grid, const advice_t& advice, const Sent& sent, Oracle& oracle);

/// With the verdict "good" at the present course and speed.
bool is_good(const advice_t& advice);

}  // namespace quickstrip::faults
