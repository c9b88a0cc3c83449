// Physical and mathematical constants, with their sources. SI units.
#pragma once

namespace quickstrip {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTwoPi = 2.0 * kPi;
inline constexpr double kEulerGamma = 0.57721566490153286061;

inline constexpr double kStandardGravity = 9.80665;             // m/s2, CGPM 1901; contract default
inline constexpr double kSeaWaterDensity = 1025.0;              // kg/m3, contract default
inline constexpr double kSeaWaterKinematicViscosity = 1.19e-6;  // m2/s at 15 degrees, contract default

}  // namespace quickstrip
