// The advisor on a Cortex-M7: frames come in on the serial line, a cycle runs for each QS_TIME, advice goes
// out (FRAMING.md). The ship is built in. No heap: the program does not link if something asks for it.
#include <cstddef>
#include <memory>
#include <new>
#include <optional>

#include "core/base/check.hpp"
#include "firmware/cortex-m7/board/console.hpp"
#include "firmware/cortex-m7/board/mps2_an500.hpp"
#include "firmware/cortex-m7/serial/serial_session.hpp"
#include "firmware/cortex-m7/ship/ship.hpp"

namespace {

using namespace quickstrip;

// Built in place when the program starts: an initialised object would lie in flash a second time.
alignas(SerialSession) std::byte session_memory[sizeof(SerialSession)];
Hull hull;
Criteria criteria;

void say_failed_check(const char* claim, const char* file, int line) {
  board::print(file);
  board::print(":");
  board::print_number(static_cast<std::uint32_t>(line));
  board::print(": failed: ");
  board::print(claim);
  board::print("\n");
  board::stop(73);
}

[[noreturn]] void refuse(const char* what) {
  board::print("refused at start: ");
  board::print(what);
  board::print("\n");
  board::stop(1);
}

const HullTable* open_table() {
  static std::optional<HullTable> table;
  if (ship::table_words().empty()) {
    return nullptr;
  }
  const Result<HullTable> view = HullTable::view(ship::table_words());
  if (!view) {
    refuse(message(view.error()));
  }
  if (const Status same = view->check_hull(hull); !same) {
    refuse(message(same.error()));
  }
  table = *view;
  return &*table;
}

}  // namespace

extern "C" int board_main();

int board_main() {
  static board::Mps2An500 machine;
  set_check_handler(say_failed_check);
  machine.start();
  auto* const session = new (session_memory) SerialSession(machine);
  // In the hull's memory, before she comes into it.
  if (const SelfTestItem failed = session->self_test(hull); failed != SelfTestItem::kNone) {
    refuse(message(failed));
  }
  std::construct_at(&hull);
  ship::fill(hull);
  ship::fill(criteria);
  SessionOptions options;
  options.log_clock = true;
  options.profile = ship::profile();
  options.version = Name(QUICKSTRIP_VERSION " m7");
  options.table = open_table();
  if (const Status status = session->configure(hull, criteria, options); !status) {
    refuse(message(status.error()));
  }
  board::print("ready\n");
  for (;;) {
    session->take(machine.next_byte());
  }
}
