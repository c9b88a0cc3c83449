// QS_CHECK: an always-on check for our own errors (never for input: that is Result's).
// A failed check calls the handler (which may write one line to a journal) and then traps; it does not
// return.
#pragma once

namespace quickstrip {

using CheckHandler = void (*)(const char* claim, const char* file, int line);

/// Installs the handler that is called before the program stops; nullptr: none. Not thread-safe: call at
/// start.
void set_check_handler(CheckHandler handler);

[[noreturn]] void check_failed(const char* claim, const char* file, int line);

}  // namespace quickstrip

#define QS_CHECK(claim)                                       \
  do {                                                        \
    if (!(claim)) {                                           \
      ::quickstrip::check_failed(#claim, __FILE__, __LINE__); \
    }                                                         \
  } while (false)
