// The work of a cycle, counted: what the sums as they are formulated need, whatever the code does besides.
#pragma once

#include "core/advice/grid.hpp"

namespace quickstrip::bench {

struct SweepWork {
  double flops = 0.0;  // multiplications and additions, single or double
  double bytes = 0.0;  // read at least once: transfer functions, roll peaks, bands and factors of the sea
};

/// Of sweep_grid without the verdicts.
SweepWork sweep_work(const GridInputs& inputs);

}  // namespace quickstrip::bench
