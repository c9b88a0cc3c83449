// How near moments come to what they should be: responses, their weights and the partial sums are kept in
// single precision (core/response/channel_energy.hpp), 6e-8 of a value each.
#pragma once

namespace quickstrip {

inline constexpr double kSingle = 1e-6;  // of a moment

}  // namespace quickstrip
