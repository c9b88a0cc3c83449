// Stands in for libfmt on the board: the same names, of small_format.hpp.
#pragma once

#include "firmware/cortex-m7/text/small_format.hpp"

namespace fmt = quickstrip::small_format;
