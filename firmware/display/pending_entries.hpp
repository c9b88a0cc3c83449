// Entries that were read back to the officer and wait for the confirmation: what is confirmed is what was
// read back, to the letter. Bounded, and forgotten after some minutes.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>

#include "firmware/display/manual_entries.hpp"

namespace quickstrip {

using PendingEntry = std::variant<SeaEntry, LoadingEntry>;

class PendingEntries {
 public:
  static constexpr std::size_t kMaxPending = 16;
  static constexpr std::int64_t kForgotten_us = 300'000'000;

  /// The ticket that confirms it.
  std::string keep(PendingEntry entry, std::int64_t now);
  /// Once only; nothing for an unknown or forgotten ticket.
  std::optional<PendingEntry> take(const std::string& ticket, std::int64_t now);

 private:
  struct Kept {
    std::string ticket;
    std::int64_t since = 0;
    PendingEntry entry;
  };
  std::deque<Kept> kept_;
};

}  // namespace quickstrip
