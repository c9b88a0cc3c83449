#include "core/response/mean_added_resistance.hpp"

#include <cmath>
#include <span>

#include "core/response/channel_energy.hpp"
#include "core/response/heading_convolution.hpp"
#include "core/response/moments.hpp"
#include "core/response/peak_terms.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;

/// Columns of the workspace that hold the two.
constexpr std::size_t kStrip = 0;
constexpr std::size_t kEmpirical = 1;
static_assert(kSystemWidth > kEmpirical);

void integrate(const TransferFunctions& transfer, const ResistanceRow& row, const SeaEnergy& sea,
               std::span<double> out) {
  NodeValues nodes{};
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    nodes[f] = static_cast<double>(row[f]);
  }
  integrate_over_bands(sea, nodes, transfer.peak[0][0], nullptr, out);  // no terms: any peak does
}

/// The transform of what all systems bring, into one column: heading_moments.hpp for a channel.
void transform(const TransferFunctions& transfer, const ResistanceRows& rows, const SeaEnergy& sea,
               std::size_t column, SweepWorkspace& work) {
  for (std::size_t m = 0; m <= kHalf; ++m) {
    integrate(transfer, rows[m], sea, work.even[0][0][m]);
  }
  cosine_transform(work.even[0][0], sea.num_bands, work.cosine);
  for (std::size_t k = 0; k <= kHalf; ++k) {
    double re = 0.0;
    double im = 0.0;  // minus the imaginary part
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      const SystemEnergy& part = sea.part[s];
      for (std::size_t b = part.first; b < part.first + part.count; ++b) {
        re += work.cosine[k][b] * part.cosine[k][b];
        im += work.cosine[k][b] * part.sine[k][b];
      }
    }
    work.product_cosine[k][column] = re;
    work.product_sine[k][column] = im;
  }
}

double mean_at(const TransferFunctions& transfer, const ResistanceRows& rows, const SeaEnergy& sea,
               const HeadingBracket& heading) {
  std::array<double, kMaxEnergyBands> integrals{};
  double sum = 0.0;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    const std::size_t d0 = wave_direction(heading.below, m);
    const std::size_t d1 = wave_direction(heading.above, m);
    integrate(transfer, rows[solved_direction(m)], sea, integrals);
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      const SystemEnergy& part = sea.part[s];
      for (std::size_t b = part.first; b < part.first + part.count; ++b) {
        sum += ((1.0 - heading.part) * part.factor[b][d0] + heading.part * part.factor[b][d1]) * integrals[b];
      }
    }
  }
  return 2.0 * sum;
}

}  // namespace

void list_mean_added_resistance(const TransferFunctions& transfer, std::size_t speed, const SeaEnergy& sea,
                                SweepWorkspace& work, HeadingResistance& out) {
  out.has_empirical = transfer.has_empirical_resistance[speed];
  transform(transfer, transfer.added_resistance[speed], sea, kStrip, work);
  if (out.has_empirical) {
    transform(transfer, transfer.empirical_resistance[speed], sea, kEmpirical, work);
  }
  const std::size_t count = out.has_empirical ? 2 : 1;
  cosine_transform(work.product_cosine, count, work.part_even);
  sine_transform(work.product_sine, count, work.part_odd);
  constexpr double kMeanOfAmplitudeSquared = 2.0;  // a wave's energy is half its amplitude squared
  read_headings(work, kStrip, kMeanOfAmplitudeSquared, out.strip);
  if (out.has_empirical) {
    read_headings(work, kEmpirical, kMeanOfAmplitudeSquared, out.empirical);
  }
}

Result<MeanResistance> mean_added_resistance(const TransferFunctions& transfer, const SeaEnergy& sea,
                                             Heading heading, double speed) {
  if (!std::isfinite(heading.radians)) {
    return Error::kNotFinite;
  }
  const Result<SpeedBracket> speeds = bracket_speed(transfer, speed);
  if (!speeds) {
    return speeds.error();
  }
  const HeadingBracket headings = bracket_heading(heading);
  MeanResistance out{.strip = 0.0, .empirical = 0.0};
  const auto add = [&](std::size_t v, double weight) {
    if (!(weight > 0.0)) {
      return;
    }
    out.strip += weight * mean_at(transfer, transfer.added_resistance[v], sea, headings);
    if (!transfer.has_empirical_resistance[v]) {
      out.empirical.reset();
    } else if (out.empirical) {
      *out.empirical += weight * mean_at(transfer, transfer.empirical_resistance[v], sea, headings);
    }
  };
  add(speeds->lower, 1.0 - speeds->part);
  add(speeds->upper, speeds->part);
  if (!std::isfinite(out.strip)) {
    return Error::kNotFinite;
  }
  return out;
}

}  // namespace quickstrip
