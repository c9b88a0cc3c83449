// What the tests of outgoing messages send: a grid, a slamming cell, an advice that asks for a change.
#pragma once

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/grid.hpp"
#include "core/hull/hull.hpp"
#include "msgs/convert/advice_message.hpp"

namespace quickstrip::test {

Hull& s175();
Criteria some_criteria();
Cell slamming_cell();
Grid& small_grid();
Advice slamming_advice();
AdviceContext some_context();

}  // namespace quickstrip::test
