#include "sim/hull_tool/parent_options.hpp"

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "msgs/cli/run_tool.hpp"

namespace quickstrip::hull_tool {

void add_parent_choice(CLI::App& command, const std::string& name, ParentChoice& choice,
                       const std::string& description) {
  command.add_option(name, choice.sections, description)
      ->check(CLI::IsMember({"close-fit", "frank", "lewis"}))
      ->type_name("");
  command
      .add_option("--potentials", choice.potentials,
                  "of boundary-value loads by the parent: at the frequency of encounter or the wave's")
      ->check(CLI::IsMember({"encounter", "wave"}))
      ->capture_default_str()
      ->type_name("");
}

std::unique_ptr<ParentShip> load_parent(const StripOptions& options, const ParentChoice& choice) {
  return load_parent(options, choice, options.method.method());
}

std::unique_ptr<ParentShip> load_parent(const StripOptions& options, const ParentChoice& choice,
                                        const StripMethod& method) {
  const std::unique_ptr<FloatingHull> floating = float_hull(options.file, options.loading);
  ParentOptions parent_options;
  parent_options.sections = choice.sections == "frank"   ? SectionMethod::kFrank
                            : choice.sections == "lewis" ? SectionMethod::kLewis
                                                         : SectionMethod::kCloseFit;
  parent_options.diffracts_at_encounter = choice.potentials == "encounter";
  parent_options.num_threads = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
  try {
    auto parent = std::make_unique<ParentShip>(floating->hull, floating->loading, method, parent_options);
    if (options.roll_damping_ratio) {
      parent->set_roll_damping_ratio(*options.roll_damping_ratio);
    }
    return parent;
  } catch (const std::invalid_argument& error) {
    throw InputError{options.file + ": " + error.what()};
  }
}

}  // namespace quickstrip::hull_tool
