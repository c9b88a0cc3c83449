// Standard error that may be closed, broken, full, or on a full disk: none of it ends the program or holds it
// up.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace quickstrip {

/// Once, before anything is opened: descriptors 0, 1 and 2 that are closed become /dev/null, so that no
/// socket or file takes their place and is written to by what is meant for the journal; SIGPIPE is ignored; a
/// pipe or socket that nobody reads loses lines, it does not hold up the program.
void hold_standard_streams();

/// A line on standard error, its end added; at most 4 kB, what a pipe takes whole or not at all. False: lost,
/// after a moment's patience.
bool write_line(std::string_view line);

/// The same, worded here. (fmt::print would throw.)
template <typename... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
  write_line(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace quickstrip
