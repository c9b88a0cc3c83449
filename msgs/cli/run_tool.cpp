#include "msgs/cli/run_tool.hpp"

#include <cstdio>
#include <exception>

namespace quickstrip {
namespace {

constexpr int kBadInput = 1;
constexpr int kWrongUse = 2;

int say(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
  return kBadInput;
}

}  // namespace

void require(const FileStatus& status) {
  if (!status) {
    throw InputError{status.line()};
  }
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& run) {
  try {
    app.parse(argc, argv);
    if (run) {
      run();
    }
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongUse;  // help and version end here too, with 0
  } catch (const InputError& error) {
    return say(error.line);
  } catch (const std::exception& error) {  // memory, locale: nothing of ours
    return say(app.get_name() + ": " + error.what());
  }
}

}  // namespace quickstrip
