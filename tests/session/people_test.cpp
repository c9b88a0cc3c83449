// Motion sickness and interruptions on the way from a profile to the bus.
#include <gtest/gtest.h>

#include "msgs/files/limits_file.hpp"
#include "quickstrip/outlook_t.hpp"
#include "tests/session/session_fixture.hpp"

namespace quickstrip::test {
namespace {

std::size_t index_of(const limits_t& limits, Quantity quantity) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(limits.num_criteria); ++i) {
    if (limits.quantity[i] == static_cast<std::int8_t>(quantity)) {
      return i;
    }
  }
  ADD_FAILURE();
  return 0;
}

TEST(People, AreWatchedFromTheProfileToEveryMessage) {
  const auto at = bridge_at_sea();
  LimitsProfile profile;
  ASSERT_EQ(read_limits_file(QUICKSTRIP_SOURCE_DIR "/firmware/profiles/naval_transit.limits.toml", at->hull,
                             profile)
                .line(),
            "");
  ASSERT_TRUE(at->session.configure(at->hull, profile.criteria, {}).ok());
  ASSERT_TRUE(at->session.accept(swell(kStart, 7.0, 300.0), kStart).ok());
  ASSERT_TRUE(at->session.accept(ship(kStart, 0.0, 15.0), kStart).ok());
  at->cycle(kStart);

  const auto limits = at->outbox.decoded<limits_t>(OutChannel::kLimits);
  const std::size_t sick = index_of(limits, Quantity::kMotionSickness);
  const std::size_t tips = index_of(limits, Quantity::kMotionInterruptions);
  EXPECT_EQ(limits.unit[sick], std::int8_t{limits_t::UNIT_SHARE_OF_PEOPLE});
  EXPECT_EQ(limits.statistic[sick], std::int8_t{limits_t::STATISTIC_SHARE_OF_PEOPLE});
  EXPECT_EQ(limits.unit[tips], std::int8_t{limits_t::UNIT_PER_MINUTE});
  EXPECT_EQ(limits.statistic[tips], std::int8_t{limits_t::STATISTIC_PER_MINUTE});
  EXPECT_EQ(get_text(limits.place_name[tips]), "bridge");
  EXPECT_EQ(limits.watched[tips], 1);

  const advice_t& advice = at->session.advice();
  EXPECT_GT(advice.criterion_value[sick], 0.01);
  EXPECT_LT(advice.criterion_value[sick], 1.0);
  EXPECT_GT(advice.criterion_value[tips], 0.0);

  const auto response = at->outbox.decoded<response_t>(OutChannel::kResponse);
  double per_hour = 0.0;
  int num_sides = 0;
  for (int i = 0; i < response.num_quantities; ++i) {
    if (response.quantity[i] == static_cast<std::int8_t>(Quantity::kMotionInterruptions)) {
      per_hour += response.per_hour[i];
      ++num_sides;
      EXPECT_EQ(response.criterion[i], static_cast<std::int16_t>(tips));
      EXPECT_EQ(response.unit[i], std::int8_t{response_t::UNIT_M_S2});
    }
  }
  EXPECT_EQ(num_sides, 2);
  EXPECT_NEAR(per_hour / 60.0 / advice.criterion_value[tips], 1.0, 1e-6);  // single precision in a cell

  const auto outlook = at->outbox.decoded<outlook_t>(OutChannel::kOutlook);
  EXPECT_NEAR(outlook.expected_max[tips], per_hour * outlook.expect_s / 3600.0, 1e-9 * per_hour);
  EXPECT_EQ(outlook.expected_max[sick], -1.0);
}

}  // namespace
}  // namespace quickstrip::test
