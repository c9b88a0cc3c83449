#include "msgs/convert/why_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"
#include "core/sea/spectrum.hpp"
#include "msgs/convert/advice_text.hpp"
#include "msgs/convert/hazard_text.hpp"
#include "msgs/convert/quality_text.hpp"

namespace quickstrip {
namespace {

constexpr double kManyTimes = 2.0;        // from here on "times as high" instead of per cent
constexpr double kRoundingPart = 1.0e-4;  // of per cent: floats

bool governs(const Cell& cell, const Criteria& criteria) {
  return cell.governing < criteria.size() && cell.values[cell.governing] >= 0.0F;
}

/// The zone that makes the verdict, the motions being better than that.
const HazardWords* deciding_zone(const Cell& cell) {
  const bool is_severe = (cell.hazards & kSevereZoneBits) != 0;
  const bool decides = cell.verdict == Verdict::kExceeded
                           ? is_severe && cell.margin >= 1.0F
                           : cell.verdict == Verdict::kCaution && (cell.hazards & kHazardMotions) == 0;
  return decides ? leading_zone(cell.hazards) : nullptr;
}

void add_unwatched(const Criteria& criteria, Sentence& out) {
  const auto* const missing =
      std::find_if(criteria.begin(), criteria.end(), [](const Criterion& c) { return !c.is_watched(); });
  if (missing != criteria.end()) {
    out.add("Not judged: the hull file gives no place for \"{}\"", missing->name.view());
  } else {
    out.add("Not judged");
  }
}

bool add_note(const char* words, Sentence& out) {
  Sentence note;
  note.add("{}", words);
  note.capitalise();
  Sentence part;
  part.add(". {}", note.view());
  return out.add_whole(part, kReasonBytes);
}

/// What comes before the governing criterion.
void add_verdict(const Cell& cell, const Criteria& criteria, bool has_governing, Sentence& out) {
  if (const HazardWords* const zone = deciding_zone(cell)) {
    out.add("{}", zone->bridge);
    out.add("{}", has_governing ? "; motions: " : "");
    return;
  }
  switch (cell.verdict) {
    case Verdict::kGood:
      return out.add("{}", has_governing ? "All limits kept; nearest: " : "All limits kept");
    case Verdict::kCaution:
      return out.add("{}", has_governing ? "Near a limit: " : "Near a limit");
    case Verdict::kExceeded:
      return out.add("{}", has_governing ? "" : "A limit is exceeded");
    case Verdict::kUnknown:
      add_unwatched(criteria, out);
      return out.add("{}", has_governing ? "; nearest: " : "");
  }
}

}  // namespace

void add_system(const WaveSystem& system, Sentence& out) {
  const Result<Spectrum> spectrum = spectrum_of(system);
  if (!spectrum || !(spectrum->peak_frequency > 0.0)) {
    return out.add("waves from {:03.0f}°", whole_degrees(system.from.radians));
  }
  const double tp = kTwoPi / spectrum->peak_frequency;
  const double steepness = kTwoPi * system.hs / (kStandardGravity * tp * tp);
  out.add("{} of {:.0f} s from {:03.0f}°", steepness < kFullyDevelopedSteepness ? "swell" : "wind sea", tp,
          whole_degrees(system.from.radians));
}

void add_margin(double margin, Sentence& out) {
  if (margin >= static_cast<double>(kMarginUnbounded)) {
    return;
  }
  if (margin >= kManyTimes) {
    return out.add("reached in waves {:.1f} times as high", std::floor(margin * 10.0 + kRoundingPart) / 10.0);
  }
  const double grow = std::floor(100.0 * (margin - 1.0) + kRoundingPart);
  const double fall = std::ceil(100.0 * (1.0 - margin) - kRoundingPart);
  if (grow >= 1.0) {
    out.add("reached if waves grow {:.0f} %", grow);
  } else if (fall >= 1.0) {
    out.add("waves would have to fall by {:.0f} %", fall);
  } else {
    out.add("at the limit");
  }
}

void add_why(const Cell& cell, const Criteria& criteria, WaveSystems systems, Sentence& out) {
  const bool has_governing = governs(cell, criteria);
  add_verdict(cell, criteria, has_governing, out);
  if (has_governing) {
    add_criterion(criteria[cell.governing], static_cast<double>(cell.values[cell.governing]), cell, out);
    if (cell.margin < kMarginUnbounded) {
      out.add("{}", cell.margin < 1.0F ? "; " : ", ");
      add_margin(static_cast<double>(cell.margin), out);
    }
    if (cell.governing_system < systems.size()) {
      out.add("; {}", systems.size() > 1 ? "mostly " : "");
      add_system(systems[cell.governing_system], out);
    }
  }
  out.capitalise();
}

void add_notes(const Cell& cell, Sentence& out) {
  const HazardWords* const zone = leading_zone(cell.hazards);
  if (zone != nullptr && zone != deciding_zone(cell) && !add_note(zone->bridge, out)) {
    add_note(zone->name, out);
  }
  for (const HazardWords& words : kHazardWords) {
    const bool is_zone = (words.bit & kZoneBits) != 0 || words.bit == kHazardMarginalSurfRiding;
    if ((cell.hazards & words.bit) != 0 && !is_zone && *words.bridge != '\0') {
      add_note(words.bridge, out);
    }
  }
  for (const QualityWords& words : kQualityWords) {
    if ((cell.quality & words.bit) != 0 && *words.bridge != '\0') {
      add_note(words.bridge, out);
    }
  }
}

void explain(const Cell& cell, const Criteria& criteria, WaveSystems systems, Sentence& out) {
  add_why(cell, criteria, systems, out);
  if (cell.next < criteria.size()) {
    Sentence part;
    part.add(". Next: {}", criteria[cell.next].name.view());
    if (next_margin(cell) < kMarginUnbounded) {
      part.add(", ");
      add_margin(static_cast<double>(next_margin(cell)), part);
    }
    out.add_whole(part, kReasonBytes);
  }
  add_notes(cell, out);
}

}  // namespace quickstrip
