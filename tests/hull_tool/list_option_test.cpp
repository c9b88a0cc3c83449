#include "msgs/cli/list_option.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
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
    EXPECT_STREQ(error.what(), "--speed-kn: 70: wanted: 0 ... 60");
  }
}

TEST(ListOption, DirectionsRunFromAboveMinus360To360AndKeepWhatWasGiven) {
  EXPECT_EQ(parse_list("--mu-deg", "360,-359.5", kDirections_deg), (Values{360.0, -359.5}));
  for (const char* text : {"-360", "360.001", "725", "nan"}) {
    EXPECT_THROW(parse_list("--mu-deg", text, kDirections_deg), CLI::ValidationError) << text;
  }
}

TEST(ListOption, NumbersOfProgramsRefuseNanAsListsDo) {
  for (const char* text : {"nan", "inf", "-inf", "1e400", "0", "", "1 s", "0x10", "10,20"}) {
    CLI::App app;
    double value = 1.0;
    add_number(app, "--cycle-s", value, {0.01, 86400.0}, "period");
    EXPECT_THROW(app.parse(std::vector<std::string>{text, "--cycle-s"}), CLI::ParseError) << text;
    EXPECT_EQ(value, 1.0);
  }
}

TEST(ListOption, ListsThatCombineToMoreThanAMillionRowsAreRefused) {
  EXPECT_NO_THROW(refuse_too_many("--a, --b", {1000, 1000}));
  EXPECT_THROW(refuse_too_many("--a, --b", {1000, 1001}), CLI::ValidationError);
  EXPECT_THROW(refuse_too_many("--a, --b, --c", {10'000, 10'000, 10'000}), CLI::ValidationError);
}

}  // namespace
}  // namespace quickstrip
