#include "msgs/cli/run_tool.hpp"

#include <cstdio>
#include <exception>
#include <string>

namespace quickstrip {
namespace {

constexpr int kBadInput = 1;
constexpr int kWrongUse = 2;

int say(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
  return kBadInput;
}

bool has_config_file(const CLI::App& app) {
  const CLI::Option* const option = app.get_config_ptr();
  return option != nullptr && option->count() > 0;
}

/// As it was given.
std::string config_file(const CLI::App& app) {
  return has_config_file(app) ? app.get_config_ptr()->results().front() : "--config";
}

}  // namespace

void require(const FileStatus& status) {
  if (!status) {
    throw InputError{status.line()};
  }
}

void add_config_option(CLI::App& app) {
  app.set_config("--config", "",
                 "File that holds options: `cycle-s = 0.5`, one a line; the command line wins");
  app.allow_config_extras(CLI::config_extras_mode::error);
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& run) {
  try {
    app.parse(argc, argv);
    if (run) {
      run();
    }
    return 0;
  } catch (const CLI::ConfigError& error) {
    const std::string words = error.what();  // "INI was not able to parse KEY"
    return say(config_file(app) + ": " + words.substr(words.rfind(' ') + 1) +
               ": no such option; --help lists them");
  } catch (const CLI::FileError& error) {
    return say(std::string("--config: ") + error.what());
  } catch (const CLI::ParseError& error) {
    const bool is_wrong_use = app.exit(error) != 0;  // help and version end here too, with 0
    if (is_wrong_use && has_config_file(app)) {
      say("(options were read from " + config_file(app) + " too)");
    }
    return is_wrong_use ? kWrongUse : 0;
  } catch (const InputError& error) {
    return say(error.line);
  } catch (const std::exception& error) {  // memory, locale: nothing of ours
    return say(app.get_name() + ": " + error.what());
  }
}

}  // namespace quickstrip
