// What the advisor says of the same ship, sea, course and speed: respond(), by channel of the watch.
#pragma once

#include <cstdint>
#include <vector>

#include "core/advice/cell_response.hpp"
#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_state.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip::seaway {

/// One of the two; lives as long as the call.
struct SeaView {
  const SeaState* systems = nullptr;
  const DirectionalSpectrum* measured = nullptr;
};

struct Stated {
  std::vector<QuantityResponse> quantities;  // by channel of the watch
  std::uint32_t quality = 0;                 // of the cell
  double roll_damping = 0.0;                 // added b44 that it rests on [N m s]
};

/// speed [m/s]. Errors: those of transfer functions, place_on_grid() and respond(). Cost: some 60 ms.
Result<Stated> stated(const Hull& hull, const LoadedHull& loaded, const Watch& watch, const SeaView& sea,
                      Heading heading, double speed, std::uint32_t quality);

}  // namespace quickstrip::seaway
