#include "sim/seaway/wave_answers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/interpolation.hpp"
#include "core/response/relative_motion.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip::seaway {
namespace {

constexpr double kNodeSpacing = 0.03;  // sqrt(g/L)
constexpr std::size_t kStencil = 4;

using Loads = std::array<Complex, 6>;

// Answers in waves of one direction: loads at the nodes, motions anywhere.
class BeamShip {
 public:
  BeamShip(const LoadedHull& hull, const CellGrid& grid, const FrequencyRange& range)
      : hull_(hull),
        speed_(grid.speed),
        diffraction_(count_of(hull, range)),
        omega_(diffraction_.size()),
        met_(diffraction_.size()),
        load_(diffraction_.size()),
        sections_(std::make_unique<SectionWaves>()),
        field_(std::make_unique<WaveField>()) {
    for (std::size_t i = 0; i < omega_.size(); ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(omega_.size() - 1);
      omega_[i] = range.lowest + part * (range.highest - range.lowest);
      if (hull.method.loads == DiffractionLoads::kHaskind) {  // of every direction alike
        beam_sea_correction(hull, omega_[i], diffraction_[i]);
      }
    }
  }

  void turn_to(EncounterAngle mu) {
    mu_ = mu;
    for (std::size_t i = 0; i < omega_.size(); ++i) {
      if (hull_.method.loads == DiffractionLoads::kBoundaryValue) {
        section_diffraction(hull_, omega_[i], mu, diffraction_[i]);
      }
      met_[i] = solve_directly(omega_[i], diffraction_[i], load_[i]);
    }
  }

  MotionTransfer at(double omega) const {
    const double step = omega_[1] - omega_[0];
    const auto below = static_cast<std::ptrdiff_t>((omega - omega_[0]) / step);
    const auto last = static_cast<std::ptrdiff_t>(omega_.size() - kStencil);
    const auto first = static_cast<std::size_t>(std::clamp(below - 1, std::ptrdiff_t{0}, last));
    const MotionTransfer& one = met_[first];
    const double met = encounter_frequency(omega, wave_number(omega, hull_.gravity), speed_, mu_);
    const bool is_smooth = std::none_of(
        met_.begin() + static_cast<std::ptrdiff_t>(first),
        met_.begin() + static_cast<std::ptrdiff_t>(first + kStencil), [&](const MotionTransfer& m) {
          return m.low_encounter || (m.encounter_frequency < 0.0) != (one.encounter_frequency < 0.0);
        });
    if (!is_smooth || std::fabs(met) < encounter_floor(hull_, omega)) {
      return motion_transfer(hull_, omega, mu_, speed_);
    }
    std::array<double, kStencil> weight{};
    lagrange_weights(std::span<const double>(omega_).subspan(first, kStencil), omega, weight);
    Loads load{};
    for (std::size_t i = 0; i < kStencil; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        load[k] += weight[i] * load_[first + i][k];
      }
    }
    return motions_under_load(hull_, omega, mu_, speed_, load);
  }

 private:
  static std::size_t count_of(const LoadedHull& hull, const FrequencyRange& range) {
    const double spacing = kNodeSpacing * std::sqrt(hull.gravity / hull.lpp);
    return std::max<std::size_t>(
        8, static_cast<std::size_t>(std::ceil((range.highest - range.lowest) / spacing)) + 1);
  }

  MotionTransfer solve_directly(double omega, const SectionDiffraction& diffraction, Loads& load) {
    const bool has_diffraction = hull_.method.loads != DiffractionLoads::kClassic;
    section_waves(hull_, omega, mu_, *sections_);
    wave_field(hull_, omega, mu_, *sections_, has_diffraction ? &diffraction : nullptr, *field_);
    return motion_transfer(hull_, *field_, speed_, load);
  }

  const LoadedHull& hull_;
  double speed_;
  EncounterAngle mu_;
  std::vector<SectionDiffraction> diffraction_;
  std::vector<double> omega_;
  std::vector<MotionTransfer> met_;
  std::vector<Loads> load_;
  std::unique_ptr<SectionWaves> sections_;
  std::unique_ptr<WaveField> field_;
};

// Rows of the wave by channel; positions on the centre line that coincide in x share one.
std::vector<double> list_wave_rows(const Watch& watch, WaveAnswers& out) {
  std::vector<double> places;
  out.wave_row.assign(watch.channels.size(), kWaveRow);
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    if (!(watch.channels[c].form.wave > 0.0)) {
      continue;
    }
    const double x = watch.channels[c].position.x;
    const auto found = std::find(places.begin(), places.end(), x);
    out.wave_row[c] = kWaveRow + 1 + static_cast<std::size_t>(found - places.begin());
    if (found == places.end()) {
      places.push_back(x);
    }
  }
  out.num_rows = kWaveRow + 1 + places.size();
  return places;
}

}  // namespace

