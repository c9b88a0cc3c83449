// Height, peak period, mean direction and spreading of the systems of a divided spectrum.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/sea/directional_spectrum.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/partition.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {
namespace {

using Rows = std::array<double, kMaxSpectrumFrequencies>;

// Peak of the parabola through the highest band and its neighbours (Newton's form, uneven spacing).
double peak_frequency(std::span<const double> omega, const Rows& rows) {
  const auto top = std::max_element(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(omega.size()));
  const auto i = static_cast<std::size_t>(top - rows.begin());
  if (i == 0 || i + 1 == omega.size()) {
    return omega[i];
  }
  const double slope_below = (rows[i] - rows[i - 1]) / (omega[i] - omega[i - 1]);
  const double slope_above = (rows[i + 1] - rows[i]) / (omega[i + 1] - omega[i]);
  const double curvature = (slope_above - slope_below) / (omega[i + 1] - omega[i - 1]);
  if (!(curvature < 0.0)) {
    return omega[i];
  }
  const double vertex = 0.5 * (omega[i - 1] + omega[i] - slope_below / curvature);
  return std::clamp(vertex, omega[i - 1], omega[i + 1]);
}

}  // namespace

void describe_systems(const DirectionalSpectrum& spectrum, WavePartition& out) {
  const auto omega = spectrum.frequencies.span();
  const BandWidths widths = band_widths(omega);
  const double step = kTwoPi / static_cast<double>(spectrum.directions.size());
  for (std::size_t s = 0; s < out.num_systems; ++s) {
    Rows rows{};
    double m0 = 0.0;
    double cosine_sum = 0.0;
    double sine_sum = 0.0;
    for (std::size_t f = 0; f < omega.size(); ++f) {
      for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
        if (out.system_of[f][d] != s) {
          continue;
        }
        const double energy = spectrum.density[f][d] * widths[f] * step;
        rows[f] += spectrum.density[f][d] * step;
        m0 += energy;
        cosine_sum += energy * std::cos(spectrum.directions[d]);
        sine_sum += energy * std::sin(spectrum.directions[d]);
      }
    }
    const MeanDirection mean = mean_direction(cosine_sum, sine_sum, m0);
    out.m0[s] = m0;
    out.system[s].hs = significant_wave_height(m0);
    out.system[s].period = kTwoPi / peak_frequency(omega, rows);
    out.system[s].period_kind = PeriodKind::kPeak;
    out.system[s].from = mean.from;
    out.system[s].spreading = mean.spreading;
  }
}

}  // namespace quickstrip
