#include "sim/hull_tool/quantity_name.hpp"

namespace quickstrip::hull_tool {

QuantityName name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kSurge:
      return {"surge", "m"};
    case Quantity::kSway:
      return {"sway", "m"};
    case Quantity::kHeave:
      return {"heave", "m"};
    case Quantity::kRoll:
      return {"roll", "rad"};
    case Quantity::kPitch:
      return {"pitch", "rad"};
    case Quantity::kYaw:
      return {"yaw", "rad"};
    case Quantity::kLongitudinalAcceleration:
      return {"longitudinal_acceleration", "m/s2"};
    case Quantity::kLateralAcceleration:
      return {"lateral_acceleration", "m/s2"};
    case Quantity::kVerticalAcceleration:
      return {"vertical_acceleration", "m/s2"};
    case Quantity::kSlamming:
      return {"slamming", "m"};
    case Quantity::kDeckWetness:
      return {"deck_wetness", "m"};
    case Quantity::kPropellerEmergence:
      return {"propeller_emergence", "m"};
    case Quantity::kMotionSickness:
      return {"motion_sickness", "m/s2"};
    case Quantity::kMotionInterruptions:
      return {"motion_interruptions", "m/s2"};
    case Quantity::kDisplacementX:
      return {"displacement_x", "m"};
    case Quantity::kDisplacementY:
      return {"displacement_y", "m"};
    case Quantity::kDisplacementZ:
      return {"displacement_z", "m"};
    case Quantity::kVelocityX:
      return {"velocity_x", "m/s"};
    case Quantity::kVelocityY:
      return {"velocity_y", "m/s"};
    case Quantity::kVelocityZ:
      return {"velocity_z", "m/s"};
    case Quantity::kRelativeMotion:
      return {"relative_motion", "m"};
    case Quantity::kRelativeVelocity:
      return {"relative_velocity", "m/s"};
  }
  return {"unknown", ""};
}

std::optional<Quantity> quantity_of(std::string_view name) {
  for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(Quantity::kRelativeVelocity); ++i) {
    if (name == name_of(Quantity{i}).name) {
      return Quantity{i};
    }
  }
  return std::nullopt;
}

std::string quantity_names() {
  std::string names;
  for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(Quantity::kRelativeVelocity); ++i) {
    names.append(names.empty() ? "" : ", ").append(name_of(Quantity{i}).name);
  }
  return names;
}

std::string place_of(Quantity quantity, std::uint8_t place, const Hull& hull) {
  switch (quantity) {
    case Quantity::kLongitudinalAcceleration:
    case Quantity::kLateralAcceleration:
    case Quantity::kVerticalAcceleration:
    case Quantity::kMotionSickness:
    case Quantity::kMotionInterruptions:
      return std::string(hull.points[place].name.view());
    case Quantity::kSlamming:
      return std::string(hull.slamming[place].name.view());
    case Quantity::kDeckWetness:
      return std::string(hull.freeboard[place].name.view());
    case Quantity::kPropellerEmergence:
      return "propeller";
    default:
      return "G";
  }
}

}  // namespace quickstrip::hull_tool
