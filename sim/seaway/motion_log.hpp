// The simulated voyage as an LCM log: own ship, sea, and QS_MOTION as a motion sensor would send it. Replay
// takes it as it takes any other log.
//
// Of each block: the sea at its beginning (and every half hour), own ship at a steady period, the motions
// over the block at its end: RMS about zero, zero up-crossing periods, maxima, and the accelerations at the
// hull's first four points.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/hull/hull.hpp"
#include "msgs/files/file_status.hpp"
#include "sim/seaway/simulation.hpp"
#include "sim/seaway/stated.hpp"

namespace quickstrip::seaway {

struct MotionLogOptions {
  std::string prefix = "QS_";
  double own_ship_period_s = 10.0;  // the advisor's stale-after
  std::int64_t start_utime = 0;     // microseconds since the epoch
  std::int8_t spectrum_source = 0;  // wave_spectrum_t::SOURCE_...
};

class MotionLog {
 public:
  MotionLog();
  ~MotionLog();
  MotionLog(const MotionLog&) = delete;
  MotionLog& operator=(const MotionLog&) = delete;

  /// `hull` and `watch` live as long as this. Refused: a file that cannot be written; more than 20 million
  /// messages of own ship.
  FileStatus open(const std::string& path, const MotionLogOptions& options, const Plan& plan,
                  const Hull& hull, const Watch& watch, const SeaView& sea);
  FileStatus add_block(const Simulation& simulation, std::size_t block, const Series& series);
  /// Puts the file in its place.
  FileStatus finish();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace quickstrip::seaway
