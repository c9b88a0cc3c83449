#include "firmware/display/pending_entries.hpp"

#include <algorithm>
#include <utility>

#include "firmware/display/request_guard.hpp"

namespace quickstrip {

std::string PendingEntries::keep(PendingEntry entry, std::int64_t now) {
  if (kept_.size() == kMaxPending) {
    kept_.pop_front();
  }
  kept_.push_back({random_token(), now, std::move(entry)});
  return kept_.back().ticket;
}

std::optional<PendingEntry> PendingEntries::take(const std::string& ticket, std::int64_t now) {
  std::erase_if(kept_, [now](const Kept& kept) { return now - kept.since > kForgotten_us; });
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.ticket == ticket; });
  if (found == kept_.end()) {
    return std::nullopt;
  }
  PendingEntry entry = std::move(found->entry);
  kept_.erase(found);
  return entry;
}

}  // namespace quickstrip
