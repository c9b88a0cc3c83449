// A system clock that a test steps: preloaded, it shifts CLOCK_REALTIME by the nanoseconds that the file
// QS_CLOCK_OFFSET_FILE holds (eight bytes, in this machine's order), read anew at each call. Other clocks
// stay as they are.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static const int64_t kBillion = 1000000000;
static _Atomic(const int64_t*) g_offset_ns;
static const int64_t kNoOffset;

static int64_t offset_ns(void) {
  const int64_t* offset = g_offset_ns;
  if (offset == NULL) {
    const char* const file = getenv("QS_CLOCK_OFFSET_FILE");
    const int fd = file == NULL ? -1 : open(file, O_RDONLY | O_CLOEXEC);
    void* const map = fd < 0 ? MAP_FAILED : mmap(NULL, sizeof(int64_t), PROT_READ, MAP_SHARED, fd, 0);
    offset = map == MAP_FAILED ? &kNoOffset : map;
    if (fd >= 0) {
      close(fd);
    }
    g_offset_ns = offset;
  }
  return __atomic_load_n(offset, __ATOMIC_RELAXED);
}

int clock_gettime(clockid_t clock, struct timespec* out) {
  const int result = (int)syscall(SYS_clock_gettime, clock, out);
  if (result == 0 && clock == CLOCK_REALTIME) {
    const int64_t time = (int64_t)out->tv_sec * kBillion + out->tv_nsec + offset_ns();
    out->tv_sec = time / kBillion;
    out->tv_nsec = time % kBillion;
  }
  return result;
}