Result<WaveAnswers> wave_answers(const LoadedHull& hull, const Watch& watch, const Beams& sea,
                                 const CellGrid& grid, std::span<const WaveCell> cells) {
  WaveAnswers out;
  out.step = grid.step;
  out.speed = grid.speed;
  const std::vector<double> places = list_wave_rows(watch, out);
  out.bin.reserve(cells.size());
  out.re.reserve(cells.size() * out.num_rows);
  out.im.reserve(cells.size() * out.num_rows);
  BeamShip ship(hull, grid, sea.range);
  const std::size_t num_beams = sea.beams.size();
  std::size_t beam = num_beams;
  EncounterAngle mu;
  for (const WaveCell& cell : cells) {
    if (cell.beam != beam) {
      beam = cell.beam;
      mu = encounter_angle(grid.heading, sea.beams[beam].from);
      ship.turn_to(mu);
    }
    const MotionTransfer motion = ship.at(cell.omega);
    if (!is_finite(motion)) {
      return Error::kSingular;
    }
    const double size = std::sqrt(cell.energy);
    const double mirror = cell.bin < 0 ? -1.0 : 1.0;
    const auto push = [&](Complex value) {
      out.re.push_back(static_cast<float>(size * value.real()));
      out.im.push_back(static_cast<float>(mirror * size * value.imag()));
    };
    for (const Complex& value : motion.motion) {
      push(value);
    }
    push(1.0);
    for (const double x : places) {
      push(incident_wave({x, 0.0, 0.0}, wave_number(cell.omega, grid.gravity), mu));
    }
    out.bin.push_back(static_cast<std::uint32_t>(std::abs(cell.bin)));
    out.num_bins = std::max(out.num_bins, std::size_t{out.bin.back()} + 1);
  }
  return out;
}

void draw_block(const WaveAnswers& answers, Gaussian& random, BinAmplitudes& out) {
  const std::size_t rows = answers.num_rows;
  out.resize(answers.num_bins, rows);
  for (std::size_t i = 0; i < answers.bin.size(); ++i) {
    const Gaussian::Pair wave = random.pair();
    const float* const re = answers.re.data() + i * rows;
    const float* const im = answers.im.data() + i * rows;
    double* const to_re = out.re.data() + answers.bin[i] * rows;
    double* const to_im = out.im.data() + answers.bin[i] * rows;
    for (std::size_t r = 0; r < rows; ++r) {
      const auto a = static_cast<double>(re[r]);
      const auto b = static_cast<double>(im[r]);
      to_re[r] += wave.first * a - wave.second * b;
      to_im[r] += wave.first * b + wave.second * a;
    }
  }
}

void channel_amplitudes(const WaveAnswers& answers, const BinAmplitudes& block, const Channel& channel,
                        std::size_t wave_row, std::vector<Complex>& out) {
  const LinearForm& form = channel.form;
  out.assign(block.num_bins(), {});
  for (std::size_t n = 0; n < block.num_bins(); ++n) {
    const double omega = answers.step * static_cast<double>(n);
    Complex sum = form.wave > 0.0 ? form.wave * block.value(n, wave_row) : Complex();
    for (std::size_t j = 0; j < 6; ++j) {
      const double factor = form.displacement[j] + omega * omega * form.acceleration[j];
      if (factor != 0.0) {
        sum += factor * block.value(n, j);
      }
    }
    out[n] = channel.dynamic_swell_up.factor(answers.speed, omega) * sum;
  }
}

SpectralMoments channel_moments(const WaveAnswers& answers, const Channel& channel, std::size_t wave_row) {
  SpectralMoments out;
  const LinearForm& form = channel.form;
  const std::size_t rows = answers.num_rows;
  for (std::size_t i = 0; i < answers.bin.size(); ++i) {
    const double omega2 = std::pow(answers.step * static_cast<double>(answers.bin[i]), 2);
    const auto value = [&](std::size_t row) {
      return Complex(static_cast<double>(answers.re[i * rows + row]),
                     static_cast<double>(answers.im[i * rows + row]));
    };
    Complex sum = form.wave > 0.0 ? form.wave * value(wave_row) : Complex();
    for (std::size_t j = 0; j < 6; ++j) {
      sum += (form.displacement[j] + omega2 * form.acceleration[j]) * value(j);
    }
    const double factor = channel.dynamic_swell_up.factor(answers.speed, std::sqrt(omega2));
    const double energy = factor * factor * std::norm(sum);
    out.m0 += energy;
    out.m2 += omega2 * energy;
    out.m4 += omega2 * omega2 * energy;
  }
  return out;
}

}  // namespace quickstrip::seaway
