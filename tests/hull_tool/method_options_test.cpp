#include "msgs/cli/method_options.hpp"

#include <gtest/gtest.h>

namespace quickstrip::hull_tool {
namespace {

StripMethod parse(const std::string& arguments) {
  CLI::App app;
  MethodOptions options;
  add_method_options(app, options);
  app.parse(arguments);
  return options.method();
}

bool same(const StripMethod& a, const StripMethod& b) {
  return a.variant == b.variant && a.end_terms == b.end_terms && a.loads == b.loads && a.surge == b.surge &&
         a.low_encounter == b.low_encounter && a.contour == b.contour && a.swell_up == b.swell_up;
}

TEST(MethodOptions, FirstOfEachIsTheDefault) {
  EXPECT_TRUE(same(parse(""), StripMethod{}));
  EXPECT_TRUE(same(parse("--method ordinary --end-terms on --loads haskind --surge full --low-encounter "
                         "floor --swell-up onboard"),
                   StripMethod{}));
}

TEST(MethodOptions, SecondOfEachChangesThatChoiceAlone) {
  StripMethod expected;
  expected.variant = StripVariant::kModified;
  EXPECT_TRUE(same(parse("--method modified"), expected));
  expected = {};
  expected.end_terms = false;
  EXPECT_TRUE(same(parse("--end-terms off"), expected));
  expected = {};
  expected.loads = DiffractionLoads::kClassic;
  EXPECT_TRUE(same(parse("--loads classic"), expected));
  expected = {};
  expected.surge = SurgeTerms::kInertiaOnly;
  EXPECT_TRUE(same(parse("--surge inertia-only"), expected));
  expected = {};
  expected.low_encounter = LowEncounterRule::kPaper;
  EXPECT_TRUE(same(parse("--low-encounter paper"), expected));
  expected = {};
  expected.swell_up = SwellUp::kOff;
  EXPECT_TRUE(same(parse("--swell-up off"), expected));
}

TEST(MethodOptions, PaperIsOrdinaryEndTermsClassicPaperAndTakesAChoiceBesideIt) {
  EXPECT_TRUE(same(parse("--paper"), kPaperMethod));
  StripMethod expected = kPaperMethod;
  expected.surge = SurgeTerms::kInertiaOnly;
  EXPECT_TRUE(same(parse("--surge inertia-only --paper"), expected));
  expected = kPaperMethod;
  EXPECT_EQ(expected.swell_up, SwellUp::kOff);
  expected.swell_up = SwellUp::kOnboard;
  EXPECT_TRUE(same(parse("--paper --swell-up onboard"), expected));
}

TEST(MethodOptions, ATableBringsLoadsByBoundaryValuesUnlessOthersAreNamed) {
  EXPECT_EQ(parse("--table a.qst").loads, DiffractionLoads::kBoundaryValue);
  EXPECT_EQ(parse("--table a.qst --loads haskind").loads, DiffractionLoads::kHaskind);
  EXPECT_EQ(parse("--table a.qst --paper").loads, DiffractionLoads::kClassic);
  EXPECT_EQ(parse("--loads boundary-value").loads, DiffractionLoads::kBoundaryValue);
}

TEST(MethodOptions, OtherWordsAreWrongUse) {
  EXPECT_THROW(parse("--method strip"), CLI::ParseError);
  EXPECT_THROW(parse("--end-terms yes"), CLI::ParseError);
  EXPECT_THROW(parse("--swell-up 1.15"), CLI::ParseError);
}

}  // namespace
}  // namespace quickstrip::hull_tool
