// quickstrip-hull validate: what [Journee1992] §5 compares, by the program on board and by the parent, in a
// list of long-crested seas.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/advice/cell_response.hpp"
#include "core/response/local_watch.hpp"
#include "core/response/mean_added_resistance.hpp"
#include "core/response/moments.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/parent_options.hpp"
#include "sim/hull_tool/spectrum_options.hpp"
#include "sim/parent/parent_course.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  ParentChoice parent{.sections = "close-fit"};
  double speed_kn = 0.0;
  double mu_deg = 135.0;
  std::string shape;
  std::vector<double> heights;
  std::vector<double> periods;
};

void require(Status status) {
  if (!status) {
    throw InputError{std::string(message(status.error()))};
  }
}

/// The point of the paper: 75 % of lpp from aft, 75 % of the half-breadth to port, half the draught amidships
/// above the waterline; slamming where the hull file has it; heave and pitch.
void list_watch(const FloatingHull& floating, SwellUp swell_up, Watch& out) {
  const auto ship = std::make_unique<Watch>();
  require(list_channels(floating.hull, floating.loading, floating.hydrostatics, swell_up, *ship));
  require(begin_local_watch(*ship, out));
  const Hull& hull = floating.hull;
  const double draught = 0.5 * (floating.loading.draught_aft + floating.loading.draught_fwd);
  const Position point{0.75 * hull.lpp - floating.hydrostatics.lcb, 0.375 * hull.breadth,
                       1.5 * draught - floating.hydrostatics.kg};
  require(add_local_motions(point, 0, true, ship->gravity, out));
  for (const Quantity wanted : {Quantity::kSlamming, Quantity::kHeave, Quantity::kPitch}) {
    const std::size_t c = find_channel(*ship, wanted, 0);
    if (c < ship->channels.size() && !out.channels.push_back(ship->channels[c])) {
      throw InputError{"too many channels"};
    }
  }
}

/// In the order of list_rows().
std::vector<double> values_of(const Watch& watch, double speed, const std::vector<ResponseMoments>& moments,
                              double resistance) {
  const auto of = [&](Quantity quantity) {
    const std::size_t c = find_channel(watch, quantity, 0);
    return c < watch.channels.size() ? quantity_response(watch.channels[c], speed, moments[c])
                                     : QuantityResponse{.quantity = quantity};
  };
  const QuantityResponse slams = of(Quantity::kSlamming);
  return {of(Quantity::kLongitudinalAcceleration).significant,
          of(Quantity::kLateralAcceleration).significant,
          of(Quantity::kVerticalAcceleration).significant,
          resistance,
          slams.per_hour < 0.0 ? 0.0 : slams.per_hour,
          of(Quantity::kHeave).significant,
          of(Quantity::kRoll).significant,
          of(Quantity::kPitch).significant,
          slams.rms};
}

struct Named {
  const char* name;
  const char* unit;
};
constexpr std::array<Named, 9> kQuantities = {{{"longitudinal_acceleration", "m/s2"},
                                               {"lateral_acceleration", "m/s2"},
                                               {"vertical_acceleration", "m/s2"},
                                               {"added_resistance", "N"},
                                               {"slamming", "1/h"},
                                               {"heave", "m"},
                                               {"roll", "rad"},
                                               {"pitch", "rad"},
                                               {"relative_motion_rms", "m"}}};

/// The program on board, solved for one speed and every direction.
struct Quick {
  StripShip ship;
  Watch watch;
  TransferFunctions transfer;
  TransferWorkspace work;
  SeaEnergy sea;
};

std::vector<double> quick_values(const WaveSystem& system, double speed, Quick& quick) {
  SeaState state;
  static_cast<void>(state.systems.push_back(system));
  const TransferFunctions& transfer = quick.transfer;
  require(place_on_grid(state, std::span(transfer.omega).first(transfer.num_frequencies), quick.sea));
  std::vector<ResponseMoments> moments(quick.watch.channels.size());
  const auto found = response_moments(transfer, quick.watch, quick.sea, Heading{0.0}, speed, moments);
  const auto resistance = mean_added_resistance(transfer, quick.sea, Heading{0.0}, speed);
  require(found ? Status() : Status(found.error()));
  require(resistance ? Status() : Status(resistance.error()));
  return values_of(quick.watch, speed, moments, resistance->strip);
}

