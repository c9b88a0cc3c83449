#include "core/response/point_motion.hpp"

namespace quickstrip {
namespace {

enum Mode : std::size_t { kSurge, kSway, kHeave, kRoll, kPitch, kYaw };

}  // namespace

PointMotion point_displacement(const MotionTransfer& transfer, const Position& position) {
  const auto& m = transfer.motion;
  return {m[kSurge] - position.y * m[kYaw] + position.z * m[kPitch],
          m[kSway] + position.x * m[kYaw] - position.z * m[kRoll],
          m[kHeave] - position.x * m[kPitch] + position.y * m[kRoll]};
}

PointMotion point_acceleration(const MotionTransfer& transfer, const Position& position, double gravity) {
  const PointMotion displacement = point_displacement(transfer, position);
  const double second_derivative = -transfer.encounter_frequency * transfer.encounter_frequency;
  return {second_derivative * displacement.x - gravity * transfer.motion[kPitch],
          second_derivative * displacement.y + gravity * transfer.motion[kRoll],
          second_derivative * displacement.z};
}

}  // namespace quickstrip
