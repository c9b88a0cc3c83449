// Why a course and speed is good or bad, in words: the criterion that governs, how far the waves are from its
// limit, the wave system that gives most of it, and the zones of the IMO guidance. For the present state, for
// every change, and for any cell that is asked for. No heap.
#pragma once

#include <span>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/sea/sea_state.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {

/// Of the sea that the advice rests on; may be empty: then systems are not named.
using WaveSystems = std::span<const WaveSystem>;

/// Steepness 2 pi Hs / (g Tp^2) of a fully developed sea after Pierson and Moskowitz: 4 sqrt(alpha / 5) / 2
/// pi with alpha = 0.0081. A system that is less steep cannot be raised by the wind that is blowing: swell.
inline constexpr double kFullyDevelopedSteepness = 0.0256;

/// "swell of 12 s from 240°", "wind sea of 8 s from 030°"; the period is Tp.
void add_system(const WaveSystem& system, Sentence& out);

/// "reached if waves grow 15 %", "waves would have to fall by 20 %", "at the limit"; "reached in waves 2.5
/// times as high"; nothing for a margin without bound. Growth is rounded down, fall up.
void add_margin(double margin, Sentence& out);

/// "Slamming at bow 4.1 % of encounters (38/h), limit 2.2 %; waves would have to fall by 20 %, mostly swell
/// of 12 s from 240°". Begins with a capital. A zone that decides by itself comes first.
void add_why(const Cell& cell, const Criteria& criteria, WaveSystems systems, Sentence& out);

/// What fits the field of reasons, beside its final NUL. What does not fit whole is left out, not cut.
inline constexpr std::size_t kReasonBytes = 255;

/// What else is to be known: ". Below steerage speed. Roll beyond 10° RMS: figures uncertain"; a zone by its
/// short name where there is no room for its sentence.
void add_notes(const Cell& cell, Sentence& out);

/// Why, the criterion that comes next, and the notes: of any cell, for a query.
void explain(const Cell& cell, const Criteria& criteria, WaveSystems systems, Sentence& out);

}  // namespace quickstrip
