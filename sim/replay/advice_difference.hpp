// Where two advice messages that should be the same first differ, in one line.
#pragma once

#include <string>

#include "quickstrip/advice_t.hpp"

namespace quickstrip {

/// "cycle 12, 2019-09-02T03:00:00Z: verdict recorded 1, replayed 2". Causes come before consequences.
std::string difference(const advice_t& recorded, const advice_t& replayed);

}  // namespace quickstrip
