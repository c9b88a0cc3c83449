// The part of a step that asks how sure its verdicts are: members of the ensemble, each placed and swept.
#include <algorithm>

#include "core/advisor.hpp"

namespace quickstrip {

Status Advisor::sweep_member(const StepInputs& inputs, std::size_t member, CycleMemory& cycle) {
  const double gm = loaded_.hydrostatics.gm;
  const EnsembleMember drawn = draw_member(member, inputs.uncertainty, gm);
  const bool is_spectrum = inputs.spectrum != nullptr;
  if (is_spectrum) {
    shift_sea(drawn, *inputs.spectrum, shifted_.front().spectrum);
  } else {
    shift_sea(drawn, *inputs.sea_state, shifted_.front().state);
  }
  const Status placed = place_sea(is_spectrum ? nullptr : &shifted_.front().state,
                                  is_spectrum ? &shifted_.front().spectrum : nullptr, cycle.sea);
  if (!placed) {
    return placed;
  }
  GridInputs of_member = grid_inputs(cycle);
  of_member.roll_shift = drawn.roll;
  of_member.zones = nullptr;  // limits on motions are counted; the zones are those of the true sea
  return quickstrip::sweep_member(of_member, member, cycle.grid, cycle.output.ensemble.exceeded);
}

void Advisor::sweep_ensemble(const StepInputs& inputs, CycleMemory& cycle) {
  Ensemble& ensemble = cycle.output.ensemble;
  ensemble.uncertainty = inputs.uncertainty;
  const std::size_t wanted = std::min(inputs.ensemble_members, kEnsembleMembers);
  for (std::size_t n = 0; n < wanted; ++n) {
    const std::size_t member = next_member_;
    next_member_ = next_member_ + 1 < kEnsembleMembers ? next_member_ + 1 : 0;
    const auto bit = static_cast<std::uint16_t>(1U << member);
    ensemble.valid = static_cast<std::uint16_t>(ensemble.valid & ~bit);
    if (sweep_member(inputs, member, cycle)) {  // a sea that cannot be placed is no member
      ensemble.valid = static_cast<std::uint16_t>(ensemble.valid | bit);
      member_time_[member] = inputs.time;
    }
  }
  for (std::size_t member = 0; member < kEnsembleMembers; ++member) {
    const double age = inputs.time - member_time_[member];
    if (!(age >= 0.0 && age <= kMemberLife)) {
      ensemble.valid = static_cast<std::uint16_t>(ensemble.valid & ~(1U << member));
    }
  }
  if (wanted > 0) {  // the true sea again, for questions until the next step
    has_sea_ = place_sea(inputs.sea_state, inputs.spectrum, cycle.sea).ok();
  }
}

}  // namespace quickstrip
