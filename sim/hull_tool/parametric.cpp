// quickstrip-hull parametric: the ships that are given by formulas, as hull files.
#include <memory>
#include <string>
#include <vector>

#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_file_text.hpp"
#include "msgs/files/text_file.hpp"
#include "sim/hull_tool/advisor_check.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/parametric_ships.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string ship;
  std::string out;
};

void run(const Options& options) {
  const auto hull = std::make_unique<Hull>();
  const std::string_view comment = make_parametric_ship(options.ship, *hull);
  const std::string text = hull_file_text(*hull, comment);
  advisor_roll_period(*float_hull_text(text, options.out));  // one that the advisor takes
  require(write_text_file(text, options.out));
}

}  // namespace

void add_parametric(CLI::App& app) {
  CLI::App* command = app.add_subcommand("parametric",
                                         "A hull file of a ship that is given by formulas: tanker, trawler, "
                                         "Wigley hulls");
  const auto options = std::make_shared<Options>();
  command->add_option("SHIP", options->ship, "tanker, trawler, wigley-i, wigley-ii, wigley-iii or wigley-iv")
      ->required()
      ->type_name("")
      ->check(CLI::IsMember(std::vector<std::string>(kParametricShips.begin(), kParametricShips.end())));
  command->add_option("--out", options->out, "hull file to be written")->required()->type_name("FILE");
  command->footer(
      "Tanker and trawler have the size and roll damping of the ships of [Journee1992] section 5; their "
      "lines\n"
      "are ours. Other ships of the kind: quickstrip-hull transform.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
