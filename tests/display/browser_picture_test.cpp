// In a real browser: first paint, update, words, and every direction from the wire to the screen.
#include "tests/display/browser.hpp"

#include <cmath>
#include <cstdio>

#include "msgs/convert/text.hpp"

namespace quickstrip::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

TEST_F(Browser, FirstPaintSaysThatNothingIsKnownYet) {
  Bridge bridge(false);
  open(bridge);
  EXPECT_TRUE(
      driver().wait_until("return document.getElementById('verdict-word').textContent === 'NO DATA'", 3s));
  EXPECT_EQ(driver().run("return document.body.classList.contains('silent')"), true);
  EXPECT_EQ(driver().text("#silence-title"), "NO ADVICE RECEIVED");
  EXPECT_NE(driver().text("footer").find("Supporting tool for the master"), std::string::npos);
  EXPECT_EQ(driver().run("return document.querySelectorAll('.cell').length"), 0);
}

TEST_F(Browser, ShowsTheAdviceAndFollowsIt) {
  Bridge bridge;
  bridge.display().mailbox().put(comparison_at(utime_now()));
  open_live(bridge);
  EXPECT_EQ(driver().text("#verdict-word"), "CAUTION");
  EXPECT_EQ(driver().text("#own-heading"), "065°");
  EXPECT_EQ(driver().text("#own-speed"), "14.2");
  EXPECT_EQ(driver().text("#margin-caption"), "Limit reached if waves grow");
  EXPECT_EQ(driver().text("#margin-big"), "25 %");
  EXPECT_EQ(driver().text("#governing"), "Roll: 4.8° (RMS), limit 6.0°");
  EXPECT_EQ(driver().text("#members"), "In 11 of 16 cases within the uncertainty a limit is exceeded.");
  EXPECT_EQ(driver().text("#expected"), "Largest likely in 30 min: roll 14°, pitch 4°");
  EXPECT_NE(driver().text("#panel-changes").find("passes beam-on, 18° likely"), std::string::npos);
  EXPECT_NE(driver().text("#panel-measured").find("predicted 3.1°, measured 4.0°"), std::string::npos);
  EXPECT_NE(driver().text("#panel-measured").find("Confidence lowered"), std::string::npos);
  EXPECT_EQ(driver().run("return document.querySelectorAll('.cell').length"), 1800);
  EXPECT_EQ(driver().text("#legend-unknown-hatch-0"), "not known: 10 % of the picture");
  keep_picture("live_day");
  driver().click("#tab-inputs");
  const std::string inputs = driver().text("#panel-inputs");
  for (const char* const part :
       {"Waves 3.2 m, 11.0 s peak period, from 240°", "wave radar", "the ship's file",
        "Uncertainty assumed, for no input gives it: wave height, GM.",
        "Natural roll period 15.8 to 19.3 s, computed.", "running, cycle 0.20 s"}) {
    EXPECT_NE(inputs.find(part), std::string::npos) << part << " in " << inputs;
  }
  keep_picture("inputs_day");
  driver().click("#tab-measured");
  EXPECT_NE(driver().text("#limits-table").find("Deck wetness at bow1.0"), std::string::npos);
  keep_picture("motions_day");
  bridge.say([](advice_t& advice) {
    advice.verdict = advice_t::VERDICT_EXCEEDED;
    advice.margin = 0.87;
  });
  EXPECT_TRUE(
      driver().wait_until("return document.getElementById('verdict-word').textContent === 'EXCEEDED'", 2s));
  EXPECT_EQ(driver().text("#margin-caption"), "Waves must fall by");
  EXPECT_EQ(driver().text("#margin-big"), "13 %");
  bridge.has_outlook = false;
  EXPECT_TRUE(
      driver().wait_until("return document.getElementById('expected').textContent.includes('4.8° RMS')", 2s));
}

TEST_F(Browser, SaysNoAdviceAndWhy) {
  Bridge bridge;
  bridge.say([](advice_t& advice) {
    advice.no_advice = 3;
    put_text("No advice, because the sea state is 95 min old (limit 90 min)", advice.no_advice_text);
  });
  open(bridge);
  EXPECT_TRUE(
      driver().wait_until("return document.getElementById('verdict-word').textContent === 'NO ADVICE'", 5s));
  EXPECT_EQ(driver().text("#no-advice"), "No advice, because the sea state is 95 min old (limit 90 min)");
}

TEST_F(Browser, WhatComesFromTheBusIsTextAndNeverMarkup) {
  Bridge bridge;
  bridge.say([](advice_t& advice) {
    put_text("<img src=x onerror=window.hit=1><script>window.hit=1</script>", advice.reasons_text);
    put_text("<b>ship</b>", advice.hull_name);
  });
  open_live(bridge);
  EXPECT_EQ(driver().text("#hull-name"), "<b>ship</b>");
  EXPECT_EQ(driver().run(
                "return window.hit === undefined && document.querySelectorAll('#panel-changes img').length"),
            0);
}

