#include "tests/fuzz/targets.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace quickstrip::fuzz {

std::span<const Target> targets() {
  static constexpr std::array kTargets{
      Target{"hull", run_hull, hull_seeds, 150},
      Target{"limits", run_limits, limits_seeds, 1500},
      Target{"sea", run_sea, sea_seeds, 1500},
      Target{"voyage", run_voyage, voyage_seeds, 3000},
      Target{"log", run_log, log_seeds, 1500},
      Target{"hull_table", run_hull_table, hull_table_seeds, 300},
      Target{"sea_state", run_sea_state, no_seeds, 200},
      Target{"wave_spectrum", run_wave_spectrum, no_seeds, 200},
      Target{"sea_forecast", run_sea_forecast, no_seeds, 200},
      Target{"own_ship", run_own_ship, no_seeds, 200},
      Target{"loading", run_loading, no_seeds, 100},
      Target{"motion", run_motion, no_seeds, 500},
      Target{"query", run_query, no_seeds, 200},
      Target{"alert_ack", run_alert_ack, no_seeds, 500},
      Target{"time", run_time, no_seeds, 500},
      Target{"nmea", run_nmea, nmea_seeds, 3000},
      Target{"picture", run_picture, no_seeds, 200},
      Target{"entry", run_entry, entry_seeds, 3000},
      Target{"session", run_session, session_seeds, 60},
      Target{"step", run_step, step_seeds, 60},
      Target{"state", run_state, state_seeds, 150},
      Target{"ndbc", run_ndbc, ndbc_seeds, 800},
      Target{"transfer", run_transfer, transfer_seeds, 3000},
      Target{"list", run_list, list_seeds, 5000},
      Target{"frames", run_frames, frames_seeds, 300},
      Target{"config", run_config, config_seeds, 500},
  };
  return kTargets;
}

const Target* target_of(std::string_view name) {
  for (const Target& target : targets()) {
    if (target.name == name) {
      return &target;
    }
  }
  return nullptr;
}

void require(bool holds, std::string_view promise) {
  if (!holds) {
    std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
    std::abort();
  }
}

void require_one_line(std::string_view line, std::string_view file) {
  require(line.starts_with(file), "a refusal names its file");
  require(line.size() > file.size() + 2, "a refusal says what is wrong");
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    require(byte >= 0x20 && byte != 0x7F, "a refusal is one line without control characters");
  }
  require(line.size() < 1000, "a refusal is not longer than a few lines of a terminal");
}

std::vector<Bytes> no_seeds() {
  return {Bytes{}};
}

}  // namespace quickstrip::fuzz
