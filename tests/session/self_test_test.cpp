#include "firmware/session/self_test.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <memory>

#include "firmware/session/allow_list.hpp"

namespace quickstrip::test {
namespace {

// When the core's physics changes for good, this fails first: work the numbers out anew, in self_test.cpp.
TEST(SelfTest, TheKnownShipComesOutAsWrittenDown) {
  const auto advisor = std::make_unique<Advisor>();
  const auto barge = std::make_unique<Hull>();
  const double error = known_answer_error(*advisor, *barge);
  std::printf("known answer: within %.2g of what is written down\n", error);
  EXPECT_LT(error, 1e-4);  // a tenth of what the self-test allows
  EXPECT_EQ(run_self_test(*advisor, *barge, nullptr), SelfTestItem::kNone);
}

TEST(SelfTest, AnotherRoundingOfTheProcessorIsFound) {
  EXPECT_TRUE(computes_as_ieee754());
  for (const int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(rounding), 0);
    const bool is_sound = computes_as_ieee754();
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(is_sound) << rounding;
  }
}

TEST(SelfTest, AShipThatComesOutOtherwiseIsFound) {
  // The same ship with her centre of gravity a hand's breadth higher is no longer the known one.
  const auto advisor = std::make_unique<Advisor>();
  const auto barge = std::make_unique<Hull>();
  make_known_ship(*barge);
  EXPECT_LT(barge->loading.kg, 7.0);
  EXPECT_LT(known_answer_error(*advisor, *barge), 1e-3);
  for (const SelfTestItem item : {SelfTestItem::kSectionTable, SelfTestItem::kHullTable,
                                  SelfTestItem::kFloatingPoint, SelfTestItem::kKnownAnswer}) {
    EXPECT_STRNE(message(item), message(SelfTestItem::kNone));
  }
}

TEST(AllowList, WithoutAnyEverybodyIsAdmitted) {
  const AllowList list;
  EXPECT_TRUE(list.admits(Input::kSeaState, 0));
  EXPECT_TRUE(list.admits(Input::kTime, -7));
}

TEST(AllowList, ReadsAChannelAndItsSources) {
  AllowList list;
  ASSERT_TRUE(list.read("SEA_STATE=3,-4"));
  ASSERT_TRUE(list.read("SEA_STATE=7"));
  EXPECT_TRUE(list.admits(Input::kSeaState, 3));
  EXPECT_TRUE(list.admits(Input::kSeaState, -4));
  EXPECT_TRUE(list.admits(Input::kSeaState, 7));
  EXPECT_FALSE(list.admits(Input::kSeaState, 5));
  EXPECT_TRUE(list.admits(Input::kOwnShip, 5));  // another input is another matter
}

TEST(AllowList, RefusesWhatItCannotReadAndStaysAsItWas) {
  AllowList list;
  ASSERT_TRUE(list.read("OWN_SHIP=1"));
  for (const char* const text :
       {"", "=", "OWN_SHIP", "OWN_SHIP=", "OWN_SHIP=2,", "OWN_SHIP=2 3", "OWN_SHIP=x", "QS_OWN_SHIP=2",
        "ADVICE=2", "OWN_SHIP=40000", "OWN_SHIP=2,3,4,5,6,7,8,9"}) {
    EXPECT_FALSE(list.read(text)) << text;
  }
  EXPECT_TRUE(list.admits(Input::kOwnShip, 1));
  EXPECT_FALSE(list.admits(Input::kOwnShip, 2));
}

}  // namespace
}  // namespace quickstrip::test
