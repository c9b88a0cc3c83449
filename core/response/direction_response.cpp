#include "core/response/direction_response.hpp"

#include <cmath>

namespace quickstrip {
namespace {

double factor_of(Moment moment, double omega_e, double low) {
  switch (moment) {
    case Moment::kZeroth:
      return 1.0;
    case Moment::kFirst:
      return std::fabs(omega_e);
    case Moment::kSecond:
      return omega_e * omega_e;
    case Moment::kFourth:
      return omega_e * omega_e * omega_e * omega_e;
    case Moment::kLowEncounter:
      return low;
  }
  return 1.0;
}

}  // namespace

void list_values(const TransferFunctions& transfer, std::size_t speed, std::size_t m, const Channel& channel,
                 const LateralMotions* damped, const Encounters& encounters, const IncidentWave& wave,
                 ChannelValues& out) {
  node_energies(transfer, speed, m, channel, damped, encounters, wave, out.nodes);
  out.has_points = feels_roll(channel) && transfer.peak[speed][solved_direction(m)].num_points > 0;
  if (out.has_points) {
    point_energies(transfer, speed, m, channel, damped, encounters, out.points);
  }
}

void integrate_moment(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                      const Encounters& encounters, const PeakShapes& shapes, const SeaEnergy& sea,
                      Moment moment, const ChannelValues& values, std::span<double> out) {
  const std::size_t solved_m = solved_direction(m);
  const RollPeak& peak = transfer.peak[speed][solved_m];
  NodeValues nodes = values.nodes;
  if (moment != Moment::kZeroth) {
    for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
      nodes[f] *= factor_of(moment, encounters.frequency[f], encounters.low[f]);
    }
  }
  if (!values.has_points || moment == Moment::kLowEncounter) {  // the peak keeps off the floor
    integrate_over_bands(sea, nodes, peak, nullptr, out);
    return;
  }
  PointValues points = values.points;
  if (moment != Moment::kZeroth) {
    for (std::size_t p = 0; p < peak.num_points; ++p) {
      points[p] *= factor_of(moment, encounters.at_points[p], 0.0);
    }
  }
  PeakTerms terms{};
  list_peak_terms(peak, shapes, nodes, points, terms);
  integrate_over_bands(sea, nodes, peak, &terms, out);
}

}  // namespace quickstrip
