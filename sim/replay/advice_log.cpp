#include "sim/replay/advice_log.hpp"

#include <memory>

#include "msgs/convert/encode.hpp"
#include "msgs/convert/own_messages.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

/// What has come so far; an advice waits for the grid of its cycle.
struct Gathered {
  RecordedAdvice recorded;
  wave_spectrum_t spectrum{};
  sea_state_t sea_state{};
  limits_t limits{};
  bool has_advice = false;
  std::uint64_t num = 0;
};

void see_pending(Gathered& gathered, const std::function<void(const RecordedAdvice&)>& see) {
  if (gathered.has_advice) {
    ++gathered.num;
    see(gathered.recorded);
  }
  gathered.has_advice = false;
}

}  // namespace

FileStatus read_advice_log(const std::string& path, const std::string& prefix,
                           const std::function<void(const RecordedAdvice&)>& see) {
  LcmLogReader log;
  if (FileStatus status = log.open(path); !status) {
    return status;
  }
  const auto gathered = std::make_unique<Gathered>();
  LogEvent event;
  while (log.next(event)) {
    if (event.channel == prefix + "ADVICE") {
      see_pending(*gathered, see);
      gathered->recorded.grid.num_speeds = 0;
      gathered->has_advice =
          decode(event.data, gathered->recorded.advice) && check_advice(gathered->recorded.advice).ok();
    } else if (event.channel == prefix + "GRID") {
      const bool is_grid =
          decode(event.data, gathered->recorded.grid) && check_grid(gathered->recorded.grid).ok();
      if (!is_grid || gathered->recorded.grid.utime != gathered->recorded.advice.utime) {
        gathered->recorded.grid.num_speeds = 0;
      }
      see_pending(*gathered, see);
    } else if (event.channel == prefix + "LIMITS") {
      if (decode(event.data, gathered->limits) && check_limits(gathered->limits).ok()) {
        gathered->recorded.limits = gathered->limits;
      }
    } else if (event.channel == prefix + "WAVE_SPECTRUM" && decode(event.data, gathered->spectrum)) {
      see_pending(*gathered, see);
      gathered->recorded.sea = summary(gathered->spectrum);
    } else if (event.channel == prefix + "SEA_STATE" && decode(event.data, gathered->sea_state)) {
      see_pending(*gathered, see);
      gathered->recorded.sea = summary(gathered->sea_state);
    }
  }
  see_pending(*gathered, see);
  if (gathered->num == 0) {
    return FileError{path + ": holds no advice (channel " + prefix +
                     "ADVICE): make one with quickstrip-sim replay LOG --hull HULL --out LOG2"};
  }
  return {};
}

double badness(const RecordedAdvice& recorded) {
  const advice_t& advice = recorded.advice;
  if (advice.no_advice != 0 || advice.verdict == 0) {
    return -1.0;
  }
  // By the present course first, then by how much of the grid is closed, so that the picture shows something.
  int exceeded = 0;
  for (int s = 0; s < recorded.grid.num_speeds; ++s) {
    for (int h = 0; h < recorded.grid.num_headings; ++h) {
      exceeded += recorded.grid.verdict[s][h] == grid_t::VERDICT_EXCEEDED ? 1 : 0;
    }
  }
  const int cells = recorded.grid.num_speeds * recorded.grid.num_headings;
  const double share = cells > 0 ? static_cast<double>(exceeded) / cells : 0.0;
  constexpr double kTie = 1e-6;  // two hours in which nothing is left: the one whose limit lies further off
  return advice.verdict + share - kTie * advice.margin;
}

}  // namespace quickstrip
