#include "core/advice/cell_response.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/response/deck_wetness.hpp"
#include "core/response/interruptions.hpp"
#include "core/response/mean_added_resistance.hpp"
#include "core/response/moments.hpp"
#include "core/response/motion_sickness.hpp"
#include "core/response/propeller_emergence.hpp"
#include "core/response/short_term.hpp"
#include "core/response/slamming.hpp"

namespace quickstrip {

namespace {

/// What people feel is the acceleration; the moments are those of the velocity.
QuantityResponse sickness_response(const Channel& channel, const ResponseMoments& moments) {
  const VerticalShaking shaking = vertical_shaking(moments.m0, moments.m2);
  QuantityResponse out{.quantity = channel.quantity,
                       .place = channel.place,
                       .rms = shaking.rms_acceleration,
                       .significant = significant_amplitude(moments.m2),
                       .t1 = mean_period(moments.m0, moments.m1),
                       .t2 = zero_crossing_period(moments.m0, moments.m2),
                       .probability = motion_sickness(shaking, 0.0),
                       .low_encounter_share = moments.m0 > 0.0 ? moments.m0_low_encounter / moments.m0 : 0.0,
                       .variance = moments.m0_by_system};
  for (double& variance : out.variance) {
    variance *= shaking.frequency * shaking.frequency;
  }
  return out;
}

}  // namespace

QuantityResponse quantity_response(const Channel& channel, double speed, const ResponseMoments& moments) {
  if (channel.quantity == Quantity::kMotionSickness) {
    return sickness_response(channel, moments);
  }
  QuantityResponse out{.quantity = channel.quantity,
                       .place = channel.place,
                       .to_starboard = channel.to_starboard,
                       .rms = std::sqrt(moments.m0),
                       .significant = significant_amplitude(moments.m0),
                       .t1 = mean_period(moments.m0, moments.m1),
                       .t2 = zero_crossing_period(moments.m0, moments.m2),
                       .low_encounter_share = moments.m0 > 0.0 ? moments.m0_low_encounter / moments.m0 : 0.0,
                       .variance = moments.m0_by_system};
  if (moments.m4 != kNoMoment) {
    out.t4 = crest_period(moments.m2, moments.m4);
    out.bandwidth = bandwidth(moments.m0, moments.m2, moments.m4);
  }
  const double level = level_at(channel, speed);
  if (channel.quantity == Quantity::kSlamming) {
    out.probability = slamming_probability(level, channel.threshold_velocity, moments.m0, moments.m2);
    out.per_hour = slams_per_hour(level, channel.threshold_velocity, moments.m0, moments.m2);
  } else if (channel.quantity == Quantity::kDeckWetness) {
    out.probability = wetness_probability(level, moments.m0);
    out.per_hour = wetnesses_per_hour(level, moments.m0, moments.m2);
  } else if (channel.quantity == Quantity::kPropellerEmergence) {
    out.probability = emergence_probability(level, moments.m0);
    out.per_hour = emergences_per_hour(level, moments.m0, moments.m2);
  } else if (channel.quantity == Quantity::kMotionInterruptions) {
    out.probability = rayleigh_exceedance(channel.level, moments.m0);
    out.per_hour = 60.0 * interruptions_per_minute(channel.level, moments.m0, moments.m2);
  }
  return out;
}

double expected_largest(const QuantityResponse& response, double duration) {
  constexpr double kHour = 3600.0;
  if (response.per_hour >= 0.0) {
    return response.per_hour * duration / kHour;
  }
  if (!(response.t2 > 0.0)) {
    return 0.0;
  }
  const double m0 = response.rms * response.rms;
  const double omega = kTwoPi / response.t2;
  return most_probable_maximum(m0, m0 * omega * omega, duration);
}

Status respond(const GridInputs& inputs, Heading heading, double speed, CellResponse& out) {
  std::array<ResponseMoments, kMaxChannels> all{};
  const auto moments = std::span(all).first(inputs.watch.channels.size());
  const MomentOptions options{inputs.wants_all_bandwidths ? nullptr : &inputs.channels.is_watched,
                              inputs.is_stabilised, &inputs.waves};
  const Result<RollDampingInUse> damping =
      response_moments(inputs.transfer, inputs.watch, inputs.sea, heading, speed, moments, options);
  if (!damping) {
    return damping.error();
  }
  out.heading = heading;
  out.speed = speed;
  out.num_systems = inputs.sea.num_systems;
  const Result<double> slow = slow_wave_share(inputs.transfer, inputs.sea, heading, speed);
  const double share = slow ? *slow : 1.0;
  out.cell = judge(inputs.criteria, inputs.channels, inputs.watch, moments,
                   circumstances(inputs, heading, speed, share, *damping));
  if (out.cell.governing != kNoCriterion) {
    const std::size_t channel = inputs.channels.of_criterion[out.cell.governing];
    out.cell.governing_system =
        largest_system(moments_of(inputs.criteria[out.cell.governing], channel, moments));
  }
  const Result<MeanResistance> resistance =
      mean_added_resistance(inputs.transfer, inputs.sea, heading, speed);
  if (!resistance) {
    return resistance.error();
  }
  out.cell.added_resistance = static_cast<float>(resistance->strip);
  if (resistance->empirical) {
    out.cell.added_resistance_empirical = static_cast<float>(*resistance->empirical);
  }
  out.quantities.clear();
  for (std::size_t c = 0; c < moments.size(); ++c) {
    QS_CHECK(out.quantities.push_back(quantity_response(inputs.watch.channels[c], speed, moments[c])));
    if (inputs.channels.is_watched[c] && out.quantities[c].bandwidth > kWideBandwidth) {
      out.cell.quality |= kQualityWideBand;
    }
  }
  return {};
}

}  // namespace quickstrip
