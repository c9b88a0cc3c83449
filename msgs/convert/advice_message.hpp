// QS_ADVICE from core's Advice and what the session knows about its inputs. No heap.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "msgs/convert/advice_text.hpp"
#include "msgs/convert/ship_message.hpp"
#include "quickstrip/advice_t.hpp"

namespace quickstrip {

/// As advice_t's USE_...
enum class InputUse : std::uint8_t { kNone = 0, kLive = 1, kRestored = 2, kDefault = 3 };

/// One of the messages that an advice rests on.
struct UsedInput {
  InputUse use = InputUse::kNone;
  std::int16_t source_id = 0;
  std::int32_t seq = 0;
  std::int64_t utime = 0;
};

inline constexpr std::size_t kNumAdviceInputs = 6;  // advice_t's INPUT_...

/// All that an advice message says beyond core's advice.
struct AdviceContext {
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  std::int16_t source_id = 0;
  std::int64_t valid_until_utime = 0;
  std::int64_t limits_digest = 0;
  std::int64_t hull_digest = 0;
  std::string_view hull_name;
  std::string_view profile_name;
  std::array<UsedInput, kNumAdviceInputs> inputs{};
  std::uint32_t sea_assumptions = 0;
  SpeedKind speed_kind = SpeedKind::kNotKnown;
  NoAdviceDetail no_advice;
  WaveSystems systems;  // of the sea in force; may be empty
};

/// Fills the whole message but its digest (seal it last). `grid` gives the figures of the changes; it is read
/// only when there is advice.
void to_message(const Advice& advice, const Grid& grid, const Criteria& criteria,
                const AdviceContext& context, advice_t& out);

/// The cell at a heading and speed that are nodes of the grid; null when they are not.
const Cell* cell_at(const Grid& grid, double heading, double speed);

}  // namespace quickstrip
