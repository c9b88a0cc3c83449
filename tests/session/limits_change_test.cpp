// A change of limits is told with time and author, once, and on the bus.
#include <gtest/gtest.h>

#include "msgs/convert/limits_difference.hpp"
#include "msgs/convert/limits_message.hpp"
#include "quickstrip/logbook_t.hpp"
#include "tests/session/session_fixture.hpp"

namespace quickstrip::test {
namespace {

limits_t limits_of(const Criteria& criteria, const Hull& hull, std::string_view name) {
  limits_t limits{};
  to_message(criteria, hull, name, limits);
  return limits;
}

std::string difference(const limits_t& before, const limits_t& now) {
  Sentence out;
  add_limits_difference(before, now, out);
  return std::string(out.view());
}

class LimitsChange : public testing::Test {
 protected:
  LimitsChange() {
    EXPECT_TRUE(
        criteria_.push_back({.name = Name("roll"), .quantity = Quantity::kRoll, .limit = radians(6.0)}));
    EXPECT_TRUE(
        criteria_.push_back({.name = Name("pitch"), .quantity = Quantity::kPitch, .limit = radians(1.5)}));
  }
  Hull hull_;
  Criteria criteria_;
};

TEST_F(LimitsChange, NamesBothProfilesAndWhatIsDifferent) {
  const limits_t before = limits_of(criteria_, hull_, "cargo");
  EXPECT_EQ(before.digest, limits_of(criteria_, hull_, "cargo").digest);
  Criteria other = criteria_;
  other[0].limit = radians(4.0);
  other[1] = {.name = Name("heave"), .quantity = Quantity::kHeave, .limit = 2.0};
  const limits_t now = limits_of(other, hull_, "ours");
  EXPECT_NE(now.digest, before.digest);
  EXPECT_EQ(difference(before, now), "\"cargo\" -> \"ours\": roll 6 -> 4°; without pitch; new: heave");
  other = criteria_;
  other[1].caution_fraction = 0.5;
  EXPECT_EQ(difference(before, limits_of(other, hull_, "cargo")),
            "\"cargo\": pitch caution from 0.75 -> 0.5 of the limit");
  other = criteria_;
  other[0].statistic = Statistic::kSignificant;
  EXPECT_EQ(difference(before, limits_of(other, hull_, "cargo")), "\"cargo\": roll judged otherwise");
}

TEST_F(LimitsChange, OfExposureOrStanceAloneIsSeen) {
  Criteria sick = criteria_;
  ASSERT_TRUE(sick.push_back({.name = Name("sick"),
                              .quantity = Quantity::kMotionSickness,
                              .place = kNowhere,
                              .statistic = Statistic::kShareOfPeople,
                              .limit = 0.2}));
  const limits_t before = limits_of(sick, hull_, "cargo");
  sick[2].exposure = 4.0 * 3600.0;
  const limits_t now = limits_of(sick, hull_, "cargo");
  EXPECT_NE(now.digest, before.digest);
  EXPECT_EQ(difference(before, now),
            "\"cargo\": the same limits in another order, time of exposure or stance");
}

TEST(LimitsChangeOnTheBus, IsToldOnceWithTimeAuthorAndDigest) {
  const auto at = bridge();
  at->cycle(kStart);
  EXPECT_EQ(at->outbox.sent(OutChannel::kLogbook), 0);
  at->session.note_limits_change("C. Master", "\"cargo\" -> \"ours\"");
  at->cycle(kStart + kSecond);
  ASSERT_EQ(at->outbox.sent(OutChannel::kLogbook), 1);
  const auto entry = at->outbox.decoded<logbook_t>(OutChannel::kLogbook);
  EXPECT_EQ(entry.utime, kStart + kSecond);
  EXPECT_EQ(entry.kind, std::int8_t{logbook_t::KIND_LIMITS_CHANGED});
  EXPECT_EQ(get_text(entry.author), "C. Master");
  EXPECT_EQ(get_text(entry.text), "\"cargo\" -> \"ours\"");
  EXPECT_EQ(entry.digest, at->session.limits().digest);
  at->cycle(kStart + 2 * kSecond);
  EXPECT_EQ(at->outbox.sent(OutChannel::kLogbook), 1);
}

}  // namespace
}  // namespace quickstrip::test
