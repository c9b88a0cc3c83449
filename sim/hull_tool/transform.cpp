// quickstrip-hull transform: the same ship with another block coefficient, centre of buoyancy or size, as a
// hull file of its own ([Journee1992] §5, Figure 3).
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_file_text.hpp"
#include "msgs/files/text_file.hpp"
#include "sim/hull_tool/advisor_check.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/hull_scale.hpp"
#include "sim/hull_tool/station_shift.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr double kShortest = 1.0;   // m: lengths that a hull file may have
constexpr double kLongest = 500.0;  // m

struct Options {
  std::string file;
  std::string out;
  std::string name;
  std::optional<double> lcb_m;
  std::optional<double> lcb_lpp;
  double cb = 0.0;
  double scale = 1.0;
};

FormChange change_of(const Options& options, const Hull& hull) {
  return {options.cb, options.lcb_m ? *options.lcb_m : options.lcb_lpp.value_or(0.0) * hull.lpp};
}

void refuse_size(const Options& options, const Hull& hull) {
  const double lpp = options.scale * hull.lpp;
  if (!(lpp >= kShortest && lpp <= kLongest)) {
    throw InputError{fmt::format("--scale = {:g}: lpp would be {:g} m; {:.4g} ... {:.4g} is possible for {}",
                                 options.scale, lpp, kShortest / hull.lpp, kLongest / hull.lpp,
                                 options.file)};
  }
}

void refuse_same_file(const Options& options) {
  std::error_code not_there;
  if (std::filesystem::equivalent(options.file, options.out, not_there)) {
    throw InputError{fmt::format("--out = {}: the hull file itself; another name is wanted", options.out)};
  }
}

std::string too_much(const Options& options, const FormChange& change, const FloatingHull& ship) {
  const double share = possible_share(ship.hull, ship.sections, ship.hydrostatics, change);
  std::string wanted;
  std::string possible;
  const auto add = [&](const char* option, double value) {
    wanted += fmt::format("{}{} = {:g}", wanted.empty() ? "" : ", ", option, value);
    possible += fmt::format("{}{:g}", possible.empty() ? "" : " and ",
                            std::trunc(1000.0 * share * value) / 1000.0);  // never more than can be done
  };
  if (change.cb != 0.0) {
    add("--change-cb", options.cb);
  }
  if (change.lcb != 0.0) {
    options.lcb_m ? add("--shift-lcb-m", *options.lcb_m) : add("--shift-lcb-lpp", *options.lcb_lpp);
  }
  return fmt::format("{}: the stations of {} would crowd: {} {} possible", wanted, options.file, possible,
                     change.cb != 0.0 && change.lcb != 0.0 ? "together are" : "is");
}

std::unique_ptr<ShiftedHull> moved(const Options& options, const FloatingHull& ship,
                                   const FormChange& change) {
  auto out = std::make_unique<ShiftedHull>();
  out->hull = ship.hull;
  out->hydrostatics = ship.hydrostatics;
  if (change.cb == 0.0 && change.lcb == 0.0) {
    return out;
  }
  const Status shifted = shift_stations(ship.hull, ship.sections, ship.hydrostatics, change, *out);
  if (shifted) {
    return out;
  }
  if (shifted.error() != Error::kOutOfRange) {
    throw InputError{explain(shifted.error(), ship, {})};
  }
  throw InputError{too_much(options, change, ship)};
}

// "(changed)" behind the name, what does not fit cut at a character's beginning.
std::string new_name(const Options& options, const Hull& hull) {
  if (options.name.size() >= kMaxNameBytes) {
    throw InputError{
        fmt::format("--name: {} bytes: at most {} are possible", options.name.size(), kMaxNameBytes - 1)};
  }
  if (!options.name.empty()) {
    return options.name;
  }
  const std::string ending = " (changed)";
  std::string name(hull.name.view());
  if (name.ends_with(ending)) {
    return name;
  }
  std::size_t length = std::min(name.size(), kMaxNameBytes - 1 - ending.size());
  while (length > 0 && length < name.size() && (static_cast<unsigned char>(name[length]) & 0xC0U) == 0x80U) {
    --length;  // inside a character of several bytes
  }
  return name.substr(0, length) + ending;
}

