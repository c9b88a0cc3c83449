#include "core/response/mean_added_resistance.hpp"

#include <cmath>

#include "core/response/band_weights.hpp"
#include "core/response/heading_convolution.hpp"
#include "core/response/met_energy.hpp"
#include "core/response/moments.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;

/// Headings' columns of the two.
constexpr std::size_t kStrip = 0;
constexpr std::size_t kEmpirical = 1;
static_assert(kSweepBlocks * kTransformBlock >= 2 * kBandWidth && kMaxHeadingColumns > kEmpirical);

/// Columns of one method, after those of the methods before it.
void integrate(const ResistanceRows& rows, const SeaEnergy& sea, std::size_t method, SweepColumns& out) {
  for (std::size_t m = 0; m <= kHalf; ++m) {
    for (std::size_t b = 0; b < sea.num_bands; ++b) {
      const std::size_t column = method * sea.num_bands + b;
      out.block[column / kTransformBlock][m][column % kTransformBlock] = integrate(sea.band[b], rows[m]);
    }
  }
}

double mean_at(const ResistanceRows& rows, const SeaEnergy& sea, const HeadingBracket& heading) {
  double sum = 0.0;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    const std::size_t d0 = wave_direction(heading.below, m);
    const std::size_t d1 = wave_direction(heading.above, m);
    const ResistanceRow& row = rows[solved_direction(m)];
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      const SystemEnergy& part = sea.part[s];
      for (std::size_t b = part.first; b < part.first + part.count; ++b) {
        const double factor = (1.0 - heading.part) * part.factor[b][d0] + heading.part * part.factor[b][d1];
        sum += factor != 0.0 ? factor * integrate(sea.band[b], row) : 0.0;
      }
    }
  }
  return 2.0 * sum;
}

}  // namespace

void list_mean_added_resistance(const TransferFunctions& transfer, std::size_t speed, const SeaEnergy& sea,
                                SweepWorkspace& work, HeadingResistance& out) {
  out.has_empirical = transfer.has_empirical_resistance[speed];
  const std::size_t count = out.has_empirical ? 2 : 1;
  integrate(transfer.added_resistance[speed], sea, kStrip, work.columns);
  if (out.has_empirical) {
    integrate(transfer.empirical_resistance[speed], sea, kEmpirical, work.columns);
  }
  work.columns.num_even = blocks_of(count * sea.num_bands);
  work.columns.num_odd = 0;
  transform_columns(work.columns);
  clear(count, work.headings);
  for (std::size_t method = 0; method < count; ++method) {
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      add_product(sea.part[s], work.columns, {.even = method * sea.num_bands}, method, work.headings);
    }
  }
  turn_back(count, work.headings);
  constexpr double kMeanOfAmplitudeSquared = 2.0;  // a wave's energy is half its amplitude squared
  read_headings(work.headings, kStrip, kMeanOfAmplitudeSquared, out.strip);
  if (out.has_empirical) {
    read_headings(work.headings, kEmpirical, kMeanOfAmplitudeSquared, out.empirical);
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
    out.strip += weight * mean_at(transfer.added_resistance[v], sea, headings);
    if (!transfer.has_empirical_resistance[v]) {
      out.empirical.reset();
    } else if (out.empirical) {
      *out.empirical += weight * mean_at(transfer.empirical_resistance[v], sea, headings);
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