/// True sections of a hull table bring the real contours with them in --paper as well.
std::unique_ptr<Quick> load_quick(const Options& options, double speed) {
  auto quick = std::make_unique<Quick>();
  quick->ship = load_strip_ship(options.strip);
  LoadedHull& loaded = *quick->ship.loaded;
  if (quick->ship.table && loaded.method.contour == WaveContour::kLewis) {
    StripMethod method = loaded.method;
    method.contour = WaveContour::kOffsets;
    const FloatingHull& floating = *quick->ship.floating;
    require(load(floating.hull, floating.loading, method, loaded, &quick->ship.table->view));
    if (options.strip.roll_damping_ratio) {
      set_roll_damping_ratio(loaded, *options.strip.roll_damping_ratio);
    }
  }
  list_watch(*quick->ship.floating, loaded.method.swell_up, quick->watch);
  require(solve_transfer_functions(loaded, std::span(&speed, 1), quick->work, quick->transfer));
  return quick;
}

/// The parent takes the pressure on the hull's own contour, and boundary values unless the loads are classic.
std::unique_ptr<ParentShip> load_own_parent(const Options& options, StripMethod method) {
  method.contour = WaveContour::kOffsets;
  if (method.loads != DiffractionLoads::kClassic) {
    method.loads = DiffractionLoads::kBoundaryValue;
  }
  return load_parent(options.strip, options.parent, method);
}

void run(const Options& options) {
  if (options.heights.size() != options.periods.size()) {
    throw CLI::ValidationError("--hs-m, --t1-s", "as many of one as of the other");
  }
  const double speed = from_knots(options.speed_kn);
  const EncounterAngle mu{wrap_pi(radians(options.mu_deg))};
  const std::unique_ptr<Quick> quick = load_quick(options, speed);
  const std::unique_ptr<ParentShip> parent = load_own_parent(options, quick->ship.loaded->method);
  const TransferFunctions& transfer = quick->transfer;
  const std::vector<double> omegas = parent_frequencies(
      parent->hull(), mu, speed, std::span(transfer.omega).first(transfer.num_frequencies));
  const ParentCourse course(*parent, mu, speed, omegas);
  Csv csv("speed_kn,mu_deg,hs_m,t1_s,quantity,unit,quick,parent,difference_percent");
  for (std::size_t s = 0; s < options.heights.size(); ++s) {
    const SpectrumOptions sea{options.shape, options.heights[s], options.periods[s], 0.0};
    const WaveSystem system = sea.sea_from(WaveFrom{wrap_two_pi(kPi - mu.radians)}).systems[0];
    const Result<Spectrum> spectrum = spectrum_of(system);
    require(spectrum ? Status() : Status(spectrum.error()));
    const ParentStatistics truth = course.respond(*spectrum, quick->watch);
    const std::vector<double> own = quick_values(system, speed, *quick);
    const std::vector<double> theirs = values_of(quick->watch, speed, truth.moments, truth.added_resistance);
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      csv.add(options.speed_kn).add(options.mu_deg).add(sea.hs).add(sea.t1);
      csv.add(kQuantities[q].name).add(kQuantities[q].unit).add(own[q]).add(theirs[q]);
      csv.add(theirs[q] != 0.0 ? std::optional<double>(100.0 * (own[q] / theirs[q] - 1.0)) : std::nullopt);
      csv.end_row();
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_validate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "validate", "Accelerations, added resistance and slamming beside the parent program's, by sea");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_parent_choice(*command, "--sections", options->parent, "the parent's sections; default close-fit");
  add_number(*command, "--speed-kn", options->speed_kn, {0.0, 60.0}, "speed [kn]")->required();
  add_number(*command, "--mu-deg", options->mu_deg, kDirections_deg,
             "wave direction: 0 following, 90 from starboard, 180 head [deg]; default 135");
  command->add_option("--spectrum", options->shape, "shape of the wave spectra")
      ->check(CLI::IsMember({"bretschneider", "jonswap", "neumann"}))
      ->required();
  add_list(*command, "--hs-m", options->heights, {0.01, 30.0}, "significant wave heights [m]")->required();
  add_list(*command, "--t1-s", options->periods, {1.0, 40.0}, "mean periods T1, one for each height [s]")
      ->required();
  command->footer(
      "quick: the program on board as METHOD has it, with Lewis forms or --table. parent: the flow about "
      "true "
      "sections solved at some 250 frequencies, pressures on the real contours, the same loads (boundary "
      "values where METHOD has haskind). Significant amplitudes; accelerations at the point of "
      "[Journee1992]: "
      "0.75 lpp from aft, 0.75 of the half-breadth to port, half the draught above the waterline; slamming "
      "at "
      "the hull file's first station, relative_motion_rms there.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