std::string provenance(const Options& options, const FormChange& change, const FloatingHull& ship) {
  std::string text =
      fmt::format("Made by quickstrip-hull transform from {} ({}):",
                  std::filesystem::path(options.file).filename().string(), ship.hull.name.view());
  text += fmt::format(" CB {:+g}, LCB {:+g} m ({:+.4f} lpp), then scale {:g}.", change.cb, change.lcb,
                      change.lcb / ship.hull.lpp, options.scale);
  text +=
      "\nSections moved along the ship, each with its form (Lackenby 1950): ends, midship section, breadth,"
      "\ndraughts, KG, gyradii and the places watched stayed; GM is what follows. Size by Froude's law.";
  return text;
}

std::string as_csv(const FloatingHull& before, const FloatingHull& after) {
  const Hydrostatics& b = before.hydrostatics;
  const Hydrostatics& a = after.hydrostatics;
  Csv csv("quantity,before,after");
  const auto add = [&csv](const char* name, double from, double to) {
    csv.add(name).add(from).add(to).end_row();
  };
  add("lpp_m", before.hull.lpp, after.hull.lpp);
  add("displacement_t", b.displacement / 1000.0, a.displacement / 1000.0);
  add("cb", b.cb, a.cb);
  add("lcb_m", b.lcb, a.lcb);
  add("lcb_lpp", b.lcb / before.hull.lpp, a.lcb / after.hull.lpp);
  add("cm", b.cm, a.cm);
  add("cwp", b.cwp, a.cwp);
  add("kb_m", b.kb, a.kb);
  add("bm_m", b.bm, a.bm);
  add("kg_m", b.kg, a.kg);
  add("gm_m", b.gm, a.gm);
  add("roll_period_s", advisor_roll_period(before), advisor_roll_period(after));
  return csv.text();
}

void run(const Options& options) {
  const auto before = float_hull(options.file);
  refuse_same_file(options);
  refuse_size(options, before->hull);
  const FormChange change = change_of(options, before->hull);
  const auto changed = moved(options, *before, change);
  Hull& hull = changed->hull;
  hull.name = Name(new_name(options, hull));
  const bool is_reshaped = change.cb != 0.0 || change.lcb != 0.0;
  if (is_reshaped && hull.loading.measured_roll_period) {
    fmt::print(stderr, "note: {}: loading.measured_roll_period_s belongs to the old form; left out\n",
               options.file);
    hull.loading.measured_roll_period.reset();
  }
  if (is_reshaped && hull.loading.gm) {
    fmt::print(stderr, "note: {}: loading.gm_m = {:g} is kept, though the new form has another BM\n",
               options.file, *hull.loading.gm);
  }
  scale_by_froude(hull, options.scale);
  const std::string text = hull_file_text(hull, provenance(options, change, *before));
  const auto after = float_hull_text(text, options.out);
  const std::string table = as_csv(*before, *after);  // the advisor takes both, or nothing is written
  require(write_text_file(text, options.out));
  if (is_reshaped) {
    fmt::print(stderr, "note: {}: lpp, breadth, draughts, midship section, KG, gyradii and places are kept\n",
               options.out);
  }
  print_result(table);
}

}  // namespace

void add_transform(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "transform", "A hull file of the same ship with another CB, LCB or size; prints before and after");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  command->add_option("--out", options->out, "hull file to be written")->required()->type_name("FILE");
  command->add_option("--name", options->name, "name of the new ship; default: the old one's, \"(changed)\"")
      ->type_name("");
  CLI::Option* lcb_m = add_number(*command, "--shift-lcb-m", options->lcb_m, {-50.0, 50.0},
                                  "centre of buoyancy forward by so much, of the ship as given [m]");
  CLI::Option* lcb_lpp = add_number(*command, "--shift-lcb-lpp", options->lcb_lpp, {-0.1, 0.1},
                                    "the same in parts of lpp; the paper's figure has -0.015 ... 0.015");
  lcb_m->excludes(lcb_lpp);
  add_number(*command, "--change-cb", options->cb, {-0.3, 0.3},
             "added to the block coefficient; the paper's figure has -0.04 ... 0.04");
  add_number(*command, "--scale", options->scale, {0.001, 1000.0},
             "size by Froude's law, after the others; the paper's figure has 0.50 ... 1.50");
  command->footer(
      "CB and LCB: sections move along the ship, each with its form (Lackenby 1950), until the hydrostatics\n"
      "are those wanted; lpp, breadth, draughts, the midship section, KG, gyradii, points, bilge keels,\n"
      "slamming stations and freeboards stay, so GM and the roll period change: both are printed.\n"
      "Size: lengths x scale; speeds of the grid, steerage and measured roll period x sqrt(scale); water "
      "stays.\n"
      "FILE is complete; comments of HULL are lost, values that it left to defaults are written out.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
