#include "core/response/peak_terms.hpp"

#include "core/base/check.hpp"
#include "core/base/legendre.hpp"

namespace quickstrip {

void list_peak_shapes(const RollPeak& peak, std::span<const double> omega, PeakShapes& out) {
  for (std::size_t i = 0; i < peak.intervals.size(); ++i) {
    const PeakInterval& interval = peak.intervals[i];
    const double from = omega[interval.node];
    const double by_width = 1.0 / (omega[interval.node + 1u] - from);
    out.whole[i] = {};
    out.rising[i] = {};
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      const double t = (static_cast<double>(peak.omega[p]) - from) * by_width;
      const auto shape = legendre(t);
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        out.point[p][l] = static_cast<double>(peak.weight[p]) * shape[l];
        out.whole[i][l] += out.point[p][l];
        out.rising[i][l] += t * out.point[p][l];
      }
    }
  }
}

void list_peak_terms(const RollPeak& peak, const PeakShapes& shapes, const NodeValues& at_nodes,
                     const PointValues& at_points, PeakTerms& out) {
  for (std::size_t i = 0; i < peak.intervals.size(); ++i) {
    const PeakInterval& interval = peak.intervals[i];
    const double low = at_nodes[interval.node];
    const double rise = at_nodes[interval.node + 1u] - low;
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      out[i][l] = -low * shapes.whole[i][l] - rise * shapes.rising[i][l];
    }
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        out[i][l] += at_points[p] * shapes.point[p][l];
      }
    }
  }
}

namespace {

constexpr std::size_t kLanes = 8;
static_assert(kMaxFrequencies % kLanes == 0);

// Eight partial sums, so that the compiler may use vectors without reordering anything. Whole groups of
// nodes: a band is zero outside its own.
double node_sum(const EnergyBand& band, const NodeValues& values) {
  std::array<double, kLanes> sums{};
  for (std::size_t f = band.first / kLanes * kLanes; f <= band.last; f += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) {
      sums[j] += values[f + j] * band.node[f + j];
    }
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

}  // namespace

void integrate_over_bands(const SeaEnergy& sea, const NodeValues& at_nodes, const RollPeak& peak,
                          const PeakTerms* terms, std::span<double> out) {
  QS_CHECK(out.size() >= sea.num_bands);
  for (std::size_t b = 0; b < sea.num_bands; ++b) {
    out[b] = node_sum(sea.band[b], at_nodes);
  }
  for (std::size_t i = 0; terms != nullptr && i < peak.intervals.size(); ++i) {
    const std::size_t node = peak.intervals[i].node;
    const std::array<double, kDensityTerms>& term = (*terms)[i];
    for (std::size_t b = sea.bands_of[node].first; b < sea.bands_of[node].last; ++b) {
      const DensityTerms& density = sea.band[b].density[node];
      out[b] += (term[0] * density[0] + term[2] * density[2]) + (term[1] * density[1] + term[3] * density[3]);
    }
  }
}

}  // namespace quickstrip
