#include "sim/hull_tool/spectrum_options.hpp"

#include "msgs/cli/list_option.hpp"

namespace quickstrip::hull_tool {

SeaState SpectrumOptions::sea_from(WaveFrom from) const {
  WaveSystem system;
  system.hs = hs;
  system.period = t1;
  system.period_kind = PeriodKind::kMean;
  system.from = from;
  system.spreading = radians(spreading_deg);
  system.shape = shape == "jonswap"   ? SpectrumShape::kJonswap
                 : shape == "neumann" ? SpectrumShape::kNeumann
                                      : SpectrumShape::kBretschneider;
  SeaState sea;
  static_cast<void>(sea.systems.push_back(system));  // the first of kMaxWaveSystems
  return sea;
}

void add_spectrum_options(CLI::App& command, SpectrumOptions& options, bool required) {
  CLI::Option* shape = command.add_option("--spectrum", options.shape, "shape of the wave spectrum")
                           ->check(CLI::IsMember({"bretschneider", "jonswap", "neumann"}));
  CLI::Option* hs = add_number(command, "--hs-m", options.hs, {0.01, 30.0}, "significant wave height [m]");
  CLI::Option* t1 = add_number(command, "--t1-s", options.t1, {1.0, 40.0}, "mean period T1 = Tm01 [s]");
  add_number(command, "--spreading-deg", options.spreading_deg, {0.0, 80.0},
             "circular standard deviation of cos^2s(theta/2); 0: long-crested [deg]")
      ->needs(shape);
  shape->needs(hs)->needs(t1);
  shape->required(required);
}

}  // namespace quickstrip::hull_tool
