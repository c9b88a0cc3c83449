// What the officer has entered and is in force: repeated on the bus with the time of its entry until it ends,
// so that an advisor that starts again has it. Withdrawn: said on the bus too.
//
// A sea that is withdrawn is sent once more as ending now (its valid_until_utime): the advisor then uses a
// radar's if there is one, or says that it has none. A loading that is withdrawn gives way to the hull file's
// default. A loading that has reached its end is no longer repeated: the advisor ages it (24 h), never
// silently takes another.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quickstrip/loading_t.hpp"
#include "quickstrip/logbook_t.hpp"
#include "quickstrip/sea_state_t.hpp"

namespace quickstrip {

struct SeaEntry {
  sea_state_t message{};
  std::string author;
  std::string words;  // read back before it is sent
  std::string brief;  // for the logbook
};

struct LoadingEntry {
  loading_t message{};
  std::int64_t valid_until_utime = 0;  // loading_t has none of its own
  std::string author;
  std::string words;
  std::string brief;
};

struct EntriesInForce {
  std::optional<SeaEntry> sea;
  std::optional<LoadingEntry> loading;
};

/// What is to be published now.
struct DueMessages {
  std::optional<sea_state_t> sea;
  std::optional<loading_t> loading;
  std::vector<logbook_t> notes;
};

enum class EntryKind { kSea, kLoading };

/// One thread at a time.
class ManualEntries {
 public:
  explicit ManualEntries(std::int16_t source_id) : source_id_(source_id) {}

  /// In force from now on; what is to be published at once is in `due`.
  void enter(SeaEntry entry, DueMessages& due);
  void enter(LoadingEntry entry, DueMessages& due);
  /// False when nothing of that kind is in force.
  bool withdraw(EntryKind kind, const std::string& author, std::int64_t now, DueMessages& due);
  void mark(const std::string& author, const std::string& text, std::int64_t now, DueMessages& due);

  /// Every half minute, and what has come to its end.
  void repeat(std::int64_t now, DueMessages& due);

  [[nodiscard]] const EntriesInForce& in_force() const { return in_force_; }

 private:
  logbook_t note(int kind, const std::string& author, const std::string& text, std::int64_t now);

  std::int16_t source_id_;
  std::int32_t seq_ = 0;
  std::int32_t note_seq_ = 0;
  std::int64_t sent_utime_ = 0;
  EntriesInForce in_force_;
};

}  // namespace quickstrip
