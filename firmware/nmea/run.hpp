// The gateway's loop: waits for all sources together, takes what has come, sends what is due, and says once a
// minute what it has counted.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "firmware/nmea/gateway.hpp"
#include "firmware/nmea/source.hpp"

namespace quickstrip::nmea {

struct RunOptions {
  bool record_clock = false;
  double speed = 0.0;            // of a record: its seconds a second; 0: as fast as possible
  double report_every_s = 60.0;  // to standard error
};

/// Until `stop`, or until every source has ended.
void run(std::vector<Source>& sources, Gateway& gateway, const RunOptions& options,
         const std::atomic<bool>& stop);

/// "2014-08-01T00:10:00Z 5000 lines: 3125 taken, 1250 not used; refused 625: 625 talker; ..."
std::string report(const Gateway& gateway, std::int64_t now);

}  // namespace quickstrip::nmea
