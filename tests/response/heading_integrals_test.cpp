#include "core/response/heading_integrals.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace quickstrip {
namespace {

/// Heave alone; or heave and roll, whose two sides differ.
Channel channel_of(bool has_sides) {
  Channel out;
  out.form.displacement[2] = 1.0;
  out.form.displacement[3] = has_sides ? 1.0 : 0.0;
  return out;
}

class TakeColumns : public testing::Test {
 protected:
  void add(const Channel& channel, std::size_t num_levels, std::size_t num_moments) {
    SweepSubject subject{.channel = &channel, .num_levels = num_levels};
    for (std::size_t i = 0; i < num_moments; ++i) {
      ASSERT_TRUE(subject.moments.push_back(Moment::kZeroth));
    }
    ASSERT_TRUE(subjects_.push_back(subject));
  }
  void fill() {
    for (std::size_t i = 0; i < kMaxChannels; ++i) {
      add(i % 3 == 0 ? symmetric_ : sided_, 1 + i % 2, 1 + i % 3);
    }
  }
  /// The rounds that all of them take; every column of a round belongs to one subject and lies in its part.
  std::size_t rounds(std::size_t num_bands) {
    std::size_t count = 0;
    for (std::size_t first = 0; first < subjects_.size(); ++count) {
      const std::size_t end = take_columns(num_bands, first, subjects_, *columns_);
      EXPECT_GT(end, first);
      EXPECT_LE(columns_->num_even + columns_->num_odd, kSweepBlocks);
      std::set<std::size_t> even;
      std::set<std::size_t> odd;
      for (std::size_t i = first; i < end; ++i) {
        const std::size_t more = subjects_[i].num_columns(num_bands);
        for (std::size_t c = 0; c < more; ++c) {
          EXPECT_TRUE(even.insert(subjects_[i].first_even + c).second);
          EXPECT_TRUE(!subjects_[i].has_sides() || odd.insert(subjects_[i].first_odd + c).second);
        }
      }
      EXPECT_LT(*even.rbegin(), columns_->num_even * kTransformBlock);
      EXPECT_TRUE(odd.empty() || *odd.rbegin() < columns_->num_odd * kTransformBlock);
      first = end;
    }
    return count;
  }

  Channel symmetric_ = channel_of(false);
  Channel sided_ = channel_of(true);
  SweepSubjects subjects_;
  std::unique_ptr<SweepColumns> columns_ = std::make_unique<SweepColumns>();
};

TEST_F(TakeColumns, OfAFewWaveSystemsAllChannelsFindRoomAtOnce) {
  fill();
  EXPECT_EQ(rounds(3), 1U);
}

TEST_F(TakeColumns, OfAMeasuredSpectrumTheyTakeTurns) {
  fill();
  const std::size_t count = rounds(kMaxEnergyBands);
  EXPECT_GT(count, 1U);
  EXPECT_LT(count, subjects_.size());
}

TEST_F(TakeColumns, TheLargestChannelOfTheLargestSeaFindsRoomByItself) {
  add(sided_, kRollDampingLevels, 3);
  EXPECT_EQ(rounds(kMaxEnergyBands), 1U);
}

}  // namespace
}  // namespace quickstrip
