#include "sim/hull_tool/frequency_sets.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/check.hpp"
#include "core/response/mean_added_resistance.hpp"
#include "core/response/moments.hpp"
#include "core/response/short_term.hpp"
#include "core/sea/dispersion.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/sea/spectrum.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/motion_spline.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr std::size_t kReferenceFrequencies = 2000;
constexpr double kReferenceFrom = 0.05;  // rad/s
constexpr int kRepeats = 3;              // of what is timed

using Clock = std::chrono::steady_clock;

/// The least of `repeats` runs: what the machine does beside is not the set's.
template <typename Work>
double least_seconds(int repeats, Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const auto start = Clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

struct Case {
  const LoadedHull& hull;
  const Watch& watch;
  Spectrum spectrum;
  EncounterAngle mu;
  double speed = 0.0;
};

std::vector<MotionTransfer> solve_all(const Case& c, const std::vector<double>& omegas) {
  std::vector<MotionTransfer> out;
  out.reserve(omegas.size());
  for (const double omega : omegas) {
    out.push_back(motion_transfer(c.hull, omega, c.mu, c.speed));
  }
  return out;
}

/// |H|^2 of a channel.
double energy_of(const Case& c, const Channel& channel, double omega, const MotionTransfer& transfer) {
  const double k = wave_number(omega, c.hull.gravity);
  const double omega_e = transfer.encounter_frequency;
  const double phase =
      -k * (channel.position.x * std::cos(c.mu.radians) + channel.position.y * std::sin(c.mu.radians));
  Complex h = channel.form.wave * std::polar(1.0, phase);
  for (std::size_t j = 0; j < 6; ++j) {
    h += (channel.form.displacement[j] + omega_e * omega_e * channel.form.acceleration[j]) *
         transfer.motion[j];
  }
  return std::norm(h);
}

/// Significant height and amplitudes by the trapezoidal rule.
void integrate_set(const Case& c, const std::vector<double>& omegas,
                   const std::vector<MotionTransfer>& motions, FrequencySet& out) {
  std::vector<double> m0(c.watch.channels.size(), 0.0);
  double wave = 0.0;
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    const double below = omegas[i == 0 ? 0 : i - 1];
    const double above = omegas[std::min(i + 1, omegas.size() - 1)];
    const double energy = 0.5 * (above - below) * density(c.spectrum, omegas[i]);
    wave += energy;
    out.added_resistance += 2.0 * energy * added_resistance(c.hull, omegas[i], c.mu, c.speed, motions[i]);
    for (std::size_t n = 0; n < m0.size(); ++n) {
      m0[n] += energy * energy_of(c, c.watch.channels[n], omegas[i], motions[i]);
    }
  }
  out.wave_height = significant_wave_height(wave);
  for (const double m : m0) {
    out.significant.push_back(significant_amplitude(m));
  }
}

FrequencySet solved_set(const Case& c, std::string_view name, const std::vector<double>& omegas) {
  FrequencySet out{.name = name, .solutions = omegas.size()};
  std::vector<MotionTransfer> motions;
  out.seconds = least_seconds(omegas.size() > 100 ? 1 : kRepeats, [&] { motions = solve_all(c, omegas); });
  integrate_set(c, omegas, motions, out);
  return out;
}

FrequencySet paper_set(const Case& c, std::string_view name, bool by_amplitude) {
  const auto nodes = paper_frequencies();
  const auto filled = paper_frequencies_filled();
  FrequencySet out{.name = name, .solutions = nodes.size()};
  std::vector<MotionTransfer> motions;
  out.seconds = least_seconds(
      kRepeats, [&] { motions = spline_motions(nodes, solve_all(c, nodes), filled, by_amplitude); });
  for (std::size_t i = 0; i < filled.size(); ++i) {
    motions[i].encounter_frequency =
        encounter_frequency(filled[i], wave_number(filled[i], c.hull.gravity), c.speed, c.mu);
  }
  integrate_set(c, filled, motions, out);
  return out;
}

void require_status(const Status& status) {
  if (!status) {
    throw InputError{std::string(message(status.error()))};
  }
}

FrequencySet default_set(const Case& c, const WaveSystem& sea) {
  const auto transfer = std::make_unique<TransferFunctions>();
  const auto work = std::make_unique<TransferWorkspace>();
  const auto energy = std::make_unique<SeaEnergy>();
  FrequencySet out{.name = "default"};
  const double all = least_seconds(kRepeats, [&] {
    require_status(solve_transfer_functions(c.hull, std::span(&c.speed, 1), *work, *transfer));
  });
  out.seconds = all / static_cast<double>(kNumSolvedDirections);  // which are solved at once
  const auto m = static_cast<std::size_t>(
      std::lround(std::fabs(c.mu.radians) / kPi * static_cast<double>(kNumSolvedDirections - 1)));
  out.solutions = transfer->num_frequencies + transfer->peak[0][m].num_points;
  SeaState state;
  WaveSystem system = sea;
  system.from = WaveFrom{wrap_two_pi(kPi - c.mu.radians)};  // the ship heads north
  system.spreading = 0.0;
  static_cast<void>(state.systems.push_back(system));
  require_status(place_on_grid(state, std::span(transfer->omega).first(transfer->num_frequencies), *energy));
  std::vector<ResponseMoments> moments(c.watch.channels.size());
  const auto responded = response_moments(*transfer, c.watch, *energy, Heading{0.0}, c.speed, moments);
  if (!responded) {
    throw InputError{std::string(message(responded.error()))};
  }
  out.wave_height = energy->hs;
  const auto resistance = mean_added_resistance(*transfer, *energy, Heading{0.0}, c.speed);
  if (!resistance) {
    throw InputError{std::string(message(resistance.error()))};
  }
  out.added_resistance = resistance->strip;
  for (const ResponseMoments& m0 : moments) {
    out.significant.push_back(significant_amplitude(m0.m0));
  }
  return out;
}

std::vector<double> reference_frequencies(const Case& c) {
  const double to =
      std::max({3.0, 7.0 * std::sqrt(c.hull.gravity / c.hull.lpp), 4.0 * c.spectrum.peak_frequency});
  std::vector<double> omegas(kReferenceFrequencies);
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    omegas[i] = kReferenceFrom + (to - kReferenceFrom) * static_cast<double>(i) /
                                     static_cast<double>(kReferenceFrequencies - 1);
  }
  return omegas;
}

}  // namespace

std::vector<FrequencySet> compare_frequency_sets(const LoadedHull& hull, const Watch& watch,
                                                 const WaveSystem& sea, EncounterAngle mu, double speed) {
  QS_CHECK(!depends_on_amplitude(hull.roll_damping));
  const Result<Spectrum> spectrum = spectrum_of(sea);
  if (!spectrum) {
    throw InputError{std::string(message(spectrum.error()))};
  }
  const Case c{hull, watch, *spectrum, mu, speed};
  std::vector<FrequencySet> out;
  out.push_back(solved_set(c, "reference", reference_frequencies(c)));
  out.push_back(default_set(c, sea));
  out.push_back(paper_set(c, "paper", false));
  out.push_back(paper_set(c, "paper-amplitude", true));
  out.push_back(solved_set(c, "18-alone", paper_frequencies()));
  return out;
}

}  // namespace quickstrip::hull_tool
