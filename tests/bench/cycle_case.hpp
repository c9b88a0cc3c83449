// What the cycle is timed on: the S-175 in a given number of wave systems, or in a measured spectrum.
#pragma once

#include <cstddef>
#include <memory>

#include "core/advice/criteria.hpp"
#include "core/advice/step.hpp"
#include "core/base/angles.hpp"
#include "core/hull/hull.hpp"
#include "core/sea/sea_state.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::bench {

struct Case {
  Hull hull = test::s175();
  SeaState sea;
  DirectionalSpectrum measured;
  OwnShip ship{Heading{radians(75.0)}, 7.0, false};
  StepInputs inputs;
};

/// Wave systems; 0: a measured spectrum of 47 bands.
std::unique_ptr<Case> make_case(std::size_t num_systems);

/// A criterion never reached for every channel that has none: each is then needed and watched in every cell.
Criteria every_response(const Hull& hull);

}  // namespace quickstrip::bench
