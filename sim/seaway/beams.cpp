#include "sim/seaway/beams.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/directional_spectrum.hpp"
#include "core/sea/quadrature.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip::seaway {
namespace {

constexpr double kWidestStep = radians(5.0);
constexpr double kLeastShare = 1e-5;
constexpr double kLongCrested = radians(0.1);
constexpr std::size_t kPanels = 400;  // over the range; a JONSWAP peak is some 20 of them wide

// Straight between the bands, so the trapezoidal rule over them is the whole.
double on_range(const Beam& beam, const FrequencyRange& range) {
  return integrate(range.lowest, range.highest, kPanels, [&](double omega) { return beam.density(omega); });
}

struct Share {
  double angle = 0.0;  // from the mean
  double share = 0.0;
};

std::vector<Share> shares_of(double spreading) {
  if (spreading < kLongCrested) {
    return {{0.0, 1.0}};
  }
  const double two_s = 2.0 * spreading_exponent(spreading);
  const auto count = static_cast<int>(std::ceil(kTwoPi / std::min(kWidestStep, 0.5 * spreading)));
  std::vector<Share> out;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double angle = wrap_pi(kTwoPi * static_cast<double>(i) / static_cast<double>(count));
    const double share = std::pow(std::max(0.0, std::cos(0.5 * angle)), two_s);
    if (share >= kLeastShare) {  // the largest is 1, at the mean
      out.push_back({angle, share});
      sum += share;
    }
  }
  for (Share& s : out) {
    s.share /= sum;
  }
  return out;
}

}  // namespace

double Beam::density(double omega) const {
  if (spectrum) {
    return share * quickstrip::density(*spectrum, omega);
  }
  if (!(omega >= band_omega.front() && omega <= band_omega.back())) {
    return 0.0;
  }
  const auto above = std::upper_bound(band_omega.begin(), band_omega.end(), omega);
  if (above == band_omega.end()) {
    return share * band_density.back();
  }
  const auto i = static_cast<std::size_t>(above - band_omega.begin());
  const double part = (omega - band_omega[i - 1]) / (band_omega[i] - band_omega[i - 1]);
  return share * ((1.0 - part) * band_density[i - 1] + part * band_density[i]);
}

Result<Beams> beams_of(const SeaState& sea, const FrequencyRange& range) {
  Beams out;
  out.range = range;
  double kept = 0.0;
  for (const WaveSystem& system : sea.systems) {
    const Result<Spectrum> spectrum = spectrum_of(system);
    if (!spectrum) {
      return spectrum.error();
    }
    if (const Result<DirectionWeights> checked = direction_weights(system.from, system.spreading); !checked) {
      return checked.error();
    }
    Beam whole{
        .from = system.from, .share = 1.0, .spectrum = *spectrum, .band_omega = {}, .band_density = {}};
    const double on = on_range(whole, range);
    if (!(on > 0.01 * spectrum->m0)) {
      return Error::kOutOfRange;
    }
    for (const Share& s : shares_of(system.spreading)) {
      Beam beam = whole;
      beam.from.radians = wrap_two_pi(system.from.radians + s.angle);
      beam.share = s.share * spectrum->m0 / on;
      out.beams.push_back(beam);
    }
    out.m0 += spectrum->m0;
    kept += on;
  }
  if (out.beams.empty()) {
    return Error::kEmptySpectrum;
  }
  out.lost = std::max(0.0, 1.0 - kept / out.m0);
  return out;
}

Result<Beams> beams_of(const DirectionalSpectrum& spectrum, const FrequencyRange& range) {
  if (const Status status = check_spectrum(spectrum); !status) {
    return status.error();
  }
  Beams out;
  out.range = range;
  const double sector = kTwoPi / static_cast<double>(spectrum.directions.size());
  double kept = 0.0;
  for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
    Beam beam{.from = WaveFrom{wrap_two_pi(spectrum.directions[d])},
              .share = 1.0,
              .spectrum = std::nullopt,
              .band_omega = {},
              .band_density = {}};
    for (std::size_t f = 0; f < spectrum.frequencies.size(); ++f) {
      beam.band_omega.push_back(spectrum.frequencies[f]);
      beam.band_density.push_back(spectrum.density[f][d] * sector);
    }
    kept += on_range(beam, range);
    out.beams.push_back(std::move(beam));
  }
  out.m0 = zeroth_moment(spectrum);
  if (!(kept > 0.01 * out.m0)) {
    return Error::kOutOfRange;
  }
  for (Beam& beam : out.beams) {
    beam.share = out.m0 / kept;
  }
  out.lost = std::max(0.0, 1.0 - kept / out.m0);
  return out;
}

}  // namespace quickstrip::seaway
