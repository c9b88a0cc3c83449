#include "core/response/interruptions.hpp"

#include "core/response/short_term.hpp"

namespace quickstrip {
namespace {

constexpr double kMinutesPerHour = 60.0;
constexpr std::size_t kRollMode = 3;

}  // namespace

Channel interruption_channel(const Channel& acceleration, const Stance& stance, bool to_starboard,
                             double gravity) {
  const LinearForm lateral = linear_form(Quantity::kLateralAcceleration, acceleration.position, gravity);
  const LinearForm vertical = linear_form(Quantity::kVerticalAcceleration, acceleration.position, gravity);
  const double of_vertical = to_starboard ? stance.half_width_ratio : -stance.half_width_ratio;
  Channel channel{.quantity = Quantity::kMotionInterruptions,
                  .place = acceleration.place,
                  .role = acceleration.role,
                  .position = acceleration.position,
                  .to_starboard = to_starboard,
                  .level = stance.half_width_ratio * gravity};
  for (std::size_t j = 0; j < channel.form.displacement.size(); ++j) {
    channel.form.displacement[j] = -lateral.displacement[j] + of_vertical * vertical.displacement[j];
    channel.form.acceleration[j] = -lateral.acceleration[j] + of_vertical * vertical.acceleration[j];
  }
  channel.form.acceleration[kRollMode] -= stance.height / 3.0;  // phi_dd = -omega_e^2 phi
  return channel;
}

double interruptions_per_minute(double level, double m0, double m2) {
  return oscillations_per_hour(m0, m2) / kMinutesPerHour * rayleigh_exceedance(level, m0);
}

}  // namespace quickstrip
