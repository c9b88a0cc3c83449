#include "sim/parent/parent_ship.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/base/interpolation.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/ikeda_damping.hpp"

namespace quickstrip {
namespace {

// Ikeda's wave damping is tabulated up to four natural frequencies of roll.
constexpr double kLowestRoll = 0.5;
constexpr double kHighestRoll = 4.3;
constexpr double kHighestRollOfRatio = 1.7;

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

void set_section(const LoadedHull& hull, std::size_t i, const SectionFlow& flow, double omega,
                 SectionHydrodynamics& out) {
  const double rho = hull.density;
  const double rho_omega = rho * omega;
  const double og = hull.g_height;
  const double h4 = flow.h4 + og * flow.h2;  // about G
  out[kA22][i] = rho * flow.a22;
  out[kB22][i] = rho_omega * flow.h2 * flow.h2;
  out[kA24][i] = rho * (flow.a24 + og * flow.a22);
  out[kB24][i] = rho_omega * flow.h2 * h4;
  out[kA33][i] = rho * flow.a33;
  out[kB33][i] = rho_omega * flow.h3 * flow.h3;
  out[kA44][i] = rho * (flow.a44 + 2.0 * og * flow.a24 + og * og * flow.a22);
  out[kB44][i] = rho_omega * h4 * h4;
}

std::size_t first_node(const LoadedHull& hull, double omega) {
  const double log_omega = std::log(omega);
  if (!(log_omega >= hull.log_omega.front() && log_omega <= hull.log_omega.back())) {
    refuse("frequency of encounter " + std::to_string(omega) + " rad/s: outside 0.05 ... 50 sqrt(g/L)");
  }
  return lagrange_stencil(hull.log_omega, log_omega).first;
}

// Core interpolates between three nodes: where all of them hold what was solved at omega, it finds that.
void place(double omega, const SectionHydrodynamics& section, const LengthIntegrals& integrals,
           LoadedHull& hull) {
  const std::size_t first = first_node(hull, omega);
  for (std::size_t n = first; n < first + 3; ++n) {
    hull.node[n] = section;
    hull.node_integrals[n] = integrals;
  }
}

double frequency_of_equations(const LoadedHull& hull, const ParentWave& wave) {
  const double omega_e =
      encounter_frequency(wave.omega, wave_number(wave.omega, hull.gravity), wave.speed, wave.mu);
  return std::max(std::fabs(omega_e), encounter_floor(hull, wave.omega));
}

SectionDiffraction diffraction_of(const std::vector<SectionFlow>& flows, double k, EncounterAngle mu) {
  SectionDiffraction out;
  for (std::size_t i = 0; i < flows.size(); ++i) {
    const DiffractionFactors factors = diffraction_factors(flows[i], k, std::sin(mu.radians));
    out.heave[i] = factors.heave;
    out.sway[i] = factors.sway;
    out.roll[i] = factors.roll_lever;
  }
  return out;
}

}  // namespace

struct ParentShip::Flows {
  std::vector<SectionFlow> flow;
  SectionHydrodynamics section{};
  LengthIntegrals integrals;
  std::size_t num_unconverged = 0;
};

ParentShip::ParentShip(const Hull& hull, const Loading& loading, const StripMethod& method,
                       const ParentOptions& options)
    : options_(options), hull_(std::make_unique<LoadedHull>()) {
  StripMethod without_table = method;
  if (method.loads == DiffractionLoads::kBoundaryValue) {
    without_table.loads = DiffractionLoads::kClassic;
  }
  if (const Status loaded = load(hull, loading, without_table, *hull_); !loaded) {
    refuse(message(loaded.error()));
  }
  hull_->method = method;
  for (std::size_t i = 0; i < hull_->num_sections; ++i) {
    const ImmersedSection& section = hull_->immersed[i];
    try {
      sections_.emplace_back(section_contour(section), options.sections);
    } catch (const std::invalid_argument& error) {
      refuse("station at x = " + std::to_string(section.x) + " m: " + error.what());
    }
  }
  solve_roll_nodes();
  if (!depends_on_amplitude(hull_->roll_damping)) {
    set_roll_damping_ratio(hull.roll_damping.ratio);
    return;
  }
  const Result<RollDampingModel> model =
      ikeda_roll_damping(*hull_, hull.roll_damping.bilge_keel, loading.viscosity);
  if (!model) {
    refuse(message(model.error()));
  }
  hull_->roll_damping = *model;
}

void ParentShip::set_roll_damping_ratio(double ratio) {
  quickstrip::set_roll_damping_ratio(*hull_, ratio);
}

// Core's nodes about the natural frequency of roll, and that frequency.
void ParentShip::solve_roll_nodes() {
  const double of_lewis_forms = hull_->roll_natural_frequency;
  const double highest = depends_on_amplitude(hull_->roll_damping) ? kHighestRoll : kHighestRollOfRatio;
  for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
    const double omega = std::exp(hull_->log_omega[n]);
    if (omega > kLowestRoll * of_lewis_forms && omega < highest * of_lewis_forms) {
      const Flows solved = flows_at(omega);
      hull_->node[n] = solved.section;
      hull_->node_integrals[n] = solved.integrals;
    }
  }
  hull_->roll_natural_frequency = roll_natural_frequency(*hull_);
}

