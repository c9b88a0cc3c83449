#include "firmware/display/manual_entries.hpp"

#include <utility>

#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kRepeatEvery_us = 30'000'000;
constexpr double kSeaWater_kg_m3 = 1025.0;  // the hull file's default, contract §2

}  // namespace

logbook_t ManualEntries::note(int kind, const std::string& author, const std::string& text,
                              std::int64_t now) {
  logbook_t out{};
  out.utime = now;
  out.seq = ++note_seq_;
  out.source_id = source_id_;
  out.kind = static_cast<std::int8_t>(kind);
  put_text(author, out.author);
  put_text(text, out.text);
  return out;
}

void ManualEntries::enter(SeaEntry entry, DueMessages& due) {
  entry.message.seq = ++seq_;
  entry.message.source_id = source_id_;
  due.sea = entry.message;
  due.notes.push_back(note(logbook_t::KIND_SEA_ENTERED, entry.author, entry.brief, entry.message.utime));
  due.notes.back().valid_until_utime = entry.message.valid_until_utime;
  in_force_.sea = std::move(entry);
}

void ManualEntries::enter(LoadingEntry entry, DueMessages& due) {
  entry.message.seq = ++seq_;
  entry.message.source_id = source_id_;
  due.loading = entry.message;
  due.notes.push_back(note(logbook_t::KIND_LOADING_ENTERED, entry.author, entry.brief, entry.message.utime));
  due.notes.back().valid_until_utime = entry.valid_until_utime;
  in_force_.loading = std::move(entry);
}

bool ManualEntries::withdraw(EntryKind kind, const std::string& author, std::int64_t now, DueMessages& due) {
  if (kind == EntryKind::kSea && in_force_.sea) {
    due.sea = in_force_.sea->message;
    due.sea->utime = now;
    due.sea->valid_until_utime = now;
    due.sea->seq = ++seq_;
    in_force_.sea.reset();
    due.notes.push_back(note(logbook_t::KIND_ENTRY_WITHDRAWN, author, "sea entered by hand withdrawn", now));
    return true;
  }
  if (kind == EntryKind::kLoading && in_force_.loading) {
    loading_t back{};
    back.utime = now;
    back.seq = ++seq_;
    back.source_id = source_id_;
    back.source_kind = loading_t::SOURCE_MANUAL;
    back.valid = loading_t::VALID_WATER_DENSITY;  // one field at least; the rest is the hull file's default
    back.water_density_kg_m3 = kSeaWater_kg_m3;
    put_text("hull file's default", back.condition);
    due.loading = back;
    in_force_.loading.reset();
    due.notes.push_back(note(logbook_t::KIND_ENTRY_WITHDRAWN, author,
                             "loading entered by hand withdrawn: the hull file's default", now));
    return true;
  }
  return false;
}

void ManualEntries::mark(const std::string& author, const std::string& text, std::int64_t now,
                         DueMessages& due) {
  due.notes.push_back(note(logbook_t::KIND_MARK, author, text, now));
}

void ManualEntries::repeat(std::int64_t now, DueMessages& due) {
  if (in_force_.sea && now >= in_force_.sea->message.valid_until_utime) {
    in_force_.sea.reset();  // the advisor has its end from the message
  }
  if (in_force_.loading && now >= in_force_.loading->valid_until_utime) {
    in_force_.loading.reset();
  }
  const bool is_due = now - sent_utime_ >= kRepeatEvery_us || now < sent_utime_;
  if (!is_due) {
    return;
  }
  sent_utime_ = now;
  if (in_force_.sea) {
    due.sea = in_force_.sea->message;
  }
  if (in_force_.loading) {
    due.loading = in_force_.loading->message;
  }
}

}  // namespace quickstrip
