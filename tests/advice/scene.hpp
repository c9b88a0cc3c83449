// A ship, its transfer functions and a sea made by hand, ready for a cycle.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "core/advice/cell_response.hpp"
#include "core/advice/grid.hpp"
#include "core/advice/nordforsk.hpp"
#include "tests/response/synthetic.hpp"

namespace quickstrip::synthetic {

/// Everything big is on the heap: tests may.
class Scene {
 public:
  Scene() {
    fill_box(hull);
    criteria = *nordforsk_merchant(hull);
    fill(transfer, 9, 1.0, 40, shiplike);
    bind();
  }
  void bind() {
    ASSERT_TRUE(check_criteria(criteria, hull).ok());
    ASSERT_TRUE(list_channels(hull, hull.loading, box_hydrostatics(), SwellUp::kOff, watch).ok());
    channels = bind_criteria(criteria, watch);
  }
  [[nodiscard]] GridInputs inputs() {
    list_incident_waves(transfer, watch, waves);
    return {.transfer = transfer,
            .watch = watch,
            .waves = waves,
            .criteria = criteria,
            .channels = channels,
            .sea = sea,
            .num_headings = num_headings,
            .lpp = hull.lpp,
            .min_steerage_speed = hull.min_steerage_speed};
  }
  void sweep() { ASSERT_TRUE(sweep_grid(inputs(), workspace, grid).ok()); }

  Hull hull;
  Criteria criteria;
  TransferFunctions transfer;
  Watch watch;
  IncidentWaves waves;
  CriteriaChannels channels;
  SeaEnergy sea;
  std::size_t num_headings = kMaxHeadings;
  GridWorkspace workspace;
  Grid grid;
  CellResponse response;
};

}  // namespace quickstrip::synthetic
