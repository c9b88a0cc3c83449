// Every capacity of the core, with its reason. Changing one changes the memory of everything that holds it.
#pragma once

#include <cstddef>

namespace quickstrip {

// The hull (contract: at least 64 stations of 128 points).
inline constexpr std::size_t kMaxStations = 64;
inline constexpr std::size_t kMaxOffsets = 128;

// What is watched on board (contract).
inline constexpr std::size_t kMaxPoints = 16;
inline constexpr std::size_t kMaxSlammingStations = 8;
inline constexpr std::size_t kMaxFreeboardPoints = 8;

// Response channels: six motions, three accelerations at each point, relative motion at each station and
// point.
inline constexpr std::size_t kMaxChannels = 6 + 3 * kMaxPoints + kMaxSlammingStations + kMaxFreeboardPoints;

// The grid that is swept each cycle (contract: 25 speeds x 72 headings).
inline constexpr std::size_t kMaxSpeeds = 25;
inline constexpr std::size_t kMaxHeadings = 72;

// Directions of the wave energy and of the transfer functions: 5 degrees all round.
inline constexpr std::size_t kNumDirections = 72;
// Solved directions: 0 ... 180 degrees; the port side is the mirror image.
inline constexpr std::size_t kNumSolvedDirections = kNumDirections / 2 + 1;

// Wave frequencies of the transfer functions: resolves a JONSWAP peak of Tp 4 ... 25 s within 2 % of m0.
inline constexpr std::size_t kMaxFrequencies = 48;
// The roll peak between the wave frequencies: intervals of one speed and direction that are looked into, and
// points in them, three a panel. Measured enough for a ratio of damping of 0.02 (tests/advice).
inline constexpr std::size_t kMaxPeakIntervals = 12;
inline constexpr std::size_t kMaxPeakPoints = 36;
// Legendre terms of the wave energy density within an interval of wave frequencies: a cubic.
inline constexpr std::size_t kDensityTerms = 4;
// Encounter frequencies of the loaded hull's coefficient table: three decades, 7.5 % apart, which keeps the
// parabola between them within 3e-3 of the section table (tests/strip).
inline constexpr std::size_t kNumEncounterNodes = 96;

// The sea on the wire (contract: up to 6 systems; 64 frequencies x 72 directions).
inline constexpr std::size_t kMaxWaveSystems = 6;
inline constexpr std::size_t kMaxSpectrumFrequencies = 64;
inline constexpr std::size_t kMaxSpectrumDirections = 72;

// Criteria of a profile: seven kinds, the local ones at several places.
inline constexpr std::size_t kMaxCriteria = 32;
// Changes of course or speed that are ranked and sent.
inline constexpr std::size_t kMaxChanges = 8;

// Names of points and criteria: bytes of UTF-8 including the final zero.
inline constexpr std::size_t kMaxNameBytes = 32;

}  // namespace quickstrip
