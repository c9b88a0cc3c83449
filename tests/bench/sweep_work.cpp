#include "tests/bench/sweep_work.hpp"

#include "core/base/direction_transform.hpp"
#include "core/response/channel_energy.hpp"

namespace quickstrip::bench {
namespace {

constexpr double kPerTransform =  // of one function, folded: pairs of sums, then products
    2.0 * kNumSolvedDirections * (kNumDirections / 4.0 + 1.0);

std::size_t num_motions(const Channel& channel) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < 6; ++j) {
    count += channel.form.displacement[j] != 0.0 || channel.form.acceleration[j] != 0.0 ? 1U : 0U;
  }
  return count;
}

// |H|^2 of one channel: 6 a motion and 3 for the square, for both sides 7 more; a root of unity is not
// counted.
double energy_flops(const Channel& channel, std::size_t count) {
  const double squares = is_symmetric(channel) ? 3.0 : 10.0;
  return static_cast<double>(count) * (6.0 * static_cast<double>(num_motions(channel)) + squares);
}

bool holds(const EnergyBand& band, const PeakInterval& interval) {
  return interval.node >= band.first && interval.node < band.last;
}

// One integral over every band: a product and a sum a frequency and, where roll is felt, a point.
double band_flops(const SeaEnergy& sea, const RollPeak* peak) {
  double flops = 0.0;
  for (std::size_t b = 0; b < sea.num_bands; ++b) {
    flops += 2.0 * static_cast<double>(sea.band[b].last - sea.band[b].first + 1);
    for (std::size_t i = 0; peak != nullptr && i < peak->intervals.size(); ++i) {
      flops += holds(sea.band[b], peak->intervals[i]) ? 2.0 * peak->intervals[i].count : 0.0;
    }
  }
  return flops;
}

// Weights of the points, for all channels together: 10 a point and band.
double weight_flops(const SeaEnergy& sea, const RollPeak& peak) {
  double flops = 0.0;
  for (std::size_t b = 0; b < sea.num_bands; ++b) {
    for (const PeakInterval& interval : peak.intervals) {
      flops += holds(sea.band[b], interval) ? 10.0 * interval.count : 0.0;
    }
  }
  return flops;
}

double convolution_flops(const SeaEnergy& sea, bool has_sides) {
  double flops = (has_sides ? 2.0 : 1.0) * kPerTransform * static_cast<double>(sea.num_bands);
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    flops += (has_sides ? 8.0 : 4.0) * kNumSolvedDirections * static_cast<double>(sea.part[s].count);
    flops += 2.0 * kPerTransform;
  }
  return flops;
}

}  // namespace

SweepWork sweep_work(const GridInputs& inputs) {
  SweepWork out;
  const TransferFunctions& transfer = inputs.transfer;
  for (std::size_t v = 0; v < transfer.num_speeds; ++v) {
    for (const RollPeak& peak : transfer.peak[v]) {
      out.flops += weight_flops(inputs.sea, peak);
    }
    for (std::size_t c = 0; c < inputs.watch.channels.size(); ++c) {
      const Channel& channel = inputs.watch.channels[c];
      if (!inputs.channels.is_needed[c]) {
        continue;
      }
      const bool has_sides = !is_symmetric(channel);
      // Variance, second moment of relative motion, part below the floor: the last only where there is one,
      // counted for every speed but the first.
      const double moments =
          1.0 + (channel.form.wave > 0.0 ? 1.0 : 0.0) + (inputs.channels.is_watched[c] && v > 0 ? 1.0 : 0.0);
      for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
        const double sides = has_sides ? 2.0 : 1.0;
        out.flops += energy_flops(channel, transfer.num_frequencies);
        const RollPeak* peak = feels_roll(channel) ? &transfer.peak[v][m] : nullptr;
        out.flops += sides * moments * band_flops(inputs.sea, peak);
        out.flops += peak != nullptr ? energy_flops(channel, peak->num_points) : 0.0;
      }
      out.flops += moments * convolution_flops(inputs.sea, has_sides);
    }
  }
  const double row = 12.0 * sizeof(float) * static_cast<double>(transfer.num_frequencies);
  out.bytes = static_cast<double>(transfer.num_speeds * kNumSolvedDirections) *
              (row + static_cast<double>(sizeof(RollPeak)));
  for (std::size_t s = 0; s < inputs.sea.num_systems; ++s) {
    out.bytes += 2.0 * sizeof(double) * kNumSolvedDirections * static_cast<double>(inputs.sea.part[s].count);
  }
  out.bytes += static_cast<double>(inputs.sea.num_bands * sizeof(EnergyBand));
  return out;
}

}  // namespace quickstrip::bench
