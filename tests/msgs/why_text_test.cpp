// Why, what to do and what the turn brings, in the words of the bridge.
#include "msgs/convert/why_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "msgs/convert/advice_text.hpp"
#include "msgs/convert/units.hpp"
#include "tests/msgs/outgoing_samples.hpp"

namespace quickstrip {
namespace {

using test::slamming_advice;
using test::slamming_cell;
using test::some_criteria;

const std::array<WaveSystem, 2> kSystems{
    {{.hs = 3.0, .period = 12.0, .from = {radians(240.0)}, .spreading = 0.4},
     {.hs = 3.0, .period = 7.0, .from = {radians(30.0)}, .spreading = 0.4}}};

std::string margin_words(double margin) {
  Sentence out;
  add_margin(margin, out);
  return std::string(out.view());
}

TEST(WhyText, AMarginIsSaidAsTheGrowthOfTheWaves) {
  EXPECT_EQ(margin_words(1.15), "reached if waves grow 15 %");
  EXPECT_EQ(margin_words(1.159), "reached if waves grow 15 %");  // never more room than there is
  EXPECT_EQ(margin_words(0.8), "waves would have to fall by 20 %");
  EXPECT_EQ(margin_words(0.809), "waves would have to fall by 20 %");  // never less to do than there is
  EXPECT_EQ(margin_words(1.0), "at the limit");
  EXPECT_EQ(margin_words(1.005), "at the limit");
  EXPECT_EQ(margin_words(2.56), "reached in waves 2.5 times as high");
  EXPECT_EQ(margin_words(99.0), "");
}

TEST(WhyText, ASystemIsSwellWhenTheWindThatRaisesItCannotBeBlowing) {
  // 2 pi Hs / (g Tp^2): 3 m of 12 s 0.0133, 3 m of 7 s 0.039; a fully developed sea has 0.0256 at any wind.
  Sentence swell;
  add_system(kSystems[0], swell);
  EXPECT_EQ(swell.view(), "swell of 12 s from 240°");
  Sentence sea;
  add_system(kSystems[1], sea);
  EXPECT_EQ(sea.view(), "wind sea of 7 s from 030°");
}

TEST(WhyText, TheReasonNamesCriterionLimitMarginAndTheSystemThatCausesIt) {
  Sentence out;
  add_why(slamming_cell(), some_criteria(), kSystems, out);
  EXPECT_EQ(
      out.view(),
      "Slamming at bow 4.1 % of encounters (38/h), limit 2.2 %; waves would have to fall by 20 %; mostly "
      "swell of 12 s from 240°");
}

TEST(WhyText, AZoneThatDecidesAloneIsNamedFirst) {
  Cell cell = slamming_cell();
  cell.verdict = Verdict::kExceeded;
  cell.margin = 1.4F;
  cell.values[1] = 0.006F;
  cell.hazards = kHazardParametricRoll | kHazardParametricRollGrows;
  Sentence out;
  add_why(cell, some_criteria(), {}, out);
  EXPECT_EQ(out.view().rfind("Parametric roll can grow", 0), 0u);
  EXPECT_NE(out.view().find("; motions: slamming at bow"), std::string_view::npos);
  Sentence notes;
  add_notes(cell, notes);
  EXPECT_EQ(notes.view().find("arametric"), std::string_view::npos);  // said already
  cell.margin = 0.8F;                                                 // both
  Sentence both;
  add_why(cell, some_criteria(), {}, both);
  EXPECT_EQ(both.view().rfind("Slamming at bow", 0), 0u);
  add_notes(cell, notes);
  EXPECT_NE(notes.view().find(". Parametric roll can grow"), std::string_view::npos);
}

TEST(WhyText, AQueryIsExplainedWithWhatComesNext) {
  Cell cell = slamming_cell();
  cell.next = 0;
  cell.next_margin_steps = 800;  // 1.6
  Sentence out;
  explain(cell, some_criteria(), kSystems, out);
  EXPECT_NE(out.view().find(". Next: roll, reached if waves grow 60 %"), std::string_view::npos);
}

TEST(WhyText, WhileBetterWaitsTheSentenceSaysWhatIsAndHowLong) {
  Advice advice = slamming_advice();
  advice.verdict_now = Verdict::kGood;
  advice.present.margin = 1.3F;
  advice.present.values[1] = 0.01F;
  advice.better_in = 720.0;
  Sentence out;
  add_reasons(advice, some_criteria(), {}, out);
  EXPECT_EQ(out.view().rfind("All limits kept; nearest: slamming", 0), 0u);
  EXPECT_NE(out.view().find(". Better only lately: 12 min until it counts"), std::string_view::npos);
}

class TurnText : public testing::Test {
 protected:
  TurnText() {
    change_.heading = radians(20.0);
    change_.heading_change = radians(-70.0);
    change_.margin = 1.4F;
    change_.turn = {.is_known = true,
                    .worst_verdict = Verdict::kExceeded,
                    .worst_governing = 0,
                    .worst_system = 0,
                    .worst_margin = 0.5F,
                    .worst_heading = static_cast<float>(radians(330.0)),
                    .time = 140.0F,
                    .time_exceeded = 60.0F,
                    .max_roll = static_cast<float>(radians(17.8))};
    present_.margin = 0.9F;
    present_.verdict = Verdict::kExceeded;
  }
  std::string words() {
    Sentence out;
    add_turn(change_, present_, some_criteria(), kSystems, out);
    return std::string(out.view());
  }
  Change change_;
  Cell present_;
};

TEST_F(TurnText, SaysWhatItPassesHowLongAndHowFarSheMayRoll) {
  EXPECT_EQ(words(),
            "Coming to 020° passes 330° beam-on: 18° roll likely, 60 s above a limit, takes 2 min; there "
            "roll, waves "
            "would have to fall by 50 %");
}

TEST_F(TurnText, SaysNothingWhenTheWayIsNoWorseAndHardlyRolls) {
  change_.turn.worst_margin = 0.9F;  // where it began
  change_.turn.max_roll = static_cast<float>(radians(4.0));
  EXPECT_EQ(words(), "");
  change_.turn.max_roll = static_cast<float>(radians(9.0));
  EXPECT_EQ(words(), "Coming to 020°: 9° roll likely, 60 s above a limit, takes 2 min");
  change_.turn = {};
  EXPECT_EQ(words(), "");
}

TEST_F(TurnText, TheLongerWayRoundIsSaidWithItsSide) {
  change_.heading_change = radians(200.0);
  Sentence action;
  add_action(change_, action);
  EXPECT_EQ(action.view(), "come 200° to starboard (the longer way)");
  EXPECT_NE(words().find("; the shorter way is worse"), std::string::npos);
}

TEST_F(TurnText, TheLongestSentenceFitsItsField) {
  // 160 bytes with the final NUL, in the words of the longest default names.
  change_.turn.worst_governing = 2;  // vertical acceleration at bridge
  change_.heading_change = radians(-170.0);
  EXPECT_LT(words().size(), 160u);
}

TEST(WhyText, NothingIsCutInTheMiddleOfAWord) {
  Advice advice = slamming_advice();
  advice.none_is_good = true;
  advice.present.governing = 2;
  advice.present.hazards =
      kHazardParametricRoll | kHazardParametricRollGrows | kHazardNoSteerage | kHazardMotions;
  advice.present.quality = kQualityExtremeMotion | kQualitySpeedOverGround | kQualityShallowWater;
  Sentence out;
  add_reasons(advice, some_criteria(), kSystems, out);
  EXPECT_LE(out.view().size(), 255u);
  EXPECT_NE(out.view().find(". Parametric roll can grow"), std::string_view::npos) << out.view();
  EXPECT_TRUE(out.view().ends_with("grow") || out.view().ends_with("ground") ||
              out.view().ends_with("computed"))
      << out.view();
  Change change = advice.changes[1];
  change.governing = change.next = 2;
  change.next_margin = 1.3F;
  change.speed_change = -from_knots(3.0);
  Sentence text;
  add_change(change, nullptr, some_criteria(), kSystems, text);
  EXPECT_LE(text.view().size(), 159u);
  EXPECT_TRUE(text.view().ends_with("%") || text.view().ends_with("°")) << text.view();
}

TEST(ChangeText, SaysWhatGovernsThereWhatCausesItAndWhatComesNext) {
  Advice advice = slamming_advice();
  Change change = advice.changes[1];
  change.governing = 1;
  change.governing_system = 0;
  change.next = 0;
  change.next_margin = 1.8F;
  change.kind = ChangeKind::kHeaveTo;
  Sentence out;
  add_change(change, nullptr, some_criteria(), std::span(kSystems).first(1), out);
  EXPECT_EQ(
      out.view(),
      "Heave to: come 20° to port (course 230°): near a limit; slamming at bow, reached if waves grow 10 %; "
      "swell of 12 s from 240°");
  change.kind = ChangeKind::kOther;  // leaves room for what comes next
  Sentence shorter;
  add_change(change, nullptr, some_criteria(), {}, shorter);
  EXPECT_EQ(
      shorter.view(),
      "Come 20° to port (course 230°): near a limit; slamming at bow, reached if waves grow 10 %; next roll, "
      "reached if waves grow 80 %");
}

}  // namespace
}  // namespace quickstrip
