// Every capacity of the core, with its reason, for two machines: a bridge computer and a Cortex-M7. Changing
// one changes the memory of everything that holds it; the build prints what (firmware/memory).
//
// The profile belongs to the build: QUICKSTRIP_CAPACITY_M7 defined for every file of a program, or for none.
#pragma once

#include <cstddef>

namespace quickstrip {

namespace capacity {

/// A bridge computer: what the contract asks for, within 8 MiB.
struct Host {
  static constexpr std::size_t kMostBytes = 8U << 20U;  // of the advisor, all of its memory
  // The hull (contract: at least 64 stations of 128 points).
  static constexpr std::size_t kMaxStations = 64;
  static constexpr std::size_t kMaxOffsets = 128;
  // What is watched on board (contract).
  static constexpr std::size_t kMaxPoints = 16;
  static constexpr std::size_t kMaxSlammingStations = 8;
  static constexpr std::size_t kMaxFreeboardPoints = 8;
  // Channels of people, where criteria ask for them: one a point for motion sickness, two (to port and to
  // starboard) for interruptions. Four points of both.
  static constexpr std::size_t kMaxPeopleChannels = 12;
  // The grid that is swept each cycle (contract: 25 speeds x 72 headings).
  static constexpr std::size_t kMaxSpeeds = 25;
  // Directions of the wave energy and of the transfer functions, and headings: 5 degrees all round.
  static constexpr std::size_t kNumDirections = 72;
  // Wave frequencies of the transfer functions: resolves a JONSWAP peak of Tp 4 ... 25 s within 2 % of m0.
  static constexpr std::size_t kMaxFrequencies = 48;
  // Rows of numbers that a cycle streams begin on a line of the processor's memory.
  static constexpr std::size_t kCacheLine = 64;
  // The roll peak between the wave frequencies: intervals of one speed and direction that are looked into,
  // and points in them, three a panel. Measured enough for a ratio of damping of 0.02 (tests/advice).
  static constexpr std::size_t kMaxPeakIntervals = 14;
  static constexpr std::size_t kMaxPeakPoints = 48;
  // Roll in a seaway, whose damping grows with it: dampings at which variances are summed (two: between them
  // they err by 0.3 % of an RMS, tests/response), and nodes of encounter frequency (roll_update.hpp).
  static constexpr std::size_t kRollDampingLevels = 2;
  static constexpr std::size_t kNumRollUpdateNodes = 96;
  // Whether the grid holds a second added resistance, the semi-empirical one: a float a speed, direction and
  // frequency.
  static constexpr bool kKeepsEmpiricalResistance = true;
  // Encounter frequencies of the loaded hull's coefficient table: three decades, 7.5 % apart, which keeps the
  // parabola between them within 3e-3 of the section table (tests/strip).
  static constexpr std::size_t kNumEncounterNodes = 96;
  // The sea on the wire (contract: up to 6 systems; 64 frequencies x 72 directions).
  static constexpr std::size_t kMaxWaveSystems = 6;
  static constexpr std::size_t kMaxSpectrumFrequencies = 64;
  static constexpr std::size_t kMaxSpectrumDirections = 72;
  // Integrals of a sweep by direction, before they are turned into headings: of every channel in a few wave
  // systems, of a few channels at a time in a measured spectrum (core/response/heading_integrals.hpp).
  static constexpr std::size_t kSweepColumns = 4096;
  // Whether what is kept of a loaded hull is kept in single precision (core/base/held.hpp).
  static constexpr bool kHoldsSinglePrecision = false;
  // Criteria of a profile: seven kinds, the local ones at several places.
  static constexpr std::size_t kMaxCriteria = 32;
  // Of the ensemble of seas and ships within what is uncertain (core/advice/ensemble.hpp): a bit each.
  static constexpr std::size_t kEnsembleMembers = 16;
  // The compiled hull table: 24 stations at 9 levels, 64 at 3 (core/strip/hull_table.hpp). What the advisor
  // leaves of 8 MiB.
  static constexpr std::size_t kMaxHullTableBytes = 800U << 10U;
};

/// A Cortex-M7 of 512 KiB of RAM, the session and the stack included: a grid of 36 headings x 8 speeds, a
/// hull of a few stations, wave systems but no measured spectrum. Coarser by half in direction and in
/// frequency.
struct M7 {
  static constexpr std::size_t kMostBytes = 448U << 10U;  // of the advisor, all of its memory
  static constexpr std::size_t kMaxStations = 24;
  static constexpr std::size_t kMaxOffsets = 40;  // a minimal form needs 39
  static constexpr std::size_t kMaxPoints = 4;
  static constexpr std::size_t kMaxSlammingStations = 2;
  static constexpr std::size_t kMaxFreeboardPoints = 2;
  static constexpr std::size_t kMaxPeopleChannels = 1;  // motion sickness at one point: 2.2 kB a channel
  static constexpr std::size_t kMaxSpeeds = 8;
  static constexpr std::size_t kNumDirections = 36;
  static constexpr std::size_t kMaxFrequencies = 24;
  static constexpr std::size_t kCacheLine = 8;  // no lines: tightly packed
  static constexpr std::size_t kMaxPeakIntervals = 4;
  static constexpr std::size_t kMaxPeakPoints = 12;
  static constexpr std::size_t kRollDampingLevels = 2;
  static constexpr std::size_t kNumRollUpdateNodes = 64;
  static constexpr bool kKeepsEmpiricalResistance = false;  // no room
  static constexpr std::size_t kNumEncounterNodes = 48;
  static constexpr std::size_t kMaxWaveSystems = 3;
  // No measured spectrum, for two frequencies are none: the bands of one as a buoy gives it would take 75 kB.
  static constexpr std::size_t kMaxSpectrumFrequencies = 2;
  static constexpr std::size_t kMaxSpectrumDirections = 4;
  static constexpr std::size_t kSweepColumns = 320;
  static constexpr bool kHoldsSinglePrecision = true;
  static constexpr std::size_t kMaxCriteria = 12;
  static constexpr std::size_t kEnsembleMembers = 0;    // no room
  static constexpr std::size_t kMaxHullTableBytes = 0;  // read in place: it lies in flash
};

#if defined(QUICKSTRIP_CAPACITY_M7)
using Profile = M7;
inline constexpr const char* kProfileName = "m7";
#else
using Profile = Host;
inline constexpr const char* kProfileName = "host";
#endif

}  // namespace capacity

inline constexpr std::size_t kMostAdvisorBytes = capacity::Profile::kMostBytes;

inline constexpr std::size_t kMaxStations = capacity::Profile::kMaxStations;
inline constexpr std::size_t kMaxOffsets = capacity::Profile::kMaxOffsets;

inline constexpr std::size_t kMaxPoints = capacity::Profile::kMaxPoints;
inline constexpr std::size_t kMaxSlammingStations = capacity::Profile::kMaxSlammingStations;
inline constexpr std::size_t kMaxFreeboardPoints = capacity::Profile::kMaxFreeboardPoints;
// Where the water moves against the ship: slamming stations, freeboard points and the propeller.
inline constexpr std::size_t kMaxRelativeChannels = kMaxSlammingStations + kMaxFreeboardPoints + 1;
inline constexpr std::size_t kMaxPeopleChannels = capacity::Profile::kMaxPeopleChannels;
// Response channels: six motions, three accelerations at each point, relative motion, people.
inline constexpr std::size_t kMaxChannels = 6 + 3 * kMaxPoints + kMaxRelativeChannels + kMaxPeopleChannels;

inline constexpr std::size_t kMaxSpeeds = capacity::Profile::kMaxSpeeds;
inline constexpr std::size_t kNumDirections = capacity::Profile::kNumDirections;
inline constexpr std::size_t kMaxHeadings = kNumDirections;
// Solved directions: 0 ... 180 degrees; the port side is the mirror image.
inline constexpr std::size_t kNumSolvedDirections = kNumDirections / 2 + 1;

inline constexpr std::size_t kMaxFrequencies = capacity::Profile::kMaxFrequencies;
inline constexpr std::size_t kCacheLine = capacity::Profile::kCacheLine;
inline constexpr std::size_t kMaxPeakIntervals = capacity::Profile::kMaxPeakIntervals;
inline constexpr std::size_t kMaxPeakPoints = capacity::Profile::kMaxPeakPoints;
inline constexpr std::size_t kRollDampingLevels = capacity::Profile::kRollDampingLevels;
inline constexpr std::size_t kEnsembleMembers = capacity::Profile::kEnsembleMembers;
// Levels of damping at which a sweep holds motions of its own: of a shifted ship all of them.
inline constexpr std::size_t kMaxDampedLevels =
    kEnsembleMembers > 0 ? kRollDampingLevels : kRollDampingLevels - 1;
inline constexpr std::size_t kNumRollUpdateNodes = capacity::Profile::kNumRollUpdateNodes;
// Speeds of the semi-empirical added resistance; the one of a profile without it stays unused.
inline constexpr bool kKeepsEmpiricalResistance = capacity::Profile::kKeepsEmpiricalResistance;
inline constexpr std::size_t kMaxEmpiricalSpeeds = kKeepsEmpiricalResistance ? kMaxSpeeds : 1;
// Legendre terms of the wave energy density within an interval of wave frequencies: a cubic.
inline constexpr std::size_t kDensityTerms = 4;
inline constexpr std::size_t kNumEncounterNodes = capacity::Profile::kNumEncounterNodes;
// Memory beside the advisor's for a compiled hull table.
inline constexpr std::size_t kMaxHullTableBytes = capacity::Profile::kMaxHullTableBytes;

inline constexpr std::size_t kMaxWaveSystems = capacity::Profile::kMaxWaveSystems;
inline constexpr std::size_t kMaxSpectrumFrequencies = capacity::Profile::kMaxSpectrumFrequencies;
inline constexpr std::size_t kMaxSpectrumDirections = capacity::Profile::kMaxSpectrumDirections;
// Bands of wave energy on the grid: a measured spectrum's frequencies, and one at either end for what lies
// outside the transfer functions' frequencies.
inline constexpr std::size_t kMaxEnergyBands = kMaxSpectrumFrequencies + 2;

inline constexpr std::size_t kSweepColumns = capacity::Profile::kSweepColumns;

inline constexpr bool kHoldsSinglePrecision = capacity::Profile::kHoldsSinglePrecision;

inline constexpr std::size_t kMaxCriteria = capacity::Profile::kMaxCriteria;
// Changes of course or speed that are ranked and sent.
inline constexpr std::size_t kMaxChanges = 8;

// Speeds of a hull file's calm-water resistance.
inline constexpr std::size_t kMaxResistancePoints = 16;

// Names of points and criteria: bytes of UTF-8 including the final zero.
inline constexpr std::size_t kMaxNameBytes = 32;

}  // namespace quickstrip
