// What the page posts, read and judged: the same ranges as the advisor's own (msgs/convert), so that what is
// accepted here is accepted there; each refusal names its field in words for beside that field.
// Any bytes may come: malformed JSON, other types, numbers beyond everything.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/hull/hull.hpp"
#include "firmware/display/manual_entries.hpp"
#include "quickstrip/query_t.hpp"

namespace quickstrip {

struct FieldError {
  std::string field;  // "systems.0.hs_m"; empty: the whole
  std::string text;   // "between 0 and 30 m"
};
using FieldErrors = std::vector<FieldError>;

inline constexpr std::int64_t kSeaHolds_us = 7'200'000'000;       // 2 h, by default
inline constexpr std::int64_t kLoadingHolds_us = 86'400'000'000;  // 24 h

/// A sea of a wind sea and up to two swells. Empty list: `out` holds the entry, measured at `now`.
FieldErrors read_sea(std::string_view json, std::int64_t now, SeaEntry& out);

/// `hull`: what the advisor checks a loading against; nullptr: not known here, only ranges that hold for any
/// ship are checked, and the advisor may still refuse.
FieldErrors read_loading(std::string_view json, std::int64_t now, const Hull* hull, LoadingEntry& out);

struct MarkEntry {
  std::string author;
  std::string text;
};
FieldErrors read_mark(std::string_view json, MarkEntry& out);

/// heading_deg and speed_kn; utime, seq, source_id and query_id are the caller's.
FieldErrors read_query(std::string_view json, query_t& out);

struct AcknowledgeEntry {
  std::int32_t alert_id = 0;
  std::int32_t instance = 0;
  std::int32_t revision = 0;
  bool silence_only = false;
};
FieldErrors read_acknowledge(std::string_view json, AcknowledgeEntry& out);

struct WithdrawEntry {
  EntryKind kind = EntryKind::kSea;
  std::string author;
};
FieldErrors read_withdraw(std::string_view json, WithdrawEntry& out);

/// The ticket of what was read back and is now confirmed.
FieldErrors read_confirm(std::string_view json, std::string& ticket);

/// {"errors":[{"field":..., "text":...}]}
std::string errors_json(const FieldErrors& errors);

/// "14:30 UTC"
std::string utc_clock(std::int64_t utime);

}  // namespace quickstrip
