// In a real browser: silence is said, and trends outlive a reload.
#include "tests/display/browser.hpp"

#include <thread>

namespace quickstrip::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

TEST_F(Browser, SaysWithinThreeSecondsThatTheAdvisorIsSilent) {
  Bridge bridge;
  open_live(bridge);
  bridge.speaks = false;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(driver().wait_until("return document.body.classList.contains('silent')", 6s));
  EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
  EXPECT_EQ(driver().text("#silence-title"), "ADVISOR SILENT");
  EXPECT_EQ(driver().text("#verdict-word"), "SILENT");
  EXPECT_LT(driver().run("return Number(getComputedStyle(document.getElementById('picture')).opacity)"), 0.5);
  EXPECT_NE(driver().run("return getComputedStyle(document.getElementById('silence')).display"), "none");
  keep_picture("silent_day");
  bridge.speaks = true;
  EXPECT_TRUE(driver().wait_until("return !document.body.classList.contains('silent')", 3s));
}

TEST_F(Browser, SaysWithinThreeSecondsThatTheDisplayIsGone) {
  Bridge bridge;
  open_live(bridge);
  bridge.stop_service();
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(driver().wait_until("return document.body.classList.contains('silent')", 6s));
  EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
  EXPECT_EQ(driver().text("#silence-title"), "DISPLAY NOT CONNECTED");
}

TEST_F(Browser, AdviceWhoseTimeIsOverIsNotShownAsAdvice) {
  Bridge bridge;
  open_live(bridge);
  bridge.say([](advice_t& advice) { advice.valid_until_utime = advice.utime - 1; });
  EXPECT_TRUE(driver().wait_until(
      "return document.getElementById('silence-title').textContent === 'ADVICE OUT OF DATE'", 3s));
}

TEST_F(Browser, ALoadedPageHasTheTrendsOfTheHoursBefore) {
  Bridge bridge(true, [](Display& display) {
    const std::int64_t now = utime_now();
    for (int minute = 120; minute > 0; --minute) {  // two hours, played at once
      display.mailbox().put(advice_at(now - std::int64_t{60'000'000} * minute, minute));
      display.turn(now, 0ms);
    }
  });
  open_live(bridge);
  EXPECT_GE(driver().run("return Number(document.getElementById('panel-trends').dataset.samples)"), 120);
  open_live(bridge);
  EXPECT_GE(driver().run("return Number(document.getElementById('panel-trends').dataset.samples)"), 120);
  driver().click("#tab-trends");
  EXPECT_EQ(driver().run("return document.querySelectorAll('.trend path').length"), 3);
  keep_picture("trends_day");
}

}  // namespace
}  // namespace quickstrip::test
