#include "sim/pilot/regret.hpp"

#include <algorithm>
#include <cmath>

#include "sim/seaway/gaussian.hpp"

namespace quickstrip::pilot {
namespace {

constexpr double kStep_s = 600.0;
constexpr int kStepsPerHalfHour = 3;
constexpr double kBetweenStorms_s = 1e5;  // above any dwell
constexpr std::uint64_t kNoiseStream = 7;

/// One measurement's errors.
EnsembleMember draw_errors(const Noise& noise, seaway::Gaussian& random) {
  EnsembleMember errors{};
  for (std::size_t i = 0; i < errors.height_factor.size(); ++i) {
    const auto a = random.pair();
    const auto b = random.pair();
    errors.height_factor[i] = std::max(0.2, 1.0 + noise.height_part * a.first);
    errors.period_factor[i] = std::max(0.2, 1.0 + noise.period_part * a.second);
    errors.turned[i] = noise.direction * b.first;
  }
  return errors;
}

void put_sea(const Storm& storm, std::size_t half_hour, StepInputs& inputs) {
  inputs.sea_state = storm.states.empty() ? nullptr : &storm.states[half_hour];
  inputs.spectrum = storm.states.empty() ? &storm.records[half_hour]->spectrum : nullptr;
}

/// The ship of who follows.
struct Follower {
  Heading heading;
  double speed = 0.0;
  bool is_as_intended = true;
  int changes_in_watch = 0;
  int num_changes = 0;
  int most_in_a_watch = 0;

  void change(Heading to, double at, bool intended) {
    heading = to;
    speed = at;
    is_as_intended = intended;
    ++changes_in_watch;
    ++num_changes;
    most_in_a_watch = std::max(most_in_a_watch, changes_in_watch);
  }

  void follow(const StepOutput& output, const Storm& storm, int changes_inside) {
    const Advice& advice = output.advice;
    const bool is_inside =
        advice.present.verdict == Verdict::kGood || advice.present.verdict == Verdict::kCaution;
    if (advice.no_advice != NoAdvice::kNone ||
        changes_in_watch >= (is_inside ? changes_inside : kChangesPerWatch)) {
      return;
    }
    if (!is_as_intended) {
      const CellIndex there = nearest_cell(output.grid, storm.intended, storm.intended_speed);
      if (output.grid.cells[there.speed][there.heading].verdict == Verdict::kGood) {
        change(storm.intended, storm.intended_speed, true);
        return;
      }
    }
    if (advice.change_needed && !advice.changes.empty()) {
      const Change& first = advice.changes[0];
      if (first.heading != heading.radians || first.speed != speed) {
        change({first.heading}, first.speed, false);
      }
    }
  }
};

}  // namespace

double removed_share(const Tally& hold, const Tally& follow, const Tally& all_knowing) {
  const double possible = hold.exceeded_h - all_knowing.exceeded_h;
  return possible > 0.0 ? (hold.exceeded_h - follow.exceeded_h) / possible : 1.0;
}

Status Sailing::configure(const Hull& hull, const Criteria& criteria, const StripMethod& method,
                          const HullTable* table) {
  if (Status status = truth_->configure(hull, criteria, method, {0.0, 0.0}, table); !status) {
    return status;
  }
  return advisor_->configure(hull, criteria, method, {}, table);
}

Status Sailing::find_truth(const Storm& storm) {
  grids_.clear();
  const OwnShip ship{storm.intended, storm.intended_speed};
  for (std::size_t i = 0; i < storm.num_half_hours(); ++i) {
    StepInputs inputs;
    put_sea(storm, i, inputs);
    inputs.own_ship = &ship;
    const StepOutput& output = truth_->step(inputs);
    if (output.advice.no_advice != NoAdvice::kNone) {
      return Error::kOutOfRange;
    }
    grids_.push_back(true_grid(output.grid));
    intended_ = nearest_cell(output.grid, storm.intended, storm.intended_speed);
  }
  return {};
}

Tally Sailing::follow_advice(const Storm& storm, const Noise& noise, int changes_inside, std::uint64_t seed) {
  Tally sum;
  seaway::Gaussian random(seed, kNoiseStream);
  Follower follower{storm.intended, storm.intended_speed};
  time_ += kBetweenStorms_s;
  SeaState noisy_state;
  for (std::size_t i = 0; i < storm.num_half_hours(); ++i) {
    follower.changes_in_watch = i % kHalfHoursPerWatch == 0 ? 0 : follower.changes_in_watch;
    StepInputs inputs;
    put_sea(storm, i, inputs);
    const EnsembleMember errors = draw_errors(noise, random);
    if (inputs.sea_state != nullptr) {
      shift_sea(errors, *inputs.sea_state, noisy_state);
      inputs.sea_state = &noisy_state;
    } else {
      shift_sea(errors, *inputs.spectrum, *noisy_);
      inputs.spectrum = noisy_.get();
    }
    for (int step = 0; step < kStepsPerHalfHour; ++step) {
      time_ += kStep_s;
      const OwnShip ship{follower.heading, follower.speed};
      inputs.own_ship = &ship;
      inputs.time = time_;
      const StepOutput& output = advisor_->step(inputs);
      follower.follow(output, storm, changes_inside);
      const CellIndex cell = nearest_cell(output.grid, follower.heading, follower.speed);
      const double part_h = kStep_s / 3600.0;
      sum.exceeded_h += grids_[i].at(cell) == Hours::kExceeded ? part_h : 0.0;
      sum.not_judged_h += grids_[i].at(cell) == Hours::kNotJudged ? part_h : 0.0;
    }
  }
  sum.num_changes = follower.num_changes;
  sum.most_changes_in_a_watch = follower.most_in_a_watch;
  return sum;
}

Status Sailing::sail(const Storm& storm, const Noise& noise, int changes_inside, std::uint64_t seed,
                     StormResult& out) {
  if (Status status = find_truth(storm); !status) {
    return status;
  }
  out = {storm.name, static_cast<double>(storm.num_half_hours()) / 2.0, {}, {}, {}};
  out.hold = tally(grids_, std::vector<CellIndex>(grids_.size(), intended_), intended_);
  out.all_knowing = tally(grids_, all_knowing_pilot(grids_, intended_), intended_);
  out.follow = follow_advice(storm, noise, changes_inside, seed);
  return {};
}

}  // namespace quickstrip::pilot
