// The board's sentences are the bridge's: small_format against libfmt.
#include "firmware/cortex-m7/text/small_format.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace quickstrip {
namespace {

template <typename... Args>
std::string small(small_format::format_string<Args...> format, Args&&... args) {
  std::string text(200, '?');
  const auto result =
      small_format::format_to_n(text.data(), text.size(), format, std::forward<Args>(args)...);
  text.resize(result.size);
  return text;
}

/// Ties, powers of ten, the largest; and others.
std::vector<double> numbers() {
  std::vector<double> list{0.0,
                           -0.0,
                           0.5,
                           1.5,
                           2.5,
                           0.25,
                           0.125,
                           0.0625,
                           0.35,
                           0.45,
                           9.995,
                           999.5,
                           0.9995,
                           1e-300,
                           5e-324,
                           9007199254740991.0,
                           4503599627370495.5,
                           1e15,
                           0.05,
                           0.15,
                           359.5,
                           0.0005,
                           std::numeric_limits<double>::infinity(),
                           std::nan("")};
  std::mt19937_64 random(5);
  for (int i = 0; i < 100'000; ++i) {
    const double exponent = static_cast<double>(random() % 200) / 10.0 - 8.0;
    const double mantissa = 1.0 + static_cast<double>(random() % 1000000) * 9e-6;
    const double value = mantissa * std::pow(10.0, exponent);
    if (value < 9e15) {
      list.push_back(value);
    }
    list.push_back(static_cast<double>(random() % 100000) / 64.0);  // many ties
  }
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(-list[i]);
  }
  return list;
}

TEST(SmallFormat, NumbersAreWrittenAsLibfmtWritesThem) {
  for (const double x : numbers()) {
    ASSERT_EQ(small("{:.0f}", x), fmt::format("{:.0f}", x));
    ASSERT_EQ(small("{:.1f}", x), fmt::format("{:.1f}", x));
    ASSERT_EQ(small("{:.2f}", x), fmt::format("{:.2f}", x));
    ASSERT_EQ(small("{:.3f}", x), fmt::format("{:.3f}", x));
    if (std::isfinite(x)) {
      ASSERT_EQ(small("{:03.0f}", x), fmt::format("{:03.0f}", x));
    }
  }
}

TEST(SmallFormat, TextAndIntegersAreWrittenBetween) {
  const std::string_view name = "Saint-Brévin";
  EXPECT_EQ(small("{} and {}: {:.1f} kn, {}°", name, "x", 12.25, -42), "Saint-Brévin and x: 12.2 kn, -42°");
  EXPECT_EQ(small("{}", std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(SmallFormat, WhatDoesNotFitIsCountedAndNotWritten) {
  char room[4] = {'a', 'b', 'c', 'd'};
  const auto result = small_format::format_to_n(room, 3, "{:.2f}", 12.34);
  EXPECT_EQ(result.size, 5U);
  EXPECT_EQ(std::string_view(room, 4), "12.d");
}

}  // namespace
}  // namespace quickstrip
