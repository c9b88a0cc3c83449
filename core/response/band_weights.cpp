#include "core/response/band_weights.hpp"

#include <algorithm>

#include "core/base/legendre.hpp"

namespace quickstrip {
namespace {

LaneRange lanes_of(const EnergyNodes& band) {
  return lanes_that_hold(band.first, band.last);
}

double density_at(const DensityTerms& density, const std::array<double, kDensityTerms>& term) {
  return (density[0] * term[0] + density[2] * term[2]) + (density[1] * term[1] + density[3] * term[3]);
}

void clear(BandWeights& out) {
  const auto drop = [](auto& values, const LaneRange& range) {
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(range.first),
              values.begin() + static_cast<std::ptrdiff_t>(range.end), 0.0);
  };
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
  out.nodes = lanes_of(band);
  for (std::size_t f = out.nodes.first; f < out.nodes.end; ++f) {
    out.at_nodes[f] = band.node[f];
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
      out.at_points[p] = weight;
      whole += weight;
      at_upper += shapes.place[p] * weight;
    }
    out.at_nodes[node] -= whole - at_upper;  // the straight line
    out.at_nodes[node + 1] -= at_upper;
    const LaneRange here = lanes_that_hold(interval.first, end - 1);
    out.points = {out.points.is_empty() ? here.first : out.points.first, here.end};
  }
}

double integrate(const BandWeights& weights, const ChannelValues& values) {
  return dot(values.nodes, weights.at_nodes, weights.nodes) +
         dot(values.points, weights.at_points, weights.points);
}

double integrate(const EnergyNodes& band, const NodeValues& at_nodes) {
  return dot(at_nodes, band.node, lanes_of(band));
}

double integrate_low(const EnergyNodes& band, const Encounters& encounters, const NodeValues& at_nodes) {
  const LaneRange range = lanes_of(band);
  const std::size_t end = std::min(range.end, encounters.low.end);
  double sum = 0.0;
  for (std::size_t f = std::max(range.first, encounters.low.first); f < end; ++f) {
    sum += (at_nodes[f] * encounters.is_low[f]) * band.node[f];
  }
  return sum;
}

}  // namespace quickstrip
