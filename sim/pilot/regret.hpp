// Advice regret: how much of the time above a limit does a ship save that follows the advice, as a share of
// what a pilot saves who knows the sea of every hour on every course?
//
// Three voyages through each storm: on the intended course and speed; by the advice; by the all-knowing pilot
// (truth.hpp). Truth is the advisor's own grid for the true sea, verdicts at once. The advice sees another
// sea: each half hour a measurement with normal errors, independent of each other, of height 10 %, of period
// 5 % and of direction 10 degrees (standard deviations, by wave system; of a spectrum as a whole) — ours,
// between a wave radar and a practised eye. It is stepped every ten minutes, so that its dwell works as at
// sea.
//
// Who follows: takes the first of the ranked changes when one is needed, at once and as it stands, at most
// four changes a watch of four hours, of which two are kept for when a limit is exceeded; back to the
// intended course and speed when the shown verdict there is good. A change takes no time and the sea no
// speed: the turn and involuntary speed loss are not sailed. So this judges the ranking and the steadiness
// against the advisor's own physics, not the physics. (Of S-175 in 20 storms: without keeping two 78 %, never
// a change inside the limits 77 %, as it is 80 %.)
//
// Memory: two advisors, 16 MB. Cost: some 20 ms of processor time for ten minutes of storm.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/advisor.hpp"
#include "core/base/result.hpp"
#include "sim/pilot/storm.hpp"
#include "sim/pilot/truth.hpp"

namespace quickstrip::pilot {

/// Of four changes a watch two are kept for when a limit is exceeded. Ours.
inline constexpr int kChangesInside = 2;

struct Noise {
  double height_part = 0.10;
  double period_part = 0.05;
  double direction = radians(10.0);
};

struct StormResult {
  std::string name;
  double hours = 0.0;
  Tally hold;
  Tally follow;
  Tally all_knowing;
};

/// The share of the time above a limit that is removed of what can be; 1 where nothing can.
double removed_share(const Tally& hold, const Tally& follow, const Tally& all_knowing);

class Sailing {
 public:
  /// `table` may be null; hull and table must outlive this.
  Status configure(const Hull& hull, const Criteria& criteria, const StripMethod& method,
                   const HullTable* table = nullptr);
  /// `changes_inside`: of the four a watch, those that may be spent while the shown verdict is inside the
  /// limits.
  Status sail(const Storm& storm, const Noise& noise, int changes_inside, std::uint64_t seed,
              StormResult& out);

 private:
  Status find_truth(const Storm& storm);
  Tally follow_advice(const Storm& storm, const Noise& noise, int changes_inside, std::uint64_t seed);

  std::unique_ptr<Advisor> truth_ = std::make_unique<Advisor>();
  std::unique_ptr<Advisor> advisor_ = std::make_unique<Advisor>();
  std::unique_ptr<DirectionalSpectrum> noisy_ = std::make_unique<DirectionalSpectrum>();
  std::vector<TrueGrid> grids_;
  CellIndex intended_;
  double time_ = 0.0;  // goes on from storm to storm, with a gap, so that nothing is remembered
};

}  // namespace quickstrip::pilot
