// quickstrip-hull: ashore, everything about a hull file. Exit 0 done, 1 the input is bad, 2 wrong use.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/input_error.hpp"

namespace {

constexpr int kBadInput = 1;
constexpr int kWrongUse = 2;

int run(int argc, char** argv) {
  CLI::App app("Checks a hull file and prints what Quickstrip computes from it", "quickstrip-hull");
  app.set_version_flag("--version", "quickstrip-hull " QUICKSTRIP_VERSION);
  app.require_subcommand(1);
  quickstrip::hull_tool::add_commands(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongUse;  // help and version end here too, with 0
  } catch (const quickstrip::hull_tool::InputError& error) {
    fmt::print(stderr, "{}\n", error.line);
    return kBadInput;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // memory, locale: nothing of ours
    std::fprintf(stderr, "quickstrip-hull: %s\n", error.what());
    return kBadInput;
  }
}
