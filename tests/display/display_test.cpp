// Mail in, frames out, entries judged: the display without sockets.
#include "firmware/display/display.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "firmware/display/mail_route.hpp"
#include "firmware/display/recorded_moment.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/files/lcm_log.hpp"
#include "tests/display/bridge.hpp"

namespace quickstrip {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;
constexpr std::int64_t kNow = 1'567'600'800'000'000;

struct Fed {
  std::vector<std::string> sent;
  Display display{{}, [this](std::string_view channel, std::span<const std::uint8_t>) {
                    sent.emplace_back(channel);
                    return true;
                  }};

  json frame(Topic topic) {
    display.turn(kNow, 0ms);
    const auto newest = display.hub().newest(topic);
    return newest ? json::parse(*newest) : json();
  }
  void feed_all() {
    Mailbox& mail = display.mailbox();
    mail.put(test::limits_at(kNow));
    mail.put(test::sea_from(kNow, 240.0));
    mail.put(test::advice_at(kNow, 5));
    mail.put(test::grid_at(kNow, 5));
    mail.put(test::outlook_at(kNow, 5));
    mail.put(test::health_at(kNow));
  }
};

TEST(Display, FrameCarriesAdviceOutlookAndSea) {
  Fed fed;
  fed.feed_all();
  const json state = fed.frame(Topic::kState);
  EXPECT_EQ(state["advice"]["verdict"], 2);
  EXPECT_EQ(state["advice"]["margin"], 1.25);
  EXPECT_EQ(state["outlook"]["present_exceeded"], 11);
  EXPECT_EQ(state["outlook"]["expected_max_heave_m"], nullptr);  // -1 on the wire
  EXPECT_EQ(state["sea"]["systems"][0]["dir_from_deg"], 240.0);
  EXPECT_EQ(state["changes"][0]["turn"]["text"], "Coming to 095 passes beam-on, 18° likely");
  const json grid = fed.frame(Topic::kGrid);
  EXPECT_EQ(grid["verdict"].size(), 1800U);
  EXPECT_EQ(grid["verdict"][10 * 72 + 9], 3);  // 10 kn, 045
}

TEST(Display, OutlookOfAnotherCycleIsNotShown) {
  Fed fed;
  fed.feed_all();
  fed.frame(Topic::kState);
  fed.display.mailbox().put(test::advice_at(kNow + 1, 6));
  EXPECT_EQ(fed.frame(Topic::kState)["outlook"], nullptr);
}

TEST(Display, WhatIsOutOfRangeIsCountedAndDoesNotReplaceWhatIsShown) {
  Fed fed;
  fed.feed_all();
  fed.frame(Topic::kState);
  advice_t bad = test::advice_at(kNow + 1, 6);
  bad.margin = std::numeric_limits<double>::quiet_NaN();
  fed.display.mailbox().put(bad);
  advice_t worse = test::advice_at(kNow + 2, 7);
  EXPECT_EQ(fed.frame(Topic::kState)["advice"]["seq"], 5);
  worse.num_changes = 9;
  fed.display.mailbox().put(worse);
  EXPECT_EQ(fed.frame(Topic::kState)["advice"]["seq"], 5);
  grid_t grid = test::grid_at(kNow, 8);
  grid.num_headings = 73;
  fed.display.mailbox().put(grid);
  fed.frame(Topic::kGrid);
  const std::uint8_t nonsense[] = {1, 2, 3};
  EXPECT_TRUE(route("ADVICE", nonsense, fed.display.mailbox()));
  EXPECT_FALSE(route("QUERY", nonsense, fed.display.mailbox()));
  std::this_thread::sleep_for(550ms);  // a beat
  EXPECT_EQ(fed.frame(Topic::kBeat)["num_refused"], 4);
}

TEST(Display, TheNewerMeasurementOfTheSeaIsShownWhicheverComesLast) {
  Fed fed;
  fed.feed_all();
  fed.frame(Topic::kState);
  fed.display.mailbox().put(test::sea_from(kNow - 600'000'000, 30.0));  // repeated, but older
  EXPECT_EQ(fed.frame(Topic::kState)["sea"]["systems"][0]["dir_from_deg"], 240.0);
  fed.display.mailbox().put(test::sea_from(kNow + 1, 30.0));
  EXPECT_EQ(fed.frame(Topic::kState)["sea"]["systems"][0]["dir_from_deg"], 30.0);
}

TEST(Display, TextThatIsNoUtf8DoesNotBreakTheFrame) {
  Fed fed;
  advice_t advice = test::advice_at(kNow, 5);
  advice.reasons_text[0] = 0xFF;
  fed.display.mailbox().put(advice);
  EXPECT_TRUE(fed.frame(Topic::kState)["advice"]["reasons"].is_string());
}

TEST(Display, AlertsAreShownUntilTheyAreNormal) {
  Fed fed;
  alert_t alert = test::warning_at(kNow);
  fed.display.mailbox().put(alert);
  alert.alert_id = 2;
  fed.display.mailbox().put(alert);  // two of the same cycle: both
  EXPECT_EQ(fed.frame(Topic::kState)["alerts"].size(), 2U);
  alert.state = alert_t::STATE_NORMAL;
  fed.display.mailbox().put(alert);
  EXPECT_EQ(fed.frame(Topic::kState)["alerts"].size(), 1U);
}

TEST(Display, AnAlertThatIsNoLongerRepeatedIsDropped) {
  Mail mail;
  mail.alerts.push_back(test::warning_at(kNow));
  Shown shown;
  const auto start = Shown::Clock::now();
  take_in(mail, start, shown);
  EXPECT_FALSE(drop_silent_alerts(start + 29s, shown));
  EXPECT_EQ(shown.alerts.size(), 1U);
  EXPECT_TRUE(drop_silent_alerts(start + 31s, shown));
  EXPECT_TRUE(shown.alerts.empty());
}

TEST(Display, AcknowledgesTheRevisionThatIsShownAndNoOther) {
  Fed fed;
  fed.display.mailbox().put(test::warning_at(kNow));
  fed.frame(Topic::kState);
  EXPECT_EQ(fed.display
                .post("acknowledge", R"({"alert_id":1,"instance":1,"revision":2,"what":"acknowledge"})", kNow)
                .status,
            409);
  EXPECT_EQ(fed.display
                .post("acknowledge", R"({"alert_id":1,"instance":1,"revision":3,"what":"acknowledge"})", kNow)
                .status,
            200);
  EXPECT_EQ(fed.sent, std::vector<std::string>{"ALERT_ACK"});
}

TEST(Display, NothingIsSentBeforeItIsConfirmed) {
  Fed fed;
  const Answer read_back = fed.display.post(
      "sea",
      R"({"author":"A","systems":[{"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":300}]})",
      kNow);
  EXPECT_EQ(read_back.status, 200);
  EXPECT_TRUE(fed.sent.empty());
  const json answer = json::parse(read_back.body);
  EXPECT_EQ(fed.display.post("confirm", json{{"ticket", answer["ticket"]}}.dump(), kNow).status, 200);
  EXPECT_EQ(fed.sent, (std::vector<std::string>{"SEA_STATE", "LOGBOOK"}));
  EXPECT_EQ(fed.display.post("confirm", json{{"ticket", answer["ticket"]}}.dump(), kNow).status, 409);
  EXPECT_EQ(fed.frame(Topic::kState)["entries"]["sea"]["author"], "A");
}

TEST(Display, AnUnknownFormIsRefused) {
  Fed fed;
  EXPECT_EQ(fed.display.post("steer", "{}", kNow).status, 404);
  EXPECT_EQ(fed.display.post("sea", "{}", kNow).status, 422);
}

TEST(Display, ARecordedMomentTakesNoEntry) {
  DisplayOptions options;
  options.is_recorded = true;
  Display display(options, nullptr);
  EXPECT_EQ(display.post("mark", R"({"author":"A","text":"x"})", kNow).status, 409);
  EXPECT_EQ(display.post("query", R"({"heading_deg":1,"speed_kn":2})", kNow).status, 200);
}

TEST(RecordedMoment, TimesAreWrittenInOneWay) {
  EXPECT_EQ(utime_of_text("1970-01-01T00:01Z"), 60'000'000);
  EXPECT_EQ(utime_of_text("2019-09-04T12:40:00Z"), kNow);
  for (const char* const text :
       {"", "2019-09-04", "2019-09-04T12:40", "2019-02-29T12:40Z", "2019-09-04T24:00Z", "2019-09-04T12:60Z",
        "2019-9-4T12:40Z", "2019-09-04T12:40Zx", "1969-09-04T12:40Z"}) {
    EXPECT_FALSE(utime_of_text(text)) << text;
  }
}

TEST(RecordedMoment, ALogWithoutAdviceIsRefusedInOneLine) {
  DisplayOptions options;
  options.is_recorded = true;
  Display display(options, nullptr);
  const std::string missing = "/nowhere/advice.log";
  EXPECT_FALSE(put_recorded_moment(missing, "", "QS_", display));
  EXPECT_EQ(put_recorded_moment(missing, "noon", "QS_", display).line(),
            "--at: noon: a time is written 2019-09-04T12:40Z");
}

// In a replayed log the sea of the next hour stands right behind the advice of this one.
TEST(RecordedMoment, ShowsTheSeaThatItsAdviceRestsOnAndNotTheNextOne) {
  const auto path =
      std::filesystem::temp_directory_path() / ("quickstrip_moment_" + std::to_string(getpid()) + ".log");
  constexpr std::int64_t kHour = 3'600'000'000;
  LcmLogWriter log;
  std::vector<std::uint8_t> bytes(kMaxMessageBytes);
  const auto append = [&](std::int64_t utime, const char* channel, const auto& message) {
    ASSERT_TRUE(log.append(utime, channel, encode(message, bytes)));
  };
  ASSERT_TRUE(log.open(path));
  append(kNow - kHour, "QS_SEA_STATE", test::sea_from(kNow - kHour, 240.0));
  append(kNow, "QS_ADVICE", test::advice_at(kNow, 5));
  append(kNow, "QS_GRID", test::grid_at(kNow, 5));
  append(kNow + 1, "QS_SEA_STATE", test::sea_from(kNow + 1, 60.0));
  append(kNow + kHour, "QS_ADVICE", test::advice_at(kNow + kHour, 6));
  ASSERT_TRUE(log.finish());
  for (const auto& [at, from_deg] : {std::pair{"2019-09-04T12:40Z", 240.0}, {"2019-09-04T13:40Z", 60.0}}) {
    DisplayOptions options;
    options.is_recorded = true;
    Display display(options, nullptr);
    ASSERT_TRUE(put_recorded_moment(path.string(), at, "QS_", display));
    const auto frame = display.hub().newest(Topic::kState);
    ASSERT_TRUE(frame);
    EXPECT_EQ(json::parse(*frame)["sea"]["systems"][0]["dir_from_deg"], from_deg) << at;
  }
  std::filesystem::remove(path);
}

TEST(Trends, KeepTheWorstOfEachMinuteForTwelveHours) {
  Trends trends;
  constexpr std::int64_t kMinute = 60'000'000;
  for (std::int64_t m = 0; m < 1000; ++m) {
    trends.add(kNow + m * kMinute, {0, 2.0, 1.0, 3.0, 1});
    trends.add(kNow + m * kMinute + 1, {0, 1.5, 0.5, 2.5, 3});
  }
  ASSERT_EQ(trends.samples().size(), Trends::kMaxSamples);
  EXPECT_EQ(trends.samples().back().margin, 1.5);
  EXPECT_EQ(trends.samples().back().roll_rms_deg, 1.0);
  EXPECT_EQ(trends.samples().back().verdict, 3);
  trends.add(kNow, {0, 2.0, 1.0, 3.0, 1});  // another log
  EXPECT_EQ(trends.samples().size(), 1U);
}

TEST(EventHub, ASlowReaderGetsTheNewestOnly) {
  EventHub hub;
  EventHub::Seen seen;
  for (int i = 0; i < 1000; ++i) {
    hub.publish(Topic::kState, std::to_string(i));
  }
  EXPECT_EQ(hub.next(seen, 0ms), "event: state\ndata: 999\n\n");
  EXPECT_EQ(hub.next(seen, 0ms), "");
  hub.publish(Topic::kGrid, "g");
  EXPECT_EQ(hub.next(seen, 0ms), "event: grid\ndata: g\n\n");
}

TEST(Mailbox, KeepsTheNewestOfEachKindAndABoundedNumberOfAlerts) {
  Mailbox mailbox;
  for (int i = 0; i < 500; ++i) {
    mailbox.put(test::advice_at(kNow + i, i));
    mailbox.put(test::warning_at(kNow + i));
  }
  std::unique_ptr<Mail> mail;
  ASSERT_TRUE(mailbox.take(mail, 0ms));
  EXPECT_EQ(mail->advice->seq, 499);
  EXPECT_EQ(mail->alerts.size(), 64U);
  EXPECT_EQ(mail->alerts.back().utime, kNow + 499);
  EXPECT_FALSE(mailbox.take(mail, 0ms));
}

}  // namespace
}  // namespace quickstrip
