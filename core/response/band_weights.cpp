#include "core/response/band_weights.hpp"

#include <algorithm>

#include "core/base/check.hpp"
#include "core/base/dot.hpp"
#include "core/base/legendre.hpp"

namespace quickstrip {
namespace {

double density_at(const DensityTerms& density, const std::array<double, kDensityTerms>& term) {
  return (density[0] * term[0] + density[2] * term[2]) + (density[1] * term[1] + density[3] * term[3]);
}

void clear(BandWeights& out) {
  const auto drop = [](auto& values, const LaneRange& range) {
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(range.first),
              values.begin() + static_cast<std::ptrdiff_t>(range.end), 0.0F);
  };
  drop(out.energy, out.nodes);
  drop(out.at_nodes, out.nodes);
  drop(out.at_points, out.points);
  out.nodes = {};
  out.points = {};
}

}  // namespace

void list_peak_shapes(const RollPeak& peak, std::span<const double> omega, PeakShapes& out) {
  for (const PeakInterval& interval : peak.intervals) {
    const double from = omega[interval.node];
    const double by_width = 1.0 / (omega[interval.node + 1u] - from);
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      out.place[p] = (static_cast<double>(peak.omega[p]) - from) * by_width;
      const auto shape = legendre(out.place[p]);
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        out.term[p][l] = static_cast<double>(peak.weight[p]) * shape[l];
      }
    }
  }
}

void list_band_weights(const EnergyBand& band, const RollPeak& peak, const PeakShapes& shapes,
                       BandWeights& out) {
  clear(out);
  out.nodes = lanes_that_hold(band.first, band.last);
  for (std::size_t f = out.nodes.first; f < out.nodes.end; ++f) {
    out.energy[f] = static_cast<float>(band.node[f]);
    out.at_nodes[f] = out.energy[f];
  }
  for (const PeakInterval& interval : peak.intervals) {
    const std::size_t node = interval.node;
    if (node < band.first || node >= band.last || interval.count == 0) {
      continue;
    }
    const std::size_t end = std::size_t{interval.first} + interval.count;
    double whole = 0.0;
    double at_upper = 0.0;
    for (std::size_t p = interval.first; p < end; ++p) {
      const double weight = density_at(band.density[node], shapes.term[p]);
      out.at_points[p] = static_cast<float>(weight);
      whole += weight;
      at_upper += shapes.place[p] * weight;
    }
    out.at_nodes[node] -= static_cast<float>(whole - at_upper);  // the straight line
    out.at_nodes[node + 1] -= static_cast<float>(at_upper);
    const LaneRange here = lanes_that_hold(interval.first, end - 1);
    out.points = {out.points.is_empty() ? here.first : out.points.first, here.end};
  }
}

void integrate(std::span<const BandWeights> bands, const ChannelValues& values, std::span<double> out) {
  QS_CHECK(out.size() == bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const BandWeights& band = bands[b];
    out[b] = values.has_points ? dot(values.nodes, band.at_nodes, band.nodes) +
                                     dot(values.points, band.at_points, band.points)
                               : dot(values.nodes, band.energy, band.nodes);
  }
}

void integrate_low(std::span<const BandWeights> bands, const Encounters& encounters,
                   const NodeValues& at_nodes, std::span<double> out) {
  QS_CHECK(out.size() == bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const BandWeights& band = bands[b];
    const std::size_t end = std::min(band.nodes.end, encounters.low.end);
    double sum = 0.0;
    for (std::size_t f = std::max(band.nodes.first, encounters.low.first); f < end; ++f) {
      sum += static_cast<double>((at_nodes[f] * encounters.is_low[f]) * band.energy[f]);
    }
    out[b] = sum;
  }
}

double integrate(const EnergyNodes& band, const NodeValues& at_nodes) {
  return dot(at_nodes, band.node, lanes_that_hold(band.first, band.last));
}

}  // namespace quickstrip
