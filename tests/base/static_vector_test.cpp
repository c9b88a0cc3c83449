#include "core/base/static_vector.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

TEST(StaticVector, SaysNoWhenFullAndChangesNothing) {
  StaticVector<int, 2> v;
  EXPECT_TRUE(v.push_back(1));
  EXPECT_TRUE(v.push_back(2));
  EXPECT_FALSE(v.push_back(3));
  EXPECT_EQ(v.size(), 2u);
  EXPECT_EQ(v.back(), 2);
  EXPECT_FALSE(v.resize(3));
  EXPECT_EQ(v.size(), 2u);
}

TEST(StaticVectorDeathTest, AnIndexBeyondTheSizeStopsTheProgram) {
  StaticVector<int, 2> v;
  EXPECT_DEATH(static_cast<void>(v[0]), "");
}

}  // namespace
}  // namespace quickstrip
