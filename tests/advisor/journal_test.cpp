// What the journal is told of deadlines that were missed.
#include "firmware/advisor/journal.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace quickstrip::test {
namespace {

MissedDeadline missed(double processor_s) {
  return {.utime = 7, .period_s = 0.05, .took_s = 0.06, .processor_s = processor_s};
}

class JournalOfMisses : public testing::Test {
 protected:
  std::unique_ptr<JournalRing> ring_ = std::make_unique<JournalRing>();
  Journal journal_{*ring_};
  MissedDeadlines missed_;
  JournalRecord record_;
};

TEST_F(JournalOfMisses, NoneIsNoLine) {
  journal_.follow(missed_, 100.0);
  journal_.note(missed_);
  EXPECT_FALSE(ring_->pop(record_));
}

TEST_F(JournalOfMisses, TheFirstIsToldAtOnce) {
  missed_.note(missed(0.02));
  journal_.follow(missed_, 100.0);
  ASSERT_TRUE(ring_->pop(record_));
  EXPECT_EQ(record_.kind, JournalRecord::Kind::kMissed);
  EXPECT_EQ(record_.num_missed, 1);
  EXPECT_EQ(record_.utime, 7);
  EXPECT_DOUBLE_EQ(record_.missed.took_s, 0.06);
}

TEST_F(JournalOfMisses, ThoseOfTheNextTenSecondsAreOneLineOfTheOneThatHadMostOfTheProcessor) {
  missed_.note(missed(0.02));
  journal_.follow(missed_, 100.0);
  ASSERT_TRUE(ring_->pop(record_));
  missed_.note(missed(0.03));
  missed_.note(missed(0.055));
  missed_.note(missed(0.04));
  journal_.follow(missed_, 109.9);
  EXPECT_FALSE(ring_->pop(record_));
  journal_.follow(missed_, 110.1);
  ASSERT_TRUE(ring_->pop(record_));
  EXPECT_EQ(record_.num_missed, 3);
  EXPECT_DOUBLE_EQ(record_.missed.processor_s, 0.055);
  journal_.follow(missed_, 130.0);
  EXPECT_FALSE(ring_->pop(record_)) << "told twice";
}

TEST_F(JournalOfMisses, WhatIsUntoldAtTheEndIsTold) {
  missed_.note(missed(0.02));
  journal_.follow(missed_, 100.0);
  missed_.note(missed(0.03));
  journal_.note(missed_);
  ASSERT_TRUE(ring_->pop(record_));
  ASSERT_TRUE(ring_->pop(record_));
  EXPECT_DOUBLE_EQ(record_.missed.processor_s, 0.03);
}

}  // namespace
}  // namespace quickstrip::test
