// Killed, and started again: the last inputs come back, aged and said to be restored, within two seconds.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <thread>

#include "firmware/advisor/kept_inputs_file.hpp"
#include "msgs/files/lcm_log.hpp"
#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

class Restart : public FaultTest {
 protected:
  [[nodiscard]] std::vector<std::string> with_state() const { return {"--state", folder_.file("state.log")}; }
  [[nodiscard]] bool journal_says(const std::string& words) const {
    return advisor_.journal().find(words) != std::string::npos;
  }
};

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The whole grid of the S-175 at the default cycle of a second: as on board.
TEST_F(Restart, Kill9AndRestartGiveAgedRestoredAdviceWithinTwoSeconds) {
  hull_file_ = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml";
  oracle_ = std::make_unique<Oracle>(hull_file_);
  promises_.cycle_s = 1.0;
  start(with_state());
  send_sea(kBadSea_m, 60.0);
  ASSERT_TRUE(until_advice());
  listen(3.5);  // own ship is kept every two seconds
  const std::int64_t killed_at = now();
  advisor_.kill_hard();
  has_sensors_ = false;
  const double took_s = seconds_of([&] {
    start(with_state());
    ASSERT_TRUE(until_advice());
  });
  EXPECT_LT(took_s, kPatience);  // 2 s, and under sanitizers five times that
  EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
  EXPECT_EQ(advice_.input_use[advice_t::INPUT_SEA_STATE], int{advice_t::USE_RESTORED});
  EXPECT_EQ(advice_.input_use[advice_t::INPUT_OWN_SHIP], int{advice_t::USE_RESTORED});
  EXPECT_GE(advice_.utime - advice_.input_utime[advice_t::INPUT_SEA_STATE], 60 * kSecond_us);
  EXPECT_LE(advice_.input_utime[advice_t::INPUT_OWN_SHIP], killed_at);
  EXPECT_TRUE(journal_says("2 inputs restored")) << advisor_.journal();
  RecordProperty("advice_after_restart_s", std::to_string(took_s));
  std::printf("advice %.2f s after the restart\n", took_s);
  has_sensors_ = true;
  ASSERT_TRUE(until([this] { return advice_.input_use[advice_t::INPUT_OWN_SHIP] == advice_t::USE_LIVE; }));
}

TEST_F(Restart, HoweverLongItRanBeforeTheKeptOwnShipIsYoungEnough) {
  std::vector<std::string> options = with_state();
  options.insert(options.end(), {"--own-ship-stale-after-s", "5"});
  promises_.own_ship_stale_after_s = 5.0;
  start(options);
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_good());
  listen(5.5);  // were own ship kept once in ten seconds, it would be stale now
  advisor_.kill_hard();
  has_sensors_ = false;
  start(options);
  ASSERT_TRUE(until_advice(2.0)) << why_not();
  EXPECT_EQ(advice_.input_use[advice_t::INPUT_OWN_SHIP], int{advice_t::USE_RESTORED});
  ASSERT_TRUE(until_no_advice(6.0)) << "a restored own ship goes stale like any other";
  EXPECT_NE(why_not().find("the ship's heading and speed are"), std::string::npos) << why_not();
}

TEST_F(Restart, WithoutAStateFileItStartsWithNothingAndSaysSo) {
  start();
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_good());
  advisor_.kill_hard();
  start();
  ASSERT_TRUE(until_no_advice());
  listen(0.5);
  EXPECT_NE(why_not().find("sea"), std::string::npos) << why_not();
}

TEST_F(Restart, KilledAtAnyMomentTheStateFileIsWhole) {
  std::mt19937 random(20'261'123);
  std::uniform_int_distribution<int> life_ms(30, 400);
  std::int32_t num_restored = 0;
  for (int i = 0; i < 8; ++i) {
    start(with_state());
    num_restored += journal_says(" 0 inputs restored") ? 0 : 1;
    send_sea(i % 2 == 0 ? kBadSea_m : kGoodSea_m);
    listen(1e-3 * life_ms(random));
    advisor_.kill_hard();
    LcmLogReader log;
    if (log.open(folder_.file("state.log"))) {
      LogEvent event;
      while (log.next(event)) {
      }
      EXPECT_EQ(log.num_faults(), 0U);
    }
  }
  EXPECT_GE(num_restored, 4);
  start(with_state());
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_advice());
}

// The writer alone, in a tight loop, killed at random: nearly always in the middle of a write.
TEST_F(Restart, KilledInTheMiddleOfWritingTheFileBeforeIsStillThere) {
  const std::string file = folder_.file("state.log");
  const auto kept = std::make_unique<KeptInputs>();
  kept->has_wave_spectrum = true;
  kept->has_own_ship = true;
  kept->own_ship = ship_at(kSecond_us, 0.0, 1);
  kept->wave_spectrum.utime = kSecond_us;
  const auto limits = std::make_unique<limits_t>();
  ASSERT_TRUE(write_kept_inputs(file, "QS_", *kept, *limits));
  std::mt19937 random(7);
  std::uniform_int_distribution<int> life_us(0, 4000);
  for (int i = 0; i < 60; ++i) {
    const pid_t writer = fork();
    if (writer == 0) {
      while (true) {
        ++kept->own_ship.seq;
        static_cast<void>(write_kept_inputs(file, "QS_", *kept, *limits));
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(life_us(random)));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    LcmLogReader log;
    ASSERT_TRUE(log.open(file));
    LogEvent event;
    while (log.next(event)) {
    }
    ASSERT_EQ(log.num_events(), 4U) << "limits, spectrum, own ship, digest";
    ASSERT_EQ(log.num_faults(), 0U);
  }
  std::size_t num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    num_files += entry.path().filename().string().starts_with("state.log") ? 1U : 0U;
  }
  EXPECT_LE(num_files, 2U) << "half-written files pile up";
}

}  // namespace
}  // namespace quickstrip::faults
