#include "core/response/direction_response.hpp"

#include <cmath>

namespace quickstrip {
namespace {

void integrate_with_peak(const RollPeak& peak, const PeakShapes& shapes, const SeaEnergy& sea,
                         const ChannelValues& values, std::span<double> out) {
  if (!values.has_points) {
    integrate_over_bands(sea, values.nodes, peak, nullptr, out);
    return;
  }
  PeakTerms terms;
  list_peak_terms(peak, shapes, values.nodes, values.points, terms);
  integrate_over_bands(sea, values.nodes, peak, &terms, out);
}

// One loop a moment: a choice within would keep the compiler from making vectors of it.
template <std::size_t N>
void weigh(Moment moment, const std::array<double, N>& omega_e, std::size_t n,
           std::array<double, N>& values) {
  switch (moment) {
    case Moment::kZeroth:
    case Moment::kLowEncounter:
      return;
    case Moment::kFirst:
      for (std::size_t i = 0; i < n; ++i) {
        values[i] *= std::fabs(omega_e[i]);
      }
      return;
    case Moment::kSecond:
      for (std::size_t i = 0; i < n; ++i) {
        values[i] *= omega_e[i] * omega_e[i];
      }
      return;
    case Moment::kFourth:
      for (std::size_t i = 0; i < n; ++i) {
        values[i] *= (omega_e[i] * omega_e[i]) * (omega_e[i] * omega_e[i]);
      }
      return;
  }
}

}  // namespace

void list_values(const MetWaves& met, bool is_from_port, const Channel& channel, const LateralMotions* damped,
                 const IncidentWave& wave, ChannelValues& out) {
  ChannelPart longitudinal;
  longitudinal_part(met, channel, wave, longitudinal);
  if (!feels_roll(channel)) {
    list_square(met, channel, longitudinal, out);
    return;
  }
  ChannelPart lateral;
  lateral_part(met, channel, damped, lateral);
  ChannelValues odd;
  list_even_odd(met, channel, longitudinal, lateral, out, odd);
  const double side = is_from_port ? -1.0 : 1.0;
  for (std::size_t f = 0; f < met.transfer.num_frequencies; ++f) {
    out.nodes[f] += side * odd.nodes[f];
  }
  for (std::size_t p = 0; p < met.peak().num_points; ++p) {
    out.points[p] += side * odd.points[p];
  }
}

void integrate_moment(const MetWaves& met, const PeakShapes& shapes, const SeaEnergy& sea, Moment moment,
                      const ChannelValues& values, std::span<double> out) {
  const RollPeak& peak = met.peak();
  if (moment == Moment::kLowEncounter) {  // the peak keeps off the floor
    NodeValues low{};
    for (std::size_t f = 0; f < met.transfer.num_frequencies; ++f) {
      low[f] = values.nodes[f] * met.encounters.low[f];
    }
    integrate_over_bands(sea, low, peak, nullptr, out);
    return;
  }
  if (moment == Moment::kZeroth) {
    integrate_with_peak(peak, shapes, sea, values, out);
    return;
  }
  ChannelValues weighed = values;
  weigh(moment, met.encounters.frequency, met.transfer.num_frequencies, weighed.nodes);
  weigh(moment, met.encounters.at_points, values.has_points ? peak.num_points : 0, weighed.points);
  integrate_with_peak(peak, shapes, sea, weighed, out);
}

}  // namespace quickstrip
