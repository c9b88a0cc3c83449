#include "msgs/convert/advice_message.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "msgs/convert/digest.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/limits_message.hpp"
#include "msgs/convert/quantise.hpp"
#include "msgs/convert/response_message.hpp"
#include "msgs/convert/units.hpp"
#include "quickstrip/wave_spectrum_t.hpp"
#include "tests/msgs/outgoing_samples.hpp"

namespace quickstrip {
namespace {

using test::s175;
using test::slamming_advice;
using test::slamming_cell;
using test::small_grid;
using test::some_context;
using test::some_criteria;

template <typename Field>
std::string text_of(const Field& field) {
  return std::string(get_text(field));
}

std::string no_advice(NoAdvice reason, const NoAdviceDetail& detail) {
  Sentence out;
  add_no_advice(reason, detail, out);
  return std::string(out.view());
}

TEST(AdviceText, SaysWhatGovernsItsLimitAndWhatToDo) {
  Sentence out;
  add_reasons(slamming_advice(), some_criteria(), {}, out);
  EXPECT_EQ(
      out.view(),
      "Slamming at bow 4.1 % of encounters (38/h), limit 2.2 %; waves would have to fall by 20 %: reduce to "
      "12 kn, or come 20° to port");
}

TEST(AdviceText, NoAdviceSaysWhy) {
  NoAdviceDetail detail;
  detail.age_s = 2.0 * 3600.0 + 10.0 * 60.0 + 5.0;
  detail.limit_s = 90.0 * 60.0;
  EXPECT_EQ(no_advice(NoAdvice::kSeaStale, detail),
            "No advice, because the sea state is 2 h 10 min old (limit 90 min)");
  EXPECT_EQ(no_advice(NoAdvice::kOwnShipMissing, {}),
            "No advice, because the ship's heading and speed have not been received");
  EXPECT_EQ(no_advice(NoAdvice::kSeaImplausible, {.refusal = Refusal::kHeight, .field = "hs_m"}),
            "No advice, because the sea state was refused: the wave height is not between 0 and 30 m (hs_m)");
  EXPECT_EQ(no_advice(NoAdvice::kSpeedOutsideGrid,
                      {.speed = from_knots(26.5), .grid_from = 0.0, .grid_to = from_knots(24.0)}),
            "No advice, because the speed 26.5 kn is outside the grid (0 to 24 kn)");
  for (int reason = 0; reason <= static_cast<int>(NoAdvice::kSelfTestFailed); ++reason) {
    EXPECT_EQ(no_advice(static_cast<NoAdvice>(reason), {}).rfind("No advice, because ", 0), 0u);
  }
}

TEST(AdviceText, DurationsAreWordedByTheirSize) {
  const std::pair<double, const char*> cases[] = {
      {0.0, "0 s"},       {12.9, "12 s"},        {119.0, "119 s"},       {120.0, "2 min"},
      {5400.0, "90 min"}, {7200.0, "2 h"},       {7860.0, "2 h 11 min"}, {86'400.0, "24 h"},
      {172'800.0, "2 d"}, {180'000.0, "2 d 2 h"}};
  for (const auto& [seconds, words] : cases) {
    Sentence out;
    add_duration(seconds, out);
    EXPECT_EQ(out.view(), words);
  }
}

TEST(AdviceText, GoodStillNamesTheNearestLimit) {
  Advice advice = slamming_advice();
  advice.present.verdict = Verdict::kGood;
  advice.present.governing = 0;
  advice.present.margin = 2.0F;
  advice.change_needed = false;
  advice.changes.clear();
  Sentence out;
  add_reasons(advice, some_criteria(), {}, out);
  EXPECT_EQ(out.view(),
            "All limits kept; nearest: roll 3.0° RMS, limit 6.0°, reached in waves 2.0 times as high");
}

TEST(AdviceText, WhenNothingHelpsItSaysSo) {
  Advice advice = slamming_advice();
  advice.changes.clear();
  advice.no_change_helps = true;
  Sentence out;
  add_reasons(advice, some_criteria(), {}, out);
  EXPECT_NE(out.view().find(": no other course or speed is better"), std::string_view::npos);
}

TEST(AdviceText, PeopleAreCountedInTheirOwnWords) {
  const auto words = [](const Criterion& criterion, double value) {
    Sentence out;
    add_criterion(criterion, value, Cell{}, out);
    return std::string(out.view());
  };
  Criterion sick{.name = Name("motion sickness at saloon"),
                 .quantity = Quantity::kMotionSickness,
                 .statistic = Statistic::kShareOfPeople,
                 .limit = 0.1};
  EXPECT_EQ(words(sick, 0.137), "motion sickness at saloon 14 % of people sick in 2 h, limit 10 % of people");
  sick.exposure = 4.0 * 3600.0;
  EXPECT_EQ(words(sick, 0.001),
            "motion sickness at saloon 0.1 % of people sick in 4 h, limit 10 % of people");
  EXPECT_EQ(words({.name = Name("interruptions at hatch"),
                   .quantity = Quantity::kMotionInterruptions,
                   .statistic = Statistic::kPerMinute,
                   .limit = 1.0},
                  1.234),
            "interruptions at hatch 1.23/min, limit 1.00/min");
}

TEST(AdviceText, WhatIsNotWatchedIsNeverCalledGood) {
  Advice advice = slamming_advice();
  advice.present.verdict = Verdict::kUnknown;
  advice.change_needed = false;
  Sentence out;
  add_reasons(advice, some_criteria(), {}, out);
  EXPECT_EQ(out.view().rfind("Not judged: the hull file gives no place for \"lateral acceleration\"", 0), 0u);
}

TEST(AdviceText, SideOfTheTurnFollowsItsSign) {
  Change change;
  change.heading_change = radians(15.0);
  Sentence starboard;
  add_action(change, starboard);
  EXPECT_EQ(starboard.view(), "come 15° to starboard");
  change.heading_change = radians(-15.0);
  change.speed = from_knots(14.0);
  change.speed_change = from_knots(2.0);
  Sentence port;
  add_action(change, port);
  EXPECT_EQ(port.view(), "come 15° to port and increase to 14 kn");
}

TEST(AdviceText, LongTextIsCutBetweenCharacters) {
  std::uint8_t field[6];
  put_text("20°°°", field);  // 2 + 3 x 2 bytes: one degree sign fits before the final NUL
  EXPECT_EQ(get_text(field), "20°");
  EXPECT_EQ(field[4], 0);
  EXPECT_EQ(field[5], 0);
}

TEST(AdviceMessage, CarriesFiguresInUnitsOfTheBridge) {
  auto m = std::make_unique<advice_t>();
  to_message(slamming_advice(), small_grid(), some_criteria(), some_context(), *m);
  EXPECT_EQ(m->no_advice, 0);
  EXPECT_EQ(m->verdict, +advice_t::VERDICT_EXCEEDED);
  EXPECT_NEAR(m->heading_deg, 250.0, 1e-10);
  EXPECT_NEAR(m->speed_kn, 18.0, 1e-12);
  EXPECT_EQ(text_of(m->governing_name), "slamming at bow");
  EXPECT_NEAR(m->governing_value, 0.041, 1e-7);  // float in core
  EXPECT_EQ(m->governing_limit, 0.022);
  EXPECT_EQ(m->num_criteria, 4);
  EXPECT_NEAR(m->criterion_value[0], 3.0, 1e-6);  // degrees; float in core
  EXPECT_EQ(m->criterion_value[3], -1.0);         // not watched
  EXPECT_EQ(m->bridge_vertical_rms_m_s2, -1.0);   // not computed stays so, also in degrees and knots
  EXPECT_EQ(m->num_changes, 2);
  EXPECT_NEAR(m->change_speed_kn[0], -6.0, 1e-12);
  EXPECT_NEAR(m->change_heading_deg[1], -20.0, 1e-12);
  EXPECT_NEAR(m->change_slam_probability[0], 0.011, 1e-7);
  EXPECT_EQ(m->input_seq[advice_t::INPUT_SEA_STATE], 77);
  EXPECT_EQ(m->input_use[advice_t::INPUT_LOADING], +advice_t::USE_NONE);
  EXPECT_EQ(text_of(m->change_text[0]),
            "Reduce to 12 kn: good; slamming at bow 1.1 %, limit 2.2 %, reached if waves grow 30 %");
  EXPECT_EQ(text_of(m->change_text[1]).rfind("Come 20° to port (course 230°): near a limit", 0), 0u);
}

TEST(AdviceMessage, WithoutAdviceNothingLooksLikeAFigure) {
  Advice advice = slamming_advice();
  advice.no_advice = NoAdvice::kSeaMissing;
  auto m = std::make_unique<advice_t>();
  to_message(advice, small_grid(), some_criteria(), some_context(), *m);
  EXPECT_EQ(m->no_advice, 2);
  EXPECT_EQ(text_of(m->no_advice_text), "No advice, because the sea state has not been received");
  EXPECT_EQ(m->verdict, +advice_t::VERDICT_UNKNOWN);
  EXPECT_EQ(m->governing, -1);
  EXPECT_EQ(m->margin, -1.0);
  EXPECT_EQ(m->roll_rms_deg, -1.0);
  EXPECT_EQ(m->criterion_value[0], -1.0);
  EXPECT_EQ(m->num_changes, 0);
  EXPECT_EQ(text_of(m->reasons_text), "");
}

TEST(AdviceMessage, DigestTellsEqualFromDifferentAdvice) {
  auto a = std::make_unique<advice_t>();
  auto b = std::make_unique<advice_t>();
  std::uint8_t scratch[8000];
  to_message(slamming_advice(), small_grid(), some_criteria(), some_context(), *a);
  *b = *a;
  b->digest = 5;  // whatever stood there before
  ASSERT_TRUE(seal(*a, scratch));
  ASSERT_TRUE(seal(*b, scratch));
  EXPECT_EQ(a->digest, b->digest);
  b->margin = std::nextafter(b->margin, 9.0);
  ASSERT_TRUE(seal(*b, scratch));
  EXPECT_NE(a->digest, b->digest);
  EXPECT_FALSE(seal(*b, std::span<std::uint8_t>(scratch, 100)));
}

TEST(Digest, IsFnv1aOfThePublishedVectors) {  // Fowler, Noll, Vo: test vectors of the 64-bit FNV-1a
  Fnv1a empty;
  EXPECT_EQ(empty.value(), 0xCBF29CE484222325u);
  Fnv1a a;
  a.add(std::string_view("a"));
  EXPECT_EQ(a.value(), 0xAF63DC4C8601EC8Cu);
  Fnv1a foobar;
  foobar.add(std::string_view("foobar"));
  EXPECT_EQ(foobar.value(), 0x85944171F73967E8u);
}

TEST(Quantise, ErrorIsAtMostHalfAStepAndItSaturates) {
  for (double value = 0.0; value < 1.0; value += 0.000317) {
    const double back = kProbabilityStep * quantised<std::int16_t>(value, kProbabilityStep);
    EXPECT_LE(std::abs(back - value), 0.5 * kProbabilityStep * (1.0 + 1e-9));
  }
  EXPECT_EQ(quantised<std::int16_t>(1.0e9, kPerHourStep), 32767);
  EXPECT_EQ(quantised<std::int16_t>(std::numeric_limits<double>::infinity(), kPerHourStep), 32767);
  EXPECT_EQ(quantised<std::int8_t>(12.75, kSpeedLossStep_kn), 127);
  EXPECT_EQ(quantised<std::int16_t>(-1.0, kPerHourStep), -1);
  EXPECT_EQ(quantised<std::int16_t>(std::numeric_limits<double>::quiet_NaN(), kPerHourStep), -1);
}

TEST(GridMessage, CellsKeepTheirFiguresWithinHalfAStep) {
  auto m = std::make_unique<grid_t>();
  Grid& grid = small_grid();
  Cell& cell = grid.cells[1][7];
  cell.rms_roll = static_cast<float>(radians(7.1234));
  cell.rms_bridge_vertical = 1.23456F;
  cell.roll_exceedance = 0.0123F;
  cell.wetness_probability = 0.0777F;
  cell.margin = 1.2345F;
  to_message(grid, 99, *m);
  EXPECT_EQ(m->num_speeds, 2);
  EXPECT_EQ(m->num_headings, 72);
  EXPECT_NEAR(m->speed_kn[1], 18.0F, 1e-5F);
  EXPECT_NEAR(kRollStep_deg * m->roll_rms[1][7], 7.1234, 0.5 * kRollStep_deg + 1e-6);
  EXPECT_NEAR(kAccelerationStep_m_s2 * m->bridge_vertical_rms[1][7], 1.23456, 0.5 * kAccelerationStep_m_s2);
  EXPECT_NEAR(kProbabilityStep * m->roll_exceedance[1][7], 0.0123, 0.5 * kProbabilityStep);
  EXPECT_NEAR(kProbabilityStep * m->wetness_probability[1][7], 0.0777, 0.5 * kProbabilityStep);
  EXPECT_NEAR(kMarginStep * m->margin[1][7], 1.2345, 0.5 * kMarginStep);
  EXPECT_NEAR(kPerHourStep * m->slams_per_hour[1][7], 38.2, 0.5 * kPerHourStep);
  EXPECT_EQ(m->governing[1][7], 1);
}

TEST(GridMessage, UnboundedMarginAndWhatIsNotComputedAreSaid) {
  auto m = std::make_unique<grid_t>();
  Grid& grid = small_grid();
  grid.cells[0][0] = Cell{};
  grid.cells[0][1].margin = kMarginUnbounded;
  grid.cells[0][2].margin = 1.0e6F;
  to_message(grid, 0, *m);
  EXPECT_EQ(m->margin[0][0], -1);
  EXPECT_EQ(m->governing[0][0], -1);
  EXPECT_EQ(m->slam_probability[0][0], -1);
  EXPECT_EQ(m->bridge_vertical_rms[0][0], -1);
  EXPECT_EQ(m->margin[0][1], 9900);
  EXPECT_EQ(m->margin[0][2], 9900);
  EXPECT_EQ(m->verdict[24][71], +grid_t::VERDICT_UNKNOWN);  // beyond the grid
  EXPECT_EQ(m->roll_rms[24][71], -1);
  EXPECT_EQ(m->speed_loss[0][5], -1);
}

TEST(LimitsMessage, NamesPlacesAndUnits) {
  auto m = std::make_unique<limits_t>();
  m->utime = 5;
  to_message(some_criteria(), s175(), "ours", *m);
  EXPECT_EQ(m->utime, 5);
  EXPECT_EQ(m->num_criteria, 4);
  EXPECT_NEAR(m->limit[0], 6.0, 1e-14);
  EXPECT_EQ(m->unit[0], +limits_t::UNIT_DEG);
  EXPECT_EQ(text_of(m->place_name[0]), "G");
  EXPECT_EQ(m->unit[1], +limits_t::UNIT_PROBABILITY);
  EXPECT_EQ(text_of(m->place_name[1]), "bow");
  EXPECT_EQ(text_of(m->place_name[2]), "bridge");
  EXPECT_EQ(m->place[3], -1);
  EXPECT_EQ(m->watched[3], 0);
  EXPECT_EQ(text_of(m->profile_name), "ours");
}

TEST(LimitsMessage, DigestIsOfTheLimitsNotOfTheTime) {
  auto a = std::make_unique<limits_t>();
  auto b = std::make_unique<limits_t>();
  b->utime = 5;
  b->seq = 3;
  Criteria criteria = some_criteria();
  to_message(criteria, s175(), "ours", *a);
  to_message(criteria, s175(), "ours", *b);
  EXPECT_EQ(a->digest, b->digest);
  criteria[0].limit *= 1.01;
  to_message(criteria, s175(), "ours", *b);
  EXPECT_NE(a->digest, b->digest);
}

TEST(ResponseMessage, QuantitiesCarryPlaceUnitAndCriterion) {
  static CellResponse response;
  response.heading = {radians(90.0)};
  response.speed = from_knots(12.0);
  response.num_systems = 2;
  response.cell = slamming_cell();
  QuantityResponse roll;
  roll.quantity = Quantity::kRoll;
  roll.rms = radians(2.0);
  roll.significant = radians(4.0);
  roll.variance = {3.0, 1.0};
  QuantityResponse slamming;
  slamming.quantity = Quantity::kSlamming;
  slamming.rms = 2.5;
  slamming.probability = 0.041;
  ASSERT_TRUE(response.quantities.push_back(roll));
  ASSERT_TRUE(response.quantities.push_back(slamming));
  auto m = std::make_unique<response_t>();
  m->query_id = 42;
  to_message(response, s175(), some_criteria(), 1, *m);
  EXPECT_EQ(m->query_id, 42);
  EXPECT_EQ(m->num_quantities, 2);
  EXPECT_NEAR(m->rms[0], 2.0, 1e-14);
  EXPECT_NEAR(m->significant[0], 4.0, 1e-14);
  EXPECT_EQ(m->probability[0], -1.0);
  EXPECT_EQ(m->place[0], -1);
  EXPECT_FLOAT_EQ(m->system_share[0][0], 0.75F);
  EXPECT_EQ(m->criterion[0], 0);
  EXPECT_EQ(m->unit[1], +response_t::UNIT_M);
  EXPECT_EQ(m->place[1], 0);
  EXPECT_EQ(text_of(m->place_name[1]), "bow");
  EXPECT_EQ(m->criterion[1], 1);
}

TEST(ResponseMessage, AQueryThatCannotBeAnsweredIsEchoedWithTheReason) {
  query_t asked{};
  asked.utime = 1;
  asked.query_id = 9;
  asked.source_id = 4;
  asked.heading_deg = 45.0;
  asked.speed_kn = 30.0;
  Query query;
  ASSERT_TRUE(to_query(asked, query).ok());
  auto m = std::make_unique<response_t>();
  m->seq = 3;
  to_refusal(query, Refusal::kSpeedOutsideGrid, *m);
  EXPECT_EQ(m->seq, 3);
  EXPECT_EQ(m->query_id, 9);
  EXPECT_EQ(m->query_source_id, 4);
  EXPECT_EQ(m->refusal, 14);
  EXPECT_NEAR(m->heading_deg, 45.0, 1e-12);
  EXPECT_NEAR(m->speed_kn, 30.0, 1e-12);
  EXPECT_EQ(m->num_quantities, 0);
  asked.query_id = 0;
  EXPECT_EQ(to_query(asked, query).refusal, Refusal::kOutOfRange);
  asked.query_id = 1;
  asked.speed_kn = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_query(asked, query).refusal, Refusal::kNotFinite);
}

TEST(Messages, OutgoingOnesSurviveTheWire) {
  static std::uint8_t bytes[kMaxMessageBytes];
  auto sent = std::make_unique<grid_t>();
  auto received = std::make_unique<grid_t>();
  to_message(small_grid(), 7, *sent);
  ASSERT_TRUE(decode(encode(*sent, bytes), *received));
  EXPECT_EQ(received->slams_per_hour[0][50], 94);
  EXPECT_EQ(received->limits_digest, 7);
}

}  // namespace
}  // namespace quickstrip
