// --allow-source, as the advisor and the replay have it. `AllowList`: firmware/session's, which knows nothing
// of command lines.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "msgs/files/printable.hpp"

namespace quickstrip {

template <typename AllowList>
void add_allow_source_option(CLI::App& app, AllowList& allowed) {
  app.add_option_function<std::vector<std::string>>(
      "--allow-source",
      [&allowed](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
          if (!allowed.read(text)) {
            throw CLI::ValidationError(
                "--allow-source",
                fmt::format("{}: CHANNEL=ID[,ID...] is wanted, e.g. SEA_STATE=3, at most {} "
                            "ids of a channel",
                            printable(text, 100), AllowList::kMaxSources));
          }
        }
      },
      "Whose messages are taken, e.g. SEA_STATE=3 OWN_SHIP=1,2; default everybody's");
}

}  // namespace quickstrip
