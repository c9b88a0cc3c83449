// First half of the division of a spectrum: smoothing and watershed by steepest ascent (see partition.hpp).
// Cells are numbered f * num_directions + d; neighbours are the eight around, directions closing the circle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/sea/sea_state.hpp"

namespace quickstrip {

inline constexpr std::size_t kMaxSpectrumCells = kMaxSpectrumFrequencies * kMaxSpectrumDirections;
// No two peaks are neighbours: at most one in four cells.
inline constexpr std::size_t kMaxBasins = kMaxSpectrumCells / 4;
inline constexpr std::uint16_t kNoBasin = 0xFFFF;

/// Scratch of one division; its content means nothing between calls. 69 kB: static.
struct PartitionWorkspace {
  std::array<double, kMaxSpectrumCells> height{};        // smoothed density
  std::array<std::uint16_t, kMaxSpectrumCells> order{};  // cells, descending
  std::array<std::uint16_t, kMaxSpectrumCells> basin{};  // of each cell, kNoBasin where the height is zero
  std::array<std::uint16_t, kMaxBasins> parent{};        // basin that this one has joined, or itself
  std::array<std::uint16_t, kMaxBasins> peak{};          // cell
  std::array<double, kMaxBasins> energy{};               // m2
};

/// Fills height, basin (a root each), parent and peak; returns the number of basins, joined ones included.
/// `valley`: two basins that meet above this part of the lower peak are one.
std::size_t find_basins(const DirectionalSpectrum& spectrum, double valley, PartitionWorkspace& work);

}  // namespace quickstrip
