// The log of a simulated voyage: what is in it, and that every message would be accepted.
#include "sim/seaway/motion_log.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "msgs/convert/encode.hpp"
#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/ship_message.hpp"
#include "msgs/files/lcm_log.hpp"
#include "tests/seaway/scene.hpp"

namespace quickstrip::seaway {
namespace {

constexpr std::int64_t kStart = 1'577'836'800'000'000;

std::filesystem::path log_path(const std::string& name) {
  return std::filesystem::temp_directory_path() /
         ("quickstrip_" + name + "_" + std::to_string(getpid()) + ".lcmlog");
}

TEST(MotionLog, HoldsAVoyageThatTheAdvisorWouldAccept) {
  Scene scene(4.0, 9.0, 120.0, 25.0, 12.0);
  scene.plan.hours = 2.0;
  Simulation simulation = scene.simulation();
  const std::filesystem::path path = log_path("motions");
  MotionLog log;
  MotionLogOptions options;
  options.start_utime = kStart;
  ASSERT_TRUE(log.open(path, options, scene.plan, *scene.hull, scene.watch, {&scene.sea, nullptr}).ok());
  const Outcome got = run(simulation, scene.watch, {}, 1, [&](std::size_t block, const Series& series) {
    ASSERT_TRUE(log.add_block(simulation, block, series).ok());
  });
  ASSERT_TRUE(log.finish().ok());
  LcmLogReader reader;
  ASSERT_TRUE(reader.open(path).ok());
  std::map<std::string, int> count;
  double roll_square = 0.0;
  std::int64_t last = 0;
  LogEvent event;
  while (reader.next(event)) {
    ++count[event.channel];
    EXPECT_GE(event.utime, last);
    last = event.utime;
    if (event.channel == "QS_MOTION") {
      motion_t motion;
      ASSERT_TRUE(decode(event.data, motion));
      EXPECT_TRUE(check_motion(motion));
      roll_square += motion.roll_rms_deg * motion.roll_rms_deg;
      EXPECT_EQ(motion.num_accelerometers, 2);
      EXPECT_GT(motion.a_z_rms_m_s2[1], motion.a_z_rms_m_s2[0]);  // the bow moves more than the bridge
    } else if (event.channel == "QS_SEA_STATE") {
      sea_state_t message;
      ASSERT_TRUE(decode(event.data, message));
      SeaState sea;
      std::uint32_t assumed = 0;
      ASSERT_TRUE(to_sea_state(message, sea, assumed));
      EXPECT_NEAR(sea.systems[0].hs, 4.0, 1e-12);
      EXPECT_NEAR(degrees(sea.systems[0].from.radians), 60.0, 1e-9);
    } else {
      own_ship_t message;
      ASSERT_TRUE(decode(event.data, message));
      OwnShipReading ship;
      ASSERT_TRUE(to_own_ship(message, ship));
      EXPECT_NEAR(ship.ship.speed, scene.plan.speed, 1e-9);
    }
  }
  EXPECT_EQ(reader.num_faults(), 0U);
  EXPECT_EQ(count["QS_MOTION"], 8);      // blocks of a quarter of an hour
  EXPECT_EQ(count["QS_SEA_STATE"], 4);   // every half hour
  EXPECT_EQ(count["QS_OWN_SHIP"], 720);  // every 10 s
  EXPECT_NEAR(std::sqrt(roll_square / 8.0), degrees(got.channels[3].rms), 1e-9);
  std::filesystem::remove(path);
}

TEST(MotionLog, LeavesNothingWhenItIsNotFinished) {
  const Scene scene(4.0, 9.0, 120.0, 25.0, 12.0);
  const std::filesystem::path path = log_path("unfinished");
  {
    MotionLog log;
    ASSERT_TRUE(log.open(path, {}, scene.plan, *scene.hull, scene.watch, {&scene.sea, nullptr}).ok());
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace quickstrip::seaway
