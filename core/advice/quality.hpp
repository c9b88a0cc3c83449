// Quality bits that follow from the ship, her speed and the water, not from a response.
#pragma once

#include <cstdint>
#include <optional>

#include "core/advice/advice.hpp"
#include "core/hull/hull.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

inline constexpr double kHighFroude = 0.35;       // [Journee1992] §6
inline constexpr double kLowLengthBreadth = 3.0;  // [Journee1992] §2: strip theory needs L/B of about three

/// Of the hull and its loading.
std::uint32_t hull_quality(const LoadedHull& loaded, const Loading& loading);

/// kQualityHighFroude or none; speed [m/s], lpp [m], gravity [m/s2].
std::uint32_t speed_quality(double speed, double lpp, double gravity);

/// Everything here is for deep water. It is not deep when it is shallower than half the length of the waves,
/// g T^2 / 4 pi, T the peak period of the systems averaged by energy (there the wave number is 0.4 % off, at
/// half that depth 9 %), or than three draughts (PIANC's limit of deep water for a ship's hydrodynamics).
/// kQualityShallowWater or none; depth from the surface [m], empty: not known.
std::uint32_t depth_quality(std::optional<double> depth, const SeaEnergy& sea, const Loading& loading);

}  // namespace quickstrip
