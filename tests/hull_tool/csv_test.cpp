#include "sim/hull_tool/csv.hpp"

#include <gtest/gtest.h>

#include <clocale>

namespace quickstrip::hull_tool {
namespace {

TEST(Csv, NumbersHaveAtLeastNineSignificantDigits) {
  EXPECT_EQ(number_text(1.0 / 3.0), "0.3333333333");
  EXPECT_EQ(number_text(123456789.5), "123456789.5");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(9.5), "9.5");
}

TEST(Csv, DecimalMarkIsADotInEveryLocale) {
  for (const char* locale : {"de_DE.UTF-8", "nl_NL.UTF-8", "C"}) {
    std::setlocale(LC_ALL, locale);  // where the machine has it
    EXPECT_EQ(number_text(0.5), "0.5");
  }
}

TEST(Csv, UnknownQuantityIsAnEmptyField) {
  Csv csv("a,b,c");
  csv.add(1.5).add(std::optional<double>()).add(true);
  csv.end_row();
  EXPECT_EQ(csv.text(), "a,b,c\n1.5,,1\n");
}

TEST(Csv, TextWithACommaOrAQuoteIsQuoted) {
  Csv csv("name");
  csv.add("bow, \"port\"");
  csv.end_row();
  EXPECT_EQ(csv.text(), "name\n\"bow, \"\"port\"\"\"\n");
}

}  // namespace
}  // namespace quickstrip::hull_tool
