#include "core/response/relative_motion.hpp"

#include <cmath>

namespace quickstrip {

std::complex<double> incident_wave(const Position& position, double wave_number, EncounterAngle mu) {
  const double lag = wave_number * (position.x * std::cos(mu.radians) + position.y * std::sin(mu.radians));
  return {std::cos(lag), -std::sin(lag)};
}

std::complex<double> relative_motion(const MotionTransfer& transfer, const Position& position,
                                     double wave_number, EncounterAngle mu) {
  return incident_wave(position, wave_number, mu) - point_displacement(transfer, position).z;
}

}  // namespace quickstrip