std::vector<SectionFlow> ParentShip::flows(double wave_number) const {
  std::vector<SectionFlow> out;
  out.reserve(sections_.size());
  for (const TrueSection& section : sections_) {
    out.push_back(section.flow(wave_number));
  }
  return out;
}

ParentShip::Flows ParentShip::flows_at(double omega) const {
  Flows out;
  out.flow = flows(wave_number(omega, hull_->gravity));
  for (std::size_t i = 0; i < out.flow.size(); ++i) {
    set_section(*hull_, i, out.flow[i], omega, out.section);
    out.num_unconverged += out.flow[i].is_converged ? 0u : 1u;
  }
  length_integrals(*hull_, out.section, out.integrals);
  return out;
}

void ParentShip::solve_group(double omega_e, std::span<const std::size_t> members,
                             std::span<const ParentWave> waves, double amplitude, LoadedHull& scratch,
                             std::vector<ParentResponse>& out) const {
  const Flows met = flows_at(omega_e);
  const DiffractionLoads loads = scratch.method.loads;
  for (const std::size_t w : members) {
    const ParentWave& wave = waves[w];
    const double k = wave_number(wave.omega, scratch.gravity);
    SectionDiffraction diffraction;
    if (loads == DiffractionLoads::kBoundaryValue) {
      const bool is_same = options_.diffracts_at_encounter || omega_e == wave.omega;
      diffraction = diffraction_of(is_same ? met.flow : flows(k), k, wave.mu);
    } else if (loads == DiffractionLoads::kHaskind) {
      const Flows at_wave = flows_at(wave.omega);
      place(wave.omega, at_wave.section, at_wave.integrals, scratch);
      beam_sea_correction(scratch, wave.omega, diffraction);
    }
    place(omega_e, met.section, met.integrals, scratch);
    SectionWaves sections;
    section_waves(scratch, wave.omega, wave.mu, sections);
    WaveField field;
    wave_field(scratch, wave.omega, wave.mu, sections,
               loads == DiffractionLoads::kClassic ? nullptr : &diffraction, field);
    ParentResponse& response = out[w];
    response.wave = wave;
    response.integrals = met.integrals;
    response.num_unconverged = met.num_unconverged;
    static_cast<void>(motion_transfer(scratch, field, wave.speed, response.load));
    const RegularWaveRoll roll = regular_wave_roll(scratch, field, wave.speed, amplitude);
    response.transfer = roll.transfer;
    response.roll_amplitude = roll.amplitude;
    response.added_resistance = added_resistance(scratch, wave.omega, wave.mu, wave.speed, response.transfer);
  }
}

std::vector<ParentResponse> ParentShip::solve(std::span<const ParentWave> waves, double amplitude) const {
  std::map<double, std::vector<std::size_t>> by_frequency;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const double omega_e = frequency_of_equations(*hull_, waves[w]);
    static_cast<void>(first_node(*hull_, omega_e));
    by_frequency[omega_e].push_back(w);
  }
  std::vector<const std::pair<const double, std::vector<std::size_t>>*> groups;
  for (const auto& group : by_frequency) {
    groups.push_back(&group);
  }
  std::vector<ParentResponse> out(waves.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    const auto scratch = std::make_unique<LoadedHull>(*hull_);
    try {
      for (std::size_t g = next++; g < groups.size(); g = next++) {
        solve_group(groups[g]->first, groups[g]->second, waves, amplitude, *scratch, out);
      }
    } catch (...) {
      const std::lock_guard lock(failing);
      failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < options_.num_threads; ++t) {
    others.emplace_back(work);
  }
  work();
  for (std::thread& thread : others) {
    thread.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  return out;
}

MotionTransfer ParentShip::damped(const ParentResponse& response, double roll_damping, LoadedHull& scratch) {
  const ParentWave& wave = response.wave;
  const double omega_e = frequency_of_equations(scratch, wave);
  const std::size_t first = first_node(scratch, omega_e);
  std::fill_n(scratch.node_integrals.begin() + static_cast<std::ptrdiff_t>(first), 3, response.integrals);
  const MotionTransfer& known = response.transfer;
  if (known.low_encounter && scratch.method.low_encounter == LowEncounterRule::kPaper) {
    return known;
  }
  return motions_under_load(scratch, wave.omega, wave.mu, wave.speed, response.load, roll_damping);
}

}  // namespace quickstrip
