#include "core/response/peak_terms.hpp"

#include "core/base/check.hpp"
#include "core/base/legendre.hpp"

namespace quickstrip {

bool feels_roll(const Channel& channel) {
  switch (channel.quantity) {
    case Quantity::kSway:
    case Quantity::kRoll:
    case Quantity::kYaw:
    case Quantity::kLateralAcceleration:
      return true;
    case Quantity::kLongitudinalAcceleration:
    case Quantity::kVerticalAcceleration:
    case Quantity::kSlamming:
    case Quantity::kDeckWetness:
      return channel.position.y < 0.0 || channel.position.y > 0.0;
    default:
      return false;
  }
}

PeakTerms peak_terms(const RollPeak& peak, std::span<const double> omega, std::span<const double> at_nodes,
                     std::span<const double> at_points) {
  QS_CHECK(at_nodes.size() == omega.size() && at_points.size() == peak.num_points);
  PeakTerms out{};
  for (std::size_t i = 0; i < peak.intervals.size(); ++i) {
    const PeakInterval& interval = peak.intervals[i];
    const double from = omega[interval.node];
    const double width = omega[interval.node + 1u] - from;
    const double low = at_nodes[interval.node];
    const double rise = at_nodes[interval.node + 1u] - low;
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      const double t = (peak.omega[p] - from) / width;
      const double beyond = peak.weight[p] * (at_points[p] - (low + t * rise));
      const auto shape = legendre(t);
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        out[i][l] += beyond * shape[l];
      }
    }
  }
  return out;
}

double peak_variance(const RollPeak& peak, const PeakTerms& terms,
                     const std::array<DensityTerms, kMaxFrequencies - 1>& density) {
  std::array<double, kDensityTerms> sums{};
  for (std::size_t i = 0; i < peak.intervals.size(); ++i) {
    const DensityTerms& sea = density[peak.intervals[i].node];
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      sums[l] += terms[i][l] * sea[l];
    }
  }
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

}  // namespace quickstrip
