#include "firmware/advisor/process_watch.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace quickstrip {
namespace {

constexpr int kVerdicts = 8;  // room for a verdict below a reason in one number

/// -1: not known.
std::int64_t resident_now() {
  std::FILE* const file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) {
    return -1;
  }
  long total = 0;
  long resident = -1;
  const int num_read =
      std::fscanf(file, "%ld %ld", &total, &resident);  // NOLINT(cert-err34-c): checked below
  std::fclose(file);
  return num_read == 2 && resident >= 0 ? static_cast<std::int64_t>(resident) * sysconf(_SC_PAGESIZE) : -1;
}

std::string status_of(int state) {
  constexpr const char* kWords[] = {"not known", "good", "caution", "limits exceeded"};
  const int no_advice = state / kVerdicts;
  return no_advice != 0 ? "STATUS=no advice, reason " + std::to_string(no_advice)
                        : std::string("STATUS=advice: ") + kWords[state % kVerdicts % 4];
}

}  // namespace

void ProcessWatch::note_cycle(int no_advice, int verdict) {
  state_.store(no_advice * kVerdicts + verdict, std::memory_order_relaxed);
}

void ProcessWatch::sample() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) == 0) {
    page_faults_.store(usage.ru_minflt + usage.ru_majflt, std::memory_order_relaxed);
  }
  resident_bytes_.store(resident_now(), std::memory_order_relaxed);
}

void ProcessWatch::tell() {
  const std::int64_t turns = turns_.load(std::memory_order_relaxed);
  if (turns == told_turns_) {
    return;  // the cycle's thread stands still: silence is what the manager must hear
  }
  const auto now = std::chrono::steady_clock::now();
  const auto period = notice_.watchdog_period();
  if (!is_ready_) {
    is_ready_ = true;
    told_at_ = now;
    notice_.tell("READY=1\nWATCHDOG=1");
  } else if (period && now - told_at_ >= *period) {
    told_at_ = now;
    notice_.tell("WATCHDOG=1");
  }
  told_turns_ = turns;
  const int state = state_.load(std::memory_order_relaxed);
  if (state != told_state_) {
    told_state_ = state;
    notice_.tell(status_of(state));
  }
}

void ProcessWatch::tell_stopping() {
  notice_.tell("STOPPING=1");
}

}  // namespace quickstrip
