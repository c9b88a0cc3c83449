#include "msgs/cli/method_options.hpp"

#include <string>
#include <vector>

namespace quickstrip {
namespace {

void add_choice(CLI::App& command, const char* name, std::optional<std::string>& value,
                const std::vector<std::string>& choices, const std::string& description) {
  command.add_option(name, value, description + "; default " + choices.front())
      ->check(CLI::IsMember(choices))
      ->type_name("")
      ->group("METHOD");
}

}  // namespace

StripMethod MethodOptions::method() const {
  StripMethod method = paper ? kPaperMethod : StripMethod{};
  if (variant) {
    method.variant = *variant == "ordinary" ? StripVariant::kOrdinary : StripVariant::kModified;
  }
  if (end_terms) {
    method.end_terms = *end_terms == "on";
  }
  if (loads) {
    method.loads = *loads == "haskind"   ? DiffractionLoads::kHaskind
                   : *loads == "classic" ? DiffractionLoads::kClassic
                                         : DiffractionLoads::kBoundaryValue;
  } else if (!table.empty() && !paper) {
    method.loads = DiffractionLoads::kBoundaryValue;
  }
  if (surge) {
    method.surge = *surge == "full" ? SurgeTerms::kFull : SurgeTerms::kInertiaOnly;
  }
  if (low_encounter) {
    method.low_encounter = *low_encounter == "floor" ? LowEncounterRule::kFloor : LowEncounterRule::kPaper;
  }
  if (swell_up) {
    method.swell_up = *swell_up == "onboard" ? SwellUp::kOnboard : SwellUp::kOff;
  }
  return method;
}

void add_method_options(CLI::App& command, MethodOptions& options) {
  command
      .add_option("--table", options.table,
                  "compiled table of the hull's own sections (quickstrip-hull compile); else Lewis forms")
      ->type_name("FILE")
      ->group("METHOD");
  add_choice(command, "--method", options.variant, {"ordinary", "modified"}, "strip theory");
  add_choice(command, "--end-terms", options.end_terms, {"on", "off"},
             "jump of added mass at the hull's ends");
  add_choice(command, "--loads", options.loads, {"haskind", "classic", "boundary-value"},
             "diffraction loads; boundary-value needs a hull table and is the default with one");
  add_choice(command, "--surge", options.surge, {"full", "inertia-only"}, "surge coefficients");
  add_choice(command, "--low-encounter", options.low_encounter, {"floor", "paper"},
             "rule near zero encounter frequency");
  add_choice(command, "--swell-up", options.swell_up, {"onboard", "off"},
             "the ship's own waves in relative motion and freeboard (off: the unsafe side)");
  command
      .add_flag("--paper", options.paper,
                "as [Journee1992]: ordinary, end terms on, classic, paper, pressures on Lewis contours, "
                "swell-up off")
      ->group("METHOD");
}

}  // namespace quickstrip
