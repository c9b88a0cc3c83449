// The widest range in which a hull and a loading are taken for one: models of a hand's length to islands, on
// any planet. Beyond it numbers lose their digits or overflow on the way, and no ship is meant. The messages
// and files have far narrower ranges of their own; this is the door for whoever calls core without them.
// Every bound is ours.
#pragma once

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

/// Length, stations and what is watched. Errors: kNotFinite, kOutOfRange.
Status check_physical_range(const Hull& hull);

/// What floats her and how she turns, in lengths of `lpp`. Errors: kNotFinite, kOutOfRange.
Status check_physical_range(const Loading& loading, double lpp);

}  // namespace quickstrip
