// quickstrip-m7-on-host: the board's session, profile m7, on this machine: frames on standard input, frames
// on standard output. What the emulated board is compared with.
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "firmware/cortex-m7/serial/serial_session.hpp"
#include "firmware/cortex-m7/ship/ship.hpp"

namespace {

using namespace quickstrip;

class StandardStreams final : public Board {
 public:
  void put(std::span<const std::uint8_t> bytes) override {
    static_cast<void>(std::fwrite(bytes.data(), 1, bytes.size(), stdout));
  }
  std::uint64_t timer_us() override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(now).count());
  }
};

}  // namespace

int main() {
  StandardStreams board;
  const auto session = std::make_unique<SerialSession>(board);
  const auto hull = std::make_unique<Hull>();
  if (const SelfTestItem failed = session->self_test(*hull); failed != SelfTestItem::kNone) {
    std::fprintf(stderr, "%s\n", message(failed));
    return 1;
  }
  std::construct_at(hull.get());
  Criteria criteria;
  ship::fill(*hull);
  ship::fill(criteria);
  const Result<HullTable> table = HullTable::view(ship::table_words());
  if (!table || !table->check_hull(*hull)) {
    std::fputs("the hull table is refused\n", stderr);
    return 1;
  }
  SessionOptions options;
  options.log_clock = true;
  options.profile = ship::profile();
  options.version = Name("on host");
  options.table = &*table;
  if (const Status status = session->configure(*hull, criteria, options); !status) {
    std::fprintf(stderr, "%s\n", message(status.error()));
    return 1;
  }
  std::array<std::uint8_t, 4096> bytes{};
  for (;;) {
    const auto num = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (num <= 0) {
      return 0;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(num); ++i) {
      session->take(bytes[i]);
    }
    static_cast<void>(std::fflush(stdout));
  }
}
