// Entries in force: repeated unchanged until they end, withdrawn in a way that the advisor understands.
#include "firmware/display/manual_entries.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "firmware/display/pending_entries.hpp"
#include "msgs/convert/ship_message.hpp"
#include "msgs/convert/text.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kNow = 1'567'600'800'000'000;
constexpr std::int64_t kSecond = 1'000'000;

SeaEntry sea_entry() {
  SeaEntry entry;
  entry.message.utime = kNow;
  entry.message.num_systems = 1;
  entry.message.valid = sea_state_t::VALID_UNTIL;
  entry.message.valid_until_utime = kNow + 100 * kSecond;
  entry.author = "A. Mate";
  entry.brief = "swell";
  return entry;
}

TEST(ManualEntries, AreSentWithALogbookEntryAndRepeatedWithTheSameTime) {
  ManualEntries entries(2);
  DueMessages due;
  entries.enter(sea_entry(), due);
  ASSERT_TRUE(due.sea);
  ASSERT_EQ(due.notes.size(), 1U);
  EXPECT_EQ(due.notes[0].kind, int{logbook_t::KIND_SEA_ENTERED});
  EXPECT_EQ(get_text(due.notes[0].author), "A. Mate");
  EXPECT_EQ(due.notes[0].valid_until_utime, kNow + 100 * kSecond);
  DueMessages first;
  entries.repeat(kNow + kSecond, first);
  DueMessages soon;
  entries.repeat(kNow + 20 * kSecond, soon);
  EXPECT_FALSE(soon.sea);
  DueMessages later;
  entries.repeat(kNow + 32 * kSecond, later);
  ASSERT_TRUE(later.sea);
  EXPECT_EQ(later.sea->utime, kNow);
  EXPECT_EQ(later.sea->seq, due.sea->seq);
  EXPECT_TRUE(later.notes.empty());
}

TEST(ManualEntries, EndByThemselves) {
  ManualEntries entries(2);
  DueMessages due;
  entries.enter(sea_entry(), due);
  DueMessages after;
  entries.repeat(kNow + 100 * kSecond, after);
  EXPECT_FALSE(after.sea);
  EXPECT_FALSE(entries.in_force().sea);
}

TEST(ManualEntries, AWithdrawnSeaIsSentOnceMoreAsEndingNow) {
  ManualEntries entries(2);
  DueMessages due;
  entries.enter(sea_entry(), due);
  DueMessages gone;
  ASSERT_TRUE(entries.withdraw(EntryKind::kSea, "B. Mate", kNow + 5 * kSecond, gone));
  ASSERT_TRUE(gone.sea);
  EXPECT_EQ(gone.sea->utime, kNow + 5 * kSecond);  // newer than the entry, or the advisor would keep that
  EXPECT_EQ(gone.sea->valid_until_utime, gone.sea->utime);
  EXPECT_EQ(gone.notes.at(0).kind, int{logbook_t::KIND_ENTRY_WITHDRAWN});
  EXPECT_FALSE(entries.withdraw(EntryKind::kSea, "B. Mate", kNow + 6 * kSecond, gone));
}

TEST(ManualEntries, AWithdrawnLoadingGivesWayToTheHullFilesDefault) {
  ManualEntries entries(2);
  LoadingEntry entry;
  entry.message.utime = kNow;
  entry.message.valid = loading_t::VALID_GM;
  entry.message.gm_m = 0.4;
  entry.valid_until_utime = kNow + 1000 * kSecond;
  DueMessages due;
  entries.enter(entry, due);
  DueMessages gone;
  ASSERT_TRUE(entries.withdraw(EntryKind::kLoading, "B. Mate", kNow + kSecond, gone));
  ASSERT_TRUE(gone.loading);
  const auto hull = std::make_unique<Hull>(test::s175());
  Loading loading;
  ASSERT_TRUE(to_loading(*gone.loading, *hull, loading).ok());
  EXPECT_EQ(loading.kg, hull->loading.kg);
  EXPECT_EQ(loading.gm, hull->loading.gm);
  EXPECT_EQ(loading.draught_aft, hull->loading.draught_aft);
  EXPECT_EQ(loading.water_density, hull->loading.water_density);
}

TEST(PendingEntries, AreConfirmedOnceAndForgottenAfterFiveMinutes) {
  PendingEntries pending;
  const std::string ticket = pending.keep(sea_entry(), kNow);
  EXPECT_FALSE(pending.take("another", kNow));
  EXPECT_TRUE(pending.take(ticket, kNow + 299 * kSecond));
  EXPECT_FALSE(pending.take(ticket, kNow + 299 * kSecond));
  const std::string late = pending.keep(sea_entry(), kNow);
  EXPECT_FALSE(pending.take(late, kNow + 301 * kSecond));
}

TEST(PendingEntries, AreBounded) {
  PendingEntries pending;
  const std::string first = pending.keep(sea_entry(), kNow);
  for (std::size_t i = 0; i < PendingEntries::kMaxPending; ++i) {
    pending.keep(sea_entry(), kNow);
  }
  EXPECT_FALSE(pending.take(first, kNow));
}

}  // namespace
}  // namespace quickstrip
