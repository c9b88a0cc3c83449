// Who may send what: for each input the source ids whose messages are taken. Nothing listed: everybody's. A
// network where anybody may send a sea state is one where a test rig may; LCM itself knows no senders, so
// this keeps out mistakes, not malice. No heap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/static_vector.hpp"
#include "firmware/session/inputs.hpp"

namespace quickstrip {

class AllowList {
 public:
  static constexpr std::size_t kMaxSources = 8;  // of one input

  [[nodiscard]] bool admits(Input input, std::int16_t source_id) const {
    const auto& ids = ids_[static_cast<std::size_t>(input)];
    return ids.size() == 0 || std::find(ids.begin(), ids.end(), source_id) != ids.end();
  }

  /// False when there is no room for another.
  bool allow(Input input, std::int16_t source_id) {
    return ids_[static_cast<std::size_t>(input)].push_back(source_id);
  }

  /// "SEA_STATE=3" or "OWN_SHIP=1,2": the channel without its prefix, and the ids. False when it is none, or
  /// there are too many; then nothing has changed.
  bool read(std::string_view text);

 private:
  std::array<StaticVector<std::int16_t, kMaxSources>, kNumInputs> ids_{};
};

}  // namespace quickstrip
