// The hull and what is watched on it: the contents of a hull file, in SI units. Filled by a reader, checked
// by `check`.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/constants.hpp"
#include "core/base/name.hpp"
#include "core/base/static_vector.hpp"

namespace quickstrip {

/// Half-breadth y >= 0 and height z above the base line [m].
struct Offset {
  double y = 0.0;
  double z = 0.0;
};

/// x from the aft perpendicular, positive forward [m]. Offsets run from keel to deck; or none, and the
/// minimal form of [Journee1992] §4: breadth at the waterline, draught and immersed area at one draught.
struct Station {
  double x = 0.0;
  StaticVector<Offset, kMaxOffsets> offsets;
  double breadth = 0.0;
  double draught = 0.0;
  double area = 0.0;
  [[nodiscard]] bool is_minimal() const { return offsets.empty(); }
};

/// Loading condition; draughts at the perpendiculars above the base line [m], kg solid above base [m].
struct Loading {
  double draught_aft = 0.0;
  double draught_fwd = 0.0;
  double kg = 0.0;
  std::optional<double> free_surface_correction;  // m; stiffness uses fluid GM = KM - kg - correction
  std::optional<double> gm;                       // m, fluid; replaces kg and correction in the stiffness
  double roll_gyradius = 0.0;                     // m, dry
  double pitch_gyradius = 0.0;
  double yaw_gyradius = 0.0;
  std::optional<double> measured_roll_period;  // s
  double water_density = kSeaWaterDensity;
  double viscosity = kSeaWaterKinematicViscosity;
  double gravity = kStandardGravity;
  bool operator==(const Loading&) const = default;
};

enum class RollDampingMethod : std::uint8_t { kRatio, kIkeda };

struct BilgeKeel {
  double x_aft = 0.0;
  double x_fwd = 0.0;
  double breadth = 0.0;
};

/// Active stabilisers, while own ship says that they work: damping as a ratio of critical at a speed. Fins
/// live from lift: as the square of the speed below it, no more above.
struct Stabiliser {
  double ratio = 0.0;
  double speed = 0.0;  // m/s, > 0
};

/// Ratio: b44,added = 2 ratio c44 / omega_n, with omega_n from a44(omega_n); ADDED to potential damping.
struct RollDamping {
  RollDampingMethod method = RollDampingMethod::kRatio;
  double ratio = 0.05;
  std::optional<BilgeKeel> bilge_keel;
  std::optional<Stabiliser> stabiliser;
};

enum class PointRole : std::uint8_t { kBridge, kForwardPerpendicular, kDeck, kPassengers, kOther };

/// x from the aft perpendicular, y to port, z above base [m].
struct PointOfInterest {
  Name name;
  PointRole role = PointRole::kOther;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

struct SlammingStation {
  Name name;
  double x = 0.0;
  std::optional<double> threshold_velocity;  // m/s; default 0.0928 sqrt(g lpp) [Ochi1964]
};

struct FreeboardPoint {
  Name name;
  double x = 0.0;
  double height = 0.0;  // of the deck edge above base [m]
};

struct Propeller {
  double x = 0.0;
  double tip_z = 0.0;
};

/// What the advisor sweeps: speeds from ... to by step [m/s], headings all round by heading_step [rad], a
/// multiple of the direction grid (5 degrees) that divides the circle.
struct GridDefinition {
  double speed_from = 0.0;
  double speed_to = 0.0;
  double speed_step = 0.0;
  double heading_step = 0.0;
};

/// How the ship changes course and speed, for what she meets on the way (advice/turn.hpp). The values here
/// are ours, of no ship: a careful alteration in a seaway, well below what full rudder does.
struct Handling {
  double turn_rate = radians(30.0) / 60.0;            // rad/s
  double slowing = (1852.0 / 3600.0) / 60.0;          // m/s2: 1 kn a minute
  double speeding_up = 0.5 * (1852.0 / 3600.0) / 60;  // m/s2
};

/// Resistance in calm water [N] at a speed [m/s].
struct CalmWaterResistance {
  double speed = 0.0;
  double force = 0.0;
};

struct Hull {
  Name name;
  double lpp = 0.0;
  double breadth = 0.0;
  StaticVector<Station, kMaxStations> stations;  // increasing x
  Loading loading;
  RollDamping roll_damping;
  StaticVector<PointOfInterest, kMaxPoints> points;
  StaticVector<SlammingStation, kMaxSlammingStations> slamming;
  StaticVector<FreeboardPoint, kMaxFreeboardPoints> freeboard;
  std::optional<Propeller> propeller;
  double min_steerage_speed = 0.0;  // m/s
  Handling handling;
  StaticVector<CalmWaterResistance, kMaxResistancePoints> resistance;  // increasing speed; none: not known
  GridDefinition grid;
};

}  // namespace quickstrip
