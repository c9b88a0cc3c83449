// What the bridge is told: verdict per cell of the heading x speed grid, and advice for the present course
// and speed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/advice/criteria.hpp"
#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"
#include "core/hazard/hazard_bits.hpp"

namespace quickstrip {

enum class Verdict : std::uint8_t { kUnknown = 0, kGood = 1, kCaution = 2, kExceeded = 3 };

/// Bits that travel with a number (formulas §6, [Journee1992] §6): usable, but for a reason to be said.
/// Worded once, in msgs/convert/quality_text.hpp and msgs/CHANNELS.md.
enum QualityBit : std::uint32_t {
  kQualityReplacedSection = 1u << 0,     // sections that no Lewis form fits
  kQualityLowEncounter = 1u << 1,        // energy at encounter frequencies below the floor
  kQualityHighFroude = 1u << 2,          // Fn above 0.35: strip theory less accurate
  kQualityLowLengthBreadth = 1u << 3,    // L/B below 3
  kQualityExtremeMotion = 1u << 4,       // RMS roll above 10 degrees: linear roll invalid
  kQualityTailLost = 1u << 5,            // more than 1 % of m0 outside the frequency range
  kQualitySpeedOverGround = 1u << 6,     // speed through water not known
  kQualityFreeSurfaceUnknown = 1u << 7,  // no free-surface correction given
  kQualityWideBand = 1u << 8,       // a watched response of bandwidth above kWideBandwidth (short_term.hpp)
  kQualitySwellUpRange = 1u << 9,   // swell-up outside the range of its formula: a factor stands for it
  kQualityShallowWater = 1u << 10,  // the water is not deep for these waves or this ship
  kQualityRollDampingRange = 1u << 11,  // roll damping outside the range of its formulas
  kQualityRollNotConverged = 1u << 12,  // roll linearisation ended with a residual worth saying
  kQualitySpeedNotKept = 1u << 13,      // takes more power than the hull file gives
  kQualityOutsideHullTable = 1u << 14,  // draughts that the compiled hull table lacks: Lewis forms stand in
};
inline constexpr std::size_t kNumQualityBits = 15;

inline constexpr std::uint8_t kNoCriterion = 255;
inline constexpr std::uint8_t kNoSystem = 255;

/// In a column that the hull or the criteria do not give (no bridge point, no slamming station ...).
inline constexpr float kNotComputed = -1.0F;
/// The same of an added resistance, which may well be -1 N.
inline constexpr float kNoResistance = -3.0e38F;

/// One cell. values: one per criterion, in the criterion's statistic (rad, m/s2, probability, 1/h);
/// kNotComputed for a criterion that is not watched.
/// margin: factor by which wave height may grow before the governing limit is reached (1 = at the limit; +inf
/// never: stored as kMarginUnbounded).
struct Cell {
  Verdict verdict = Verdict::kUnknown;
  std::uint8_t governing = kNoCriterion;      // index into Criteria
  std::uint8_t governing_system = kNoSystem;  // wave system that contributes most of the governing variance
  std::uint8_t next = kNoCriterion;           // the criterion nearest to its limit after the governing one
  std::uint16_t hazards = 0;                  // HazardBit
  std::uint16_t next_margin_steps = 0;        // its margin in steps of kNextMarginStep, rounded down
  std::uint32_t quality = 0;
  float margin = 0.0F;
  std::array<float, kMaxCriteria> values{};
  // for the picture and the wire, whatever the criteria are
  float rms_roll = 0.0F;                     // rad
  float rms_bridge_vertical = kNotComputed;  // m/s2, worst point of role bridge
  float roll_exceedance = kNotComputed;   // that a roll amplitude exceeds the limit's significant amplitude
  float slam_probability = kNotComputed;  // per encounter, worst station
  float slams_per_hour = kNotComputed;    // worst station
  float wetness_probability = kNotComputed;  // per encounter, worst point
  float low_encounter_share = 0.0F;          // largest among wave energy and watched variances
  // Roll damping beyond potential theory that the cell's own roll calls for: ratio of critical, and what is
  // left of its equation (response/roll_linearisation.hpp).
  float roll_damping_ratio = 0.0F;
  float roll_damping_residual = 0.0F;
  // Mean added resistance in this sea, + aft [N]: by strip theory, and by the semi-empirical method in its
  // range. A wave from astern may push.
  float added_resistance = kNoResistance;
  float added_resistance_empirical = kNoResistance;
  float speed_loss = kNotComputed;  // involuntary, at the power of calm water [m/s]: speed_loss.hpp
};

inline constexpr float kMarginUnbounded = 99.0F;
/// The next margin takes two bytes of a cell that were free.
inline constexpr float kNextMarginStep = 0.002F;

/// Factor on wave height until the next criterion's limit; kNotComputed: there is none.
inline float next_margin(const Cell& cell) {
  return cell.next == kNoCriterion ? kNotComputed
                                   : kNextMarginStep * static_cast<float>(cell.next_margin_steps);
}

/// heading h: compass 2 pi h / num_headings; speed s: speeds[s]. 1,800 cells of about 190 bytes: static.
struct Grid {
  std::size_t num_speeds = 0;
  std::size_t num_headings = 0;
  std::array<double, kMaxSpeeds> speeds{};  // m/s
  std::array<std::array<Cell, kMaxHeadings>, kMaxSpeeds> cells{};
};

/// The way from the present course and speed to the new ones (turn.hpp): what the ship meets between the
/// first order and the new state. It does not know the heel of the turn itself.
struct Turn {
  bool is_known = false;
  Verdict worst_verdict = Verdict::kUnknown;    // where on the way it is worst, and what it is there
  std::uint8_t worst_governing = kNoCriterion;  // index into Criteria
  std::uint8_t worst_system = kNoSystem;        // the wave system that gives most of it
  std::uint16_t worst_hazards = 0;
  float worst_margin = 0.0F;
  float worst_heading = 0.0F;     // rad
  float worst_speed = 0.0F;       // m/s
  float time = 0.0F;              // s, until course and speed are there
  float time_exceeded = 0.0F;     // s of it in cells above a limit
  float time_unknown = 0.0F;      // s of it in cells that are not judged
  float max_roll = kNotComputed;  // rad, most probable largest amplitude on the way
};

/// As outlook_t's CHANGE_...
enum class ChangeKind : std::uint8_t {
  kSmallest = 0,  // the least effort that works
  kLarger = 1,    // more effort, and much more margin
  kHeaveTo = 2,   // bow to the sea at the lowest steerage speed
  kOther = 3,
};

/// A change of course and/or speed that brings the ship back inside the limits.
struct Change {
  double heading = 0.0;         // new heading [rad], compass
  double speed = 0.0;           // new speed [m/s]
  double heading_change = 0.0;  // as turned, + to starboard [rad]; beyond pi: the longer way round
  double speed_change = 0.0;    // signed [m/s]
  double effort = 0.0;          // what "smallest" means: see ranking.hpp
  Verdict verdict = Verdict::kUnknown;
  std::uint8_t governing = kNoCriterion;
  float margin = 0.0F;
  ChangeKind kind = ChangeKind::kOther;
  std::uint8_t governing_system = kNoSystem;
  std::uint16_t hazards = 0;
  std::uint8_t next = kNoCriterion;  // the criterion nearest to its limit after the governing one
  float next_margin = kNotComputed;  // factor on wave height; kNotComputed: there is none
  float speed_loss = kNotComputed;   // involuntary, at the new course and speed [m/s]
  Turn turn{};
};

enum class NoAdvice : std::uint8_t {
  kNone = 0,
  kNotConfigured,
  kSeaMissing,
  kSeaStale,
  kSeaImplausible,
  kOwnShipMissing,
  kOwnShipStale,
  kOwnShipImplausible,
  kLoadingMissing,
  kLoadingStale,
  kLoadingImplausible,
  kLoadingChanged,  // the hull is being rebuilt for a new loading
  kSpeedOutsideGrid,
  kInternal,
  kSelfTestFailed,
};

struct Advice {
  NoAdvice no_advice = NoAdvice::kNotConfigured;  // kNone: the rest is valid
  Heading heading{};
  double speed = 0.0;  // m/s
  Cell present{};      // at the present course and speed; its verdict is the steady one (steadiness.hpp)
  Verdict verdict_now = Verdict::kUnknown;  // of this cycle alone: never worse than the steady one
  double better_in = 0.0;            // s until the steady verdict follows, if this lasts; 0: it does already
  std::uint8_t next = kNoCriterion;  // as in Change, at the present course and speed
  float next_margin = kNotComputed;
  StaticVector<Change, kMaxChanges>
      changes{};                 // the recommended one first; empty when none is needed or none helps
  bool change_needed = false;    // present verdict is not good
  bool none_is_good = false;     // needed, and no cell is good: changes lead to the best that can be had
  bool no_change_helps = false;  // needed, and no cell is better
};

}  // namespace quickstrip
