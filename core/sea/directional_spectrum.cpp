#include "core/sea/directional_spectrum.hpp"

#include <cmath>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

// Directions rounded to a hundredth of a degree still count as even.
constexpr double kSpacingTolerance = 2e-4;

Status check_frequencies(std::span<const double> frequencies) {
  if (frequencies.size() < 3) {
    return Error::kOutOfRange;
  }
  double last = 0.0;
  for (const double omega : frequencies) {
    if (!std::isfinite(omega)) {
      return Error::kNotFinite;
    }
    if (!(omega > last)) {
      return Error::kOutOfRange;
    }
    last = omega;
  }
  return {};
}

Status check_directions(std::span<const double> directions) {
  if (directions.size() < 4) {
    return Error::kOutOfRange;
  }
  for (const double direction : directions) {
    if (!std::isfinite(direction)) {
      return Error::kNotFinite;
    }
  }
  const double step = kTwoPi / static_cast<double>(directions.size());
  const double sense = wrap_pi(directions[1] - directions[0]) > 0.0 ? 1.0 : -1.0;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const double next = directions[(d + 1) % directions.size()];
    if (!(std::fabs(wrap_pi(next - directions[d] - sense * step)) < kSpacingTolerance)) {
      return Error::kOutOfRange;
    }
  }
  return {};
}

}  // namespace

Status check_spectrum(const DirectionalSpectrum& spectrum) {
  if (const Status fit = check_frequencies(spectrum.frequencies.span()); !fit) {
    return fit;
  }
  if (const Status fit = check_directions(spectrum.directions.span()); !fit) {
    return fit;
  }
  for (std::size_t f = 0; f < spectrum.frequencies.size(); ++f) {
    for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
      if (!std::isfinite(spectrum.density[f][d])) {
        return Error::kNotFinite;
      }
      if (!(spectrum.density[f][d] >= 0.0)) {
        return Error::kOutOfRange;
      }
    }
  }
  return zeroth_moment(spectrum) > 0.0 ? Status{} : Status{Error::kEmptySpectrum};
}

BandWidths band_widths(std::span<const double> frequencies) {
  BandWidths widths{};
  for (std::size_t f = 0; f + 1 < frequencies.size(); ++f) {
    const double half = 0.5 * (frequencies[f + 1] - frequencies[f]);
    widths[f] += half;
    widths[f + 1] += half;
  }
  return widths;
}

double zeroth_moment(const DirectionalSpectrum& spectrum) {
  const BandWidths widths = band_widths(spectrum.frequencies.span());
  double sum = 0.0;
  for (std::size_t f = 0; f < spectrum.frequencies.size(); ++f) {
    double row = 0.0;
    for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
      row += spectrum.density[f][d];
    }
    sum += widths[f] * row;
  }
  return sum * kTwoPi / static_cast<double>(spectrum.directions.size());
}

}  // namespace quickstrip
