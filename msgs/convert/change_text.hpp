// A change of course and speed in words, and the turn that leads there. No heap.
#pragma once

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/why_text.hpp"

namespace quickstrip {

/// "come 20° to port and reduce to 12 kn", "come 200° to starboard (the longer way)"
void add_action(const Change& change, Sentence& out);

/// "Come 20° to port (course 250°): good; slamming at bow 1.1 %, limit 2.2 %, reached if waves grow 30 %;
/// next roll, reached if waves grow 80 %; swell of 12 s from 240°". `cell` of the grid at the change, or null
/// when it is not a cell: then without the figure.
void add_change(const Change& change, const Cell* cell, const Criteria& criteria, WaveSystems systems,
                Sentence& out);

/// "Coming to 020° passes 085° beam-on: 18° roll likely, 2 min above a limit, takes 4 min; there roll, waves
/// would have to fall by 40 %". Nothing when the way is no worse than its ends and hardly rolls.
void add_turn(const Change& change, const Cell& present, const Criteria& criteria, WaveSystems systems,
              Sentence& out);

}  // namespace quickstrip
