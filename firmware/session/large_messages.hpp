// What a session holds for messages beside advice, limits, alerts, logbook and health: 80 kB, which a
// Cortex-M7 does not have.
#pragma once

#include <cstddef>

#include "core/advice/cell_response.hpp"
#include "core/advice/comparison.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/response_message.hpp"
#include "quickstrip/comparison_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/outlook_t.hpp"
#include "quickstrip/response_t.hpp"

namespace quickstrip {

#if defined(QUICKSTRIP_CAPACITY_M7)
struct LargeMessages {};
inline constexpr std::size_t kSessionBufferBytes = 4096;  // advice, the largest that is left, takes 3,290
#else
struct LargeMessages {
  CellResponse asked;
  PredictedMotion predicted;
  Comparison comparison;
  grid_t grid{};
  response_t response{};
  outlook_t outlook{};
  comparison_t comparison_message{};
};
inline constexpr std::size_t kSessionBufferBytes = kMaxMessageBytes;
#endif

}  // namespace quickstrip
