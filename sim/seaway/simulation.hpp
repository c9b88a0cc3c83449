// A ship in a simulated seaway, block by block, and what is counted on board.
//
// The run is cut into independent blocks of an hour (of X / 16 hours, at least a quarter, for short runs).
// In a block every wave cell has a complex normal amplitude of its own, so the sea and every linear response
// are exactly Gaussian, stationary and periodic with the block; motions are sums of transfer function times
// wave. With a roll damping law, roll, sway and yaw get what the quadratic damping does to them
// (roll_memory.hpp) and everything else follows.
//
// An encounter is a cycle of the channel counted, from one zero up-crossing to the next; where both sides
// count (roll, accelerations) a half cycle. An event is an outward crossing of the level; of a slam, the keel
// going back into the water (relative motion rising through minus the draught) faster than the threshold.
// Cost: 5 to 15 ms an hour. Seeded: the same seed gives the same bits; a block does not depend on those
// before it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sim/seaway/intervals.hpp"
#include "sim/seaway/roll_memory.hpp"
#include "sim/seaway/wave_answers.hpp"

namespace quickstrip::seaway {

inline constexpr double kMostHours = 100'000.0;

struct Plan {
  Heading heading;
  double speed = 0.0;       // m/s
  double hours = 1.0;       // (0, kMostHours]
  bool steps_roll = false;  // in time, under the damping law; else linear, with the hull's own damping
};

/// All that does not change from block to block.
struct Simulation {
  std::size_t num_blocks = 0;
  double block_s = 0.0;
  std::size_t num_samples = 0;  // of a block
  WaveAnswers answers;
  // With roll stepped in time only:
  std::optional<RollMemory> memory;
  RollDampingLaw law;                  // after prepare(): the base damping alone
  double base_damping = 0.0;           // added, in the answers [N m s]
  std::vector<Complex> roll_answer;    // of a unit roll moment, by bin, base damping included
  std::vector<Complex> sway_per_roll;  // the ship's own ratio, by bin
  std::vector<Complex> yaw_per_roll;

  [[nodiscard]] double dt() const { return block_s / static_cast<double>(num_samples); }
};

/// Errors: kSingular, kOutOfRange (hours), kTooMany (the blocks would not fit in memory: a tiny ship).
Result<Simulation> prepare(const LoadedHull& hull, const Watch& watch, const Beams& sea, const Plan& plan);

enum class Passing : std::uint8_t { kBothSides, kAbove, kReentry };

struct Question {
  std::size_t channel = 0;  // of the watch
  Passing passing = Passing::kBothSides;
  double level = 0.0;
  double least_speed = 0.0;  // of a re-entry [1/s of the channel's unit]
};

struct Answer {
  std::vector<BlockCount> per_encounter;  // by block
  std::vector<BlockCount> per_hour;       // exposure: hours; one side of two
  double events = 0.0;
  double encounters = 0.0;
  double encounters_with_event = 0.0;
};

/// Of a channel over the whole run.
struct ChannelOutcome {
  double rms = 0.0;
  double rms_error = 0.0;  // standard error from the blocks; 0 with one block
  double t2 = 0.0;         // zero up-crossing period, counted [s]
  double kurtosis = 0.0;   // 3 for a Gaussian
  double bandwidth = 0.0;  // sqrt(1 - (zero up-crossings / crests)^2): 0 narrow, 1 wide
  double largest = 0.0;    // |x|
};

struct Outcome {
  std::vector<Answer> answers;           // by question
  std::vector<ChannelOutcome> channels;  // by channel of the watch
};

/// Series of a block, by channel of the watch; may be looked at while it is there.
using Series = std::vector<std::vector<double>>;
using OnBlock = std::function<void(std::size_t block, const Series& series)>;

Outcome run(Simulation& simulation, const Watch& watch, std::span<const Question> questions,
            std::uint64_t seed, const OnBlock& on_block = {});

/// The amplitudes of one block, roll law included.
void make_block(Simulation& simulation, std::uint64_t seed, std::size_t block, BinAmplitudes& out);

}  // namespace quickstrip::seaway
