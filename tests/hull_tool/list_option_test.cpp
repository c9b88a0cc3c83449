#include "sim/hull_tool/list_option.hpp"

#include <gtest/gtest.h>

namespace quickstrip::hull_tool {
namespace {

using Values = std::vector<double>;

Values parse(std::string_view text) {
  return parse_list("--x", text, {-1000.0, 1000.0});
}

TEST(ListOption, TakesOneNumberOrSeveral) {
  EXPECT_EQ(parse("10"), (Values{10.0}));
  EXPECT_EQ(parse("0,5,-10.5"), (Values{0.0, 5.0, -10.5}));
  EXPECT_EQ(parse("1e2,+3"), (Values{100.0, 3.0}));
}

TEST(ListOption, TakesRangesWithBothEnds) {
  EXPECT_EQ(parse("0:10:5"), (Values{0.0, 5.0, 10.0}));
  EXPECT_EQ(parse("10:0:-5"), (Values{10.0, 5.0, 0.0}));
  EXPECT_EQ(parse("3:3:1"), (Values{3.0}));
  EXPECT_EQ(parse("7,0:10:5"), (Values{7.0, 0.0, 5.0, 10.0}));
}

TEST(ListOption, DecimalStepsReachTheEndOnce) {
  const Values values = parse("0.2:1.5:0.1");
  ASSERT_EQ(values.size(), 14U);
  EXPECT_EQ(values.back(), 1.5);
  EXPECT_NEAR(values[7], 0.9, 1e-15);  // rounding of 0.1
}

TEST(ListOption, EndThatTheStepMissesIsIncludedAllTheSame) {
  EXPECT_EQ(parse("0:1:0.4"), (Values{0.0, 0.4, 0.8, 1.0}));
}

TEST(ListOption, RefusesWhatIsNoListOfFiniteNumbersInRange) {
  for (const char* text : {"", "a", "1,", ",1", "1;2", "1 2", "nan", "inf", "1:2", "1:2:3:4", "0:10:0",
                           "0:10:-1", "0:nan:1", "0:1:1e-9", "1001", "0:2000:1000", "0x10", "1,5,"}) {
    EXPECT_THROW(parse(text), CLI::ValidationError) << '"' << text << '"';
  }
}

TEST(ListOption, NegativeNumbersAreValuesNotOptions) {
  for (const char* arguments : {"--mu-deg -90,0", "--mu-deg=-90,0", "--mu-deg -90:0:90"}) {
    CLI::App app;
    Values values;
    add_list(app, "--mu-deg", values, {-360.0, 360.0}, "direction");
    app.parse(arguments);
    EXPECT_EQ(values, (Values{-90.0, 0.0})) << arguments;
  }
}

TEST(ListOption, RefusalNamesOptionValueAndRange) {
  try {
    parse_list("--speed-kn", "70", {0.0, 60.0});
    FAIL() << "accepted";
  } catch (const CLI::ValidationError& error) {
    EXPECT_STREQ(error.what(), "--speed-kn: 70: 0 ... 60 is wanted");
  }
}

}  // namespace
}  // namespace quickstrip::hull_tool
