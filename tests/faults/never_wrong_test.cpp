// The common checker must be able to fail: each promise broken by hand is found.
#include "tests/faults/never_wrong.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "msgs/convert/digest.hpp"
#include "tests/bad_input/edited_text.hpp"

namespace quickstrip::faults {
namespace {

constexpr std::int64_t kNow = 1'567'600'800 * kSecond_us;

/// A true advice and grid on a sea of `hs_m`, as the oracle gives them, and what was sent.
struct True {
  std::unique_ptr<Oracle> oracle =
      std::make_unique<Oracle>(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml");
  Sent sent;
  advice_t advice{};
  grid_t grid{};

  explicit True(double hs_m) {
    const sea_state_t sea = beam_sea(kNow, hs_m, 1);
    const own_ship_t ship = ship_at(kNow, 0.0, 2);
    sent.seas[mark_of(sea)] = sea;
    sent.ships[mark_of(ship)] = ship;
    const Opinion& opinion = oracle->of(sea, ship, nullptr);
    advice = opinion.advice;
    grid = opinion.grid;
    name(advice_t::INPUT_SEA_STATE, mark_of(sea));
    name(advice_t::INPUT_OWN_SHIP, mark_of(ship));
    advice.valid_until_utime = advice.utime + kSecond_us / 4;
    reseal(advice);
  }
  void name(int input, const Mark& mark) {
    std::tie(advice.input_source_id[input], advice.input_seq[input], advice.input_utime[input]) = mark;
  }
  static void reseal(advice_t& message) {
    static std::array<std::uint8_t, kMaxMessageBytes> scratch;
    ASSERT_TRUE(seal(message, scratch));
  }
  std::string after(const std::function<void(advice_t&)>& edit) {
    advice_t changed = advice;
    edit(changed);
    reseal(changed);
    return fault_of(changed, sent, {}, *oracle);
  }
};

TEST(NeverWrong, TrueAdviceAndGridPass) {
  True calm(0.5);
  EXPECT_EQ(fault_of(calm.advice, calm.sent, {}, *calm.oracle), "");
  EXPECT_EQ(fault_of(calm.grid, calm.advice, calm.sent, *calm.oracle), "");
  EXPECT_TRUE(is_good(calm.advice));
  True rough(9.0);
  EXPECT_EQ(fault_of(rough.advice, rough.sent, {}, *rough.oracle), "");
  EXPECT_EQ(rough.advice.verdict, int{advice_t::VERDICT_EXCEEDED});
}

TEST(NeverWrong, EachWrongAdviceIsFound) {
  True rough(9.0);
  EXPECT_NE(rough.after([](advice_t& a) { a.verdict = advice_t::VERDICT_GOOD; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.roll_rms_deg *= 1.0 + 1e-12; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.criterion_value[0] += 1e-9; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.input_seq[0] += 1; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.input_source_id[3] += 1; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.utime += 11 * kSecond_us; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.utime -= 6 * kSecond_us; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.valid_until_utime = a.utime; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.valid_until_utime += 10 * kSecond_us; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.source_id = 7; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.no_advice = 2; }), "");
  EXPECT_NE(rough.after([](advice_t& a) { a.input_use[3] = advice_t::USE_NONE; }), "");
  advice_t unsealed = rough.advice;
  unsealed.speed_kn += 1.0;
  EXPECT_EQ(fault_of(unsealed, rough.sent, {}, *rough.oracle), "the digest is not its own");
}

TEST(NeverWrong, EachWrongGridIsFound) {
  True rough(9.0);
  grid_t grid = rough.grid;
  grid.verdict[3][18] = grid_t::VERDICT_GOOD;
  EXPECT_NE(fault_of(grid, rough.advice, rough.sent, *rough.oracle), "");
  grid = rough.grid;
  ++grid.roll_rms[2][7];
  EXPECT_NE(fault_of(grid, rough.advice, rough.sent, *rough.oracle), "");
  grid = rough.grid;
  ++grid.utime;
  EXPECT_NE(fault_of(grid, rough.advice, rough.sent, *rough.oracle), "");
  advice_t none = rough.advice;
  none.no_advice = 6;
  EXPECT_NE(fault_of(rough.grid, none, rough.sent, *rough.oracle), "") << "cells without advice";
}

}  // namespace
}  // namespace quickstrip::faults
