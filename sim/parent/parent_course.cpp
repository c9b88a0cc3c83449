#include "sim/parent/parent_course.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/response/point_motion.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip {
namespace {

// About a resonance: this wide a band of frequencies on either side, closer towards it.
constexpr double kBand = 0.3;

double omega_e_of(const LoadedHull& hull, EncounterAngle mu, double speed, double omega) {
  return std::fabs(encounter_frequency(omega, wave_number(omega, hull.gravity), speed, mu));
}

Complex answer(const Channel& channel, const MotionTransfer& transfer, Complex wave) {
  const double square = transfer.encounter_frequency * transfer.encounter_frequency;
  Complex h = channel.form.wave * wave;
  for (std::size_t j = 0; j < 6; ++j) {
    h += (channel.form.displacement[j] + square * channel.form.acceleration[j]) * transfer.motion[j];
  }
  return h;
}

}  // namespace

std::vector<double> parent_frequencies(const LoadedHull& hull, EncounterAngle mu, double speed,
                                       std::span<const double> nodes, std::size_t parts) {
  std::vector<double> out;
  const double natural = hull.roll_natural_frequency;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double width = nodes[i + 1] - nodes[i];
    for (std::size_t p = 0; p < parts; ++p) {
      out.push_back(nodes[i] + width * static_cast<double>(p) / static_cast<double>(parts));
    }
    const double before = omega_e_of(hull, mu, speed, nodes[i]) - natural;
    const double after = omega_e_of(hull, mu, speed, nodes[i + 1]) - natural;
    if (before * after <= 0.0) {
      const double centre = nodes[i] + width * before / (before - after);
      const auto half = static_cast<int>(4 * parts);
      for (int n = -half; n <= half; ++n) {
        const double t = static_cast<double>(n) / static_cast<double>(half);
        out.push_back(centre * (1.0 + kBand * t * std::fabs(t)));
      }
    }
  }
  out.push_back(nodes.back());
  std::erase_if(out, [&](double omega) { return omega < nodes.front() || omega > nodes.back(); });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

ParentCourse::ParentCourse(const ParentShip& ship, EncounterAngle mu, double speed,
                           std::span<const double> omegas)
    : ship_(ship), mu_(mu), speed_(speed) {
  if (omegas.size() < 2) {
    throw std::invalid_argument("statistics need two wave frequencies at least");
  }
  std::vector<ParentWave> waves;
  for (const double omega : omegas) {
    waves.push_back({omega, mu, speed});
  }
  responses_ = ship.solve(waves);
}

std::vector<double> ParentCourse::energies(const Spectrum& spectrum) const {
  const std::size_t n = responses_.size();
  std::vector<double> out(n);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double below = responses_[i == 0 ? 0 : i - 1].wave.omega;
    const double above = responses_[std::min(i + 1, n - 1)].wave.omega;
    out[i] = 0.5 * (above - below) * density(spectrum, responses_[i].wave.omega);
    sum += out[i];
  }
  const double whole = spectrum.m0;
  for (double& energy : out) {
    energy *= whole / sum;
  }
  return out;
}

std::vector<MotionTransfer> ParentCourse::motions(double roll_damping) const {
  const auto scratch = std::make_unique<LoadedHull>(ship_.hull());
  std::vector<MotionTransfer> out;
  for (const ParentResponse& response : responses_) {
    out.push_back(ParentShip::damped(response, roll_damping, *scratch));
  }
  return out;
}

ResponseMoments ParentCourse::moments(const Channel& channel, std::span<const MotionTransfer> motions,
                                      std::span<const double> energy) const {
  ResponseMoments out;
  out.m4 = 0.0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double k = wave_number(responses_[i].wave.omega, ship_.hull().gravity);
    const double along =
        channel.position.x * std::cos(mu_.radians) + channel.position.y * std::sin(mu_.radians);
    const double omega_e = std::fabs(motions[i].encounter_frequency);
    const double swell_up = channel.dynamic_swell_up.factor(speed_, omega_e);
    const double rate = channel.is_rate ? omega_e : 1.0;
    const double part =
        energy[i] * std::norm(swell_up * rate * answer(channel, motions[i], std::polar(1.0, -k * along)));
    out.m0 += part;
    out.m1 += part * omega_e;
    out.m2 += part * omega_e * omega_e;
    out.m4 += part * omega_e * omega_e * omega_e * omega_e;
    out.m0_low_encounter += motions[i].low_encounter ? part : 0.0;
  }
  out.m0_by_system[0] = out.m0;
  return out;
}

ParentStatistics ParentCourse::respond(const Spectrum& spectrum, const Watch& watch) const {
  const std::vector<double> energy = energies(spectrum);
  const RollDampingModel& model = ship_.hull().roll_damping;
  ParentStatistics out;
  out.roll_damping = reference_roll_damping(model, speed_);
  std::vector<MotionTransfer> at_damping = motions(out.roll_damping);
  if (depends_on_amplitude(model)) {
    Channel roll;
    roll.form.displacement[3] = 1.0;
    // More damping, less roll, less damping called for: one root of what it calls for less what there is.
    double low = std::log(1e-3 * out.roll_damping);
    double high = std::log(1e3 * out.roll_damping);
    for (int step = 0; step < 30; ++step) {
      const double middle = 0.5 * (low + high);
      const ResponseMoments moved = moments(roll, motions(std::exp(middle)), energy);
      const double called = moved.m0 > 0.0 ? added_roll_damping_gaussian(model, speed_, std::sqrt(moved.m0),
                                                                         std::sqrt(moved.m2 / moved.m0))
                                           : small_roll_damping(model, speed_);
      (std::log(called) > middle ? low : high) = middle;
    }
    out.roll_damping = std::exp(0.5 * (low + high));
    at_damping = motions(out.roll_damping);
  }
  for (std::size_t i = 0; i < energy.size(); ++i) {
    out.added_resistance += 2.0 * energy[i] * responses_[i].added_resistance;
  }
  for (const Channel& channel : watch.channels) {
    out.moments.push_back(moments(channel, at_damping, energy));
  }
  return out;
}

}  // namespace quickstrip
