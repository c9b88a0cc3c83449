// In a real browser: cells explained, sea and loading entered, alerts acknowledged, by touch and by keyboard.
#include "tests/display/browser.hpp"

#include <thread>
#include <vector>

#include "msgs/convert/text.hpp"
#include "quickstrip/query_t.hpp"

namespace quickstrip::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

TEST_F(Browser, TouchingACellAsksTheAdvisorAndShowsEveryNumber) {
  Bridge bridge;
  open_live(bridge);
  const json cell = driver().run(kCellAt, {135.0, 17});
  driver().click_at(cell["x"].get<double>(), cell["y"].get<double>());
  ASSERT_TRUE(
      driver().wait_until("return document.getElementById('cell-dialog').dataset.answered === 'true'", 5s));
  const auto query = bridge.sent<query_t>("QUERY");
  ASSERT_TRUE(query);
  EXPECT_EQ(query->heading_deg, 135.0);
  EXPECT_EQ(query->speed_kn, 17.0);
  const std::string text = driver().text("#cell-dialog");
  for (const char* const part : {"135° at 17.0 kn", "near a limit", "Limit reached if waves grow 25 %",
                                 "roll", "4.9°", "9.7°", "17.3 s", "100 %", "from 240°", "6.0° (RMS)"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
  keep_picture("cell_day");
  driver().press(key::kEscape);
  EXPECT_EQ(driver().run("return document.getElementById('cell-dialog').open"), false);
}

TEST_F(Browser, SeaIsEnteredRefusedBesideTheFieldReadBackAndSent) {
  Bridge bridge;
  open_live(bridge);
  driver().click("#open-sea");
  driver().type("[name='systems.0.hs_m']", "32");
  driver().type("[name='systems.0.period_s']", "8");
  driver().type("[name='systems.0.dir_from_deg']", "two");
  driver().type("[name='systems.2.hs_m']", "1,5");  // the rows between may be empty; a comma is a comma
  driver().type("[name='author']", "A. Mate");
  driver().click("#sea-check");
  ASSERT_TRUE(
      driver().wait_until("return document.getElementById('systems-0-hs_m-error').textContent !== ''", 3s));
  EXPECT_EQ(driver().text("#systems-0-hs_m-error"), "between 0 and 30 m");
  EXPECT_EQ(driver().text("#systems-0-dir_from_deg-error"), "a number, please");
  EXPECT_EQ(driver().text("#systems-2-period_s-error"), "missing");
  EXPECT_EQ(driver().text("#systems-2-hs_m-error"), "");
  EXPECT_EQ(driver().run("return document.activeElement.name"), "systems.0.hs_m");
  keep_picture("sea_refused_day");
  EXPECT_EQ(bridge.num_sent("SEA_STATE"), 0U);
  driver().type("[name='systems.0.hs_m']", "3.2");
  driver().type("[name='systems.0.dir_from_deg']", "240");
  driver().type("[name='systems.2.period_s']", "14");
  driver().type("[name='systems.2.dir_from_deg']", "310");
  driver().click("#sea-check");
  ASSERT_TRUE(driver().wait_until("return document.querySelector('#sea-dialog .read-back') !== null", 3s));
  EXPECT_EQ(
      driver()
          .text("#sea-dialog .read-back")
          .find("Wind sea 3.2 m, zero-crossing period 8 s, from 240° (WSW), spreading 25°. Swell 1.5 m, peak "
                "period 14 s, from 310° (NW), spreading 25°. Seen at "),
      0U);
  EXPECT_EQ(bridge.num_sent("SEA_STATE"), 0U);
  keep_picture("sea_read_back_day");
  driver().click("#sea-confirm");
  ASSERT_TRUE(driver().wait_until("return !document.getElementById('sea-dialog').open", 3s));
  const auto sea = bridge.sent<sea_state_t>("SEA_STATE");
  ASSERT_TRUE(sea);
  EXPECT_EQ(sea->source_kind, int{sea_state_t::SOURCE_MANUAL});
  EXPECT_EQ(sea->dir_from_deg[0], 240.0);
  EXPECT_EQ(sea->dir_from_deg[1], 310.0);
  EXPECT_EQ(bridge.sent<logbook_t>("LOGBOOK")->kind, int{logbook_t::KIND_SEA_ENTERED});
  ASSERT_TRUE(driver().wait_until(
      "return document.getElementById('entered').textContent === 'sea entered by hand'", 3s));
  driver().click("#tab-inputs");
  driver().click("#withdraw-sea");
  driver().click("#withdraw-send");
  ASSERT_TRUE(driver().wait_until("return document.getElementById('entered').textContent === ''", 3s));
  EXPECT_EQ(bridge.sent<logbook_t>("LOGBOOK")->kind, int{logbook_t::KIND_ENTRY_WITHDRAWN});
}

TEST_F(Browser, LoadingIsEnteredAndAMomentMarked) {
  Bridge bridge;
  open_live(bridge);
  driver().click("#open-loading");
  driver().type("[name='gm_m']", "1.1");
  driver().type("[name='measured_roll_period_s']", "16");
  driver().type("#loading-dialog [name='author']", "Chief");
  driver().click("#loading-check");
  ASSERT_TRUE(
      driver().wait_until("return document.querySelector('#loading-dialog .read-back') !== null", 3s));
  driver().click("#loading-confirm");
  ASSERT_TRUE(driver().wait_until("return !document.getElementById('loading-dialog').open", 3s));
  const auto loading = bridge.sent<loading_t>("LOADING");
  ASSERT_TRUE(loading);
  EXPECT_EQ(loading->gm_m, 1.1);
  EXPECT_EQ(loading->measured_roll_period_s, 16.0);
  driver().click("#open-mark");
  driver().type("[name='text']", "Green water over the bow");
  driver().click("#mark-send");  // the name is kept from before
  ASSERT_TRUE(driver().wait_until("return !document.getElementById('mark-dialog').open", 3s));
  const auto note = bridge.sent<logbook_t>("LOGBOOK");
  EXPECT_EQ(get_text(note->text), "Green water over the bow");
  EXPECT_EQ(get_text(note->author), "Chief");
}

TEST_F(Browser, AlertIsShownAndAcknowledged) {
  Bridge bridge;
  open_live(bridge);
  bridge.display().mailbox().put(warning_at(utime_now()));
  ASSERT_TRUE(driver().wait_until("return !document.getElementById('alert-strip').hidden", 3s));
  EXPECT_NE(driver().text("#alert-strip").find("WARNING: Seakeeping limit"), std::string::npos);
  driver().click("#alert-strip .acknowledge");
  for (int i = 0; i < 100 && bridge.num_sent("ALERT_ACK") == 0; ++i) {
    std::this_thread::sleep_for(20ms);
  }
  const auto ack = bridge.sent<alert_t>("ALERT_ACK");
  ASSERT_TRUE(ack);
  EXPECT_EQ(ack->state, int{alert_t::STATE_ACKNOWLEDGED});
  EXPECT_EQ(ack->alert_id, 1);
  EXPECT_EQ(ack->revision, 3);
}

constexpr const char* kFocused =
    "const e = document.activeElement; return e === document.body ? '' : (e.id || e.name || e.tagName)";

TEST_F(Browser, EverythingIsReachedByKeyboardWithAFocusThatIsSeen) {
  Bridge bridge;
  open_live(bridge);
  std::vector<std::string> reached;
  for (int i = 0; i < 14; ++i) {
    driver().press(key::kTab);
    reached.push_back(driver().run(kFocused).get<std::string>());
    EXPECT_GE(driver().run("return parseFloat(getComputedStyle(document.activeElement).outlineWidth)"), 3.0)
        << reached.back();
  }
  EXPECT_EQ(reached,
            (std::vector<std::string>{"clock", "open-sea", "open-loading", "open-mark", "palette", "polar",
                                      "orientation", "tab-changes", "tab-trends", "tab-measured",
                                      "tab-inputs", "tab-alerts", reached[12], reached[13]}));
  driver().run("document.getElementById('polar').focus()");
  for (const char* const stroke :
       {key::kRight, key::kRight, key::kUp, key::kLeft, key::kDown, key::kDown, key::kEnter}) {
    driver().press(stroke);
  }
  ASSERT_TRUE(
      driver().wait_until("return document.getElementById('cell-dialog').dataset.answered === 'true'", 5s));
  const auto query = bridge.sent<query_t>("QUERY");
  EXPECT_EQ(query->heading_deg, 65.0);  // the first key chooses the ship's own cell; then +5, -5
  EXPECT_EQ(query->speed_kn, 13.0);     // 14, then +1, -1, -1
  driver().press(key::kEnter);          // Close has the focus
  EXPECT_EQ(driver().run("return document.getElementById('cell-dialog').open"), false);
}

}  // namespace
}  // namespace quickstrip::test
