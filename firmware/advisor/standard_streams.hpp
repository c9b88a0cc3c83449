// Standard error that may be closed, broken, full, or on a full disk: none of it ends the program or holds it
// up.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace quickstrip {

/// Once, before anything is opened: descriptors 0, 1 and 2 that are closed become /dev/null, so that no
/// socket or file takes their place and is written to by what is meant for the journal; SIGPIPE is ignored; a
/// pipe or socket that nobody reads loses lines, it does not hold up the program.
void hold_standard_streams();

/// A line on standard error; lost where it cannot be written. (fmt::print would throw.)
template <typename... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
  const std::string line = fmt::format(format, std::forward<Args>(args)...) + "\n";
  static_cast<void>(std::fputs(line.c_str(), stderr));
}

}  // namespace quickstrip
