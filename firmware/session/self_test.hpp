// What is tried before the first advice: that this machine computes as the one on which the answers were
// worked out. Against damaged memory, a wrong compiler option, a processor in another mode; not against bad
// input. No heap.
//
// Known answer: a small barge of plain form, her whole chain from sections to verdicts, on the advisor's own
// memory: roll and vertical acceleration at four courses and speeds, within 0.1 % of numbers that are written
// down for the profile of capacities (single precision and another mathematics library stay within 0.001 %).
// The numbers follow the core: tests/session says when they must.
#pragma once

#include <cstdint>

#include "core/advisor.hpp"
#include "core/hull/hull.hpp"
#include "core/strip/hull_table.hpp"

namespace quickstrip {

enum class SelfTestItem : std::uint8_t {
  kNone,  // passed
  kSectionTable,
  kHullTable,
  kFloatingPoint,
  kKnownAnswer,
};

/// "the section table in memory is damaged"
const char* message(SelfTestItem failed);

/// Rounds to nearest, keeps subnormal numbers, tells NaN apart: what the core's results rest on.
bool computes_as_ieee754();

/// Fills the barge of the known answer.
void make_known_ship(Hull& out);

/// Largest difference from the known answer, as a fraction of it; a number that is no small one when anything
/// is refused. Leaves `advisor` configured for the barge, `barge` filled.
double known_answer_error(Advisor& advisor, Hull& barge);

/// The first item that fails. `table` may be null. Cost: some 10 ms.
SelfTestItem run_self_test(Advisor& advisor, Hull& barge, const HullTable* table);

}  // namespace quickstrip
