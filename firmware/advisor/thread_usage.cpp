#include "firmware/advisor/thread_usage.hpp"

#include <sys/resource.h>

#include <ctime>

namespace quickstrip {

ThreadUsage usage_of_this_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return {static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec), usage.ru_nvcsw,
          usage.ru_minflt + usage.ru_majflt};
}

}  // namespace quickstrip