// From dir_from_deg on the wire to the arrow on the screen, by the arrow's own corners as the screen has
// them.
constexpr const char* kArrow = R"(
  const path = document.querySelector('.wave'), polar = document.getElementById('polar');
  if (!path) return null;
  const box = path.getBBox(), m = path.getScreenCTM(), c = polar.getScreenCTM();
  const at = (x, y) => { const p = new DOMPoint(x, y).matrixTransform(m); return [p.x, p.y]; };
  const middle = new DOMPoint(0, 0).matrixTransform(c);
  const tail = at(0, box.y), tip = at(0, box.y + box.height);
  const bearing = (dx, dy) => (Math.atan2(dx, -dy) * 180 / Math.PI + 360) % 360;
  return { tail: bearing(tail[0] - middle.x, tail[1] - middle.y), travel: bearing(tip[0] - tail[0], tip[1] - tail[1]),
           tailFar: Math.hypot(tail[0] - middle.x, tail[1] - middle.y) > Math.hypot(tip[0] - middle.x, tip[1] - middle.y) };
)";

void expect_bearing(double bearing, double expected, const std::string& what) {
  EXPECT_NEAR(std::remainder(bearing - expected, 360.0), 0.0, 0.5) << what;  // half a degree: pixels
}

TEST_F(Browser, WavesComeFromWhereTheWireSaysInAllFourQuadrants) {
  Bridge bridge;
  bridge.heading_deg = 65.0;
  open_live(bridge);
  for (const bool is_head_up : {false, true}) {
    for (const double dir : {25.0, 110.0, 205.0, 340.0}) {
      bridge.dir_from_deg = dir;
      const std::string what = std::to_string(dir) + (is_head_up ? " head up" : " north up");
      ASSERT_TRUE(driver().wait_until("return document.querySelector('.wave')?.dataset.dirFrom === '" +
                                          std::to_string(static_cast<int>(dir)) + "'",
                                      3s))
          << what;
      const json arrow = driver().run(kArrow);
      const double top = is_head_up ? 65.0 : 0.0;
      expect_bearing(arrow["tail"].get<double>(), dir - top, what);
      expect_bearing(arrow["travel"].get<double>(), dir - top + 180.0, what);
      EXPECT_EQ(arrow["tailFar"], true) << what;
      const std::string label = driver().text(".wave-label");
      char words[32];
      std::snprintf(words, sizeof(words), "from %03.0f°", dir);
      EXPECT_EQ(label.substr(0, std::string(words).size()), words);
      EXPECT_NE(label.find("3.2 m, 11.0 s"), std::string::npos);
    }
    if (!is_head_up) {
      driver().click("#orientation");
      EXPECT_EQ(driver().text("#orientation"), "Headup");
    }
  }
}

TEST_F(Browser, CellsLieOnTheirHeadingAndAreToldApartByColourAndHatch) {
  Bridge bridge;
  open_live(bridge);
  struct Expected {
    double heading;
    int verdict;
    const char* cause;
  };
  for (const bool is_head_up : {false, true}) {
    for (const Expected& one :
         {Expected{45, 3, "motion"}, Expected{135, 2, "motion"}, Expected{225, 0, "none"},
          Expected{315, 2, "zone"}, Expected{90, 1, "none"}}) {
      const json cell = driver().run(kCellAt, {one.heading - (is_head_up ? 65.0 : 0.0), 17});
      ASSERT_TRUE(cell.is_object()) << one.heading;
      EXPECT_EQ(cell["heading"], one.heading);
      EXPECT_EQ(cell["speed"], 17.0);
      EXPECT_EQ(cell["verdict"], one.verdict);
      EXPECT_EQ(cell["cause"], one.cause);
    }
    driver().click("#orientation");
  }
  const json hatches = driver().run(R"(
    const hatch = (h) => document.querySelector(`.cell[data-speed="17"][data-heading="${h}"]`).nextSibling.getAttribute('fill');
    return [hatch(90), hatch(135), hatch(45), hatch(225)])");
  EXPECT_EQ(hatches, (json{"none", "url(#hatch-2)", "url(#hatch-3)", "url(#hatch-0)"}));
  const json own = driver().run(R"(
    const m = document.getElementById('own-ship').getScreenCTM(), c = document.getElementById('polar').getScreenCTM();
    const ship = new DOMPoint(0, 0).matrixTransform(m), bow = new DOMPoint(0, -19).matrixTransform(m), middle = new DOMPoint(0, 0).matrixTransform(c);
    const bearing = (p, q) => Math.atan2(p.x - q.x, q.y - p.y) * 180 / Math.PI;
    return [bearing(ship, middle), bearing(bow, ship)])");
  expect_bearing(own[0].get<double>(), 65.0, "the ship's place");
  expect_bearing(own[1].get<double>(), 65.0, "the ship's bow");
}

}  // namespace
}  // namespace quickstrip::test
