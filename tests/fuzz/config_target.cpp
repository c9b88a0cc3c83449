// A configuration file: any bytes are options or a refusal, never a way out of run_tool().
#include <array>
#include <string>

#include "msgs/cli/run_tool.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/targets.hpp"

namespace quickstrip::fuzz {

void run_config(std::span<const std::uint8_t> bytes) {
  static MemoryFile file;
  file.fill(bytes);
  CLI::App app("of a configuration file", "fuzz");
  double cycle_s = 1.0;
  std::string hull;
  int priority = 50;
  bool is_quiet = false;
  app.add_option("--cycle-s", cycle_s)->check(CLI::Range(0.05, 60.0));
  app.add_option("--hull", hull);
  app.add_option("--priority", priority)->check(CLI::Range(1, 99));
  app.add_flag("--quiet", is_quiet);
  add_config_option(app);
  std::string program = "fuzz";
  std::string option = "--config";
  std::string path = file.path();
  std::array<char*, 4> words{program.data(), option.data(), path.data(), nullptr};
  const int code = run_tool(app, 3, words.data());
  require(code >= 0 && code <= 2, "a program of ours ends with 0, 1 or 2");
  require(code != 0 || (cycle_s >= 0.05 && cycle_s <= 60.0 && priority >= 1 && priority <= 99),
          "what is accepted is in its range");
}

std::vector<Bytes> config_seeds() {
  const std::string good =
      "# a comment\ncycle-s = 0.5\nhull = \"ship.hull.toml\"\npriority = 40\nquiet = true\n";
  return {Bytes(good.begin(), good.end())};
}

}  // namespace quickstrip::fuzz
