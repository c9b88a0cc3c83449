#include "core/advice/people_channels.hpp"

#include "core/response/interruptions.hpp"
#include "core/response/motion_sickness.hpp"

namespace quickstrip {
namespace {

bool append(const Criterion& criterion, const Channel& acceleration, Watch& watch) {
  if (criterion.quantity == Quantity::kMotionSickness) {
    return watch.channels.push_back(motion_sickness_channel(acceleration, watch.gravity));
  }
  bool fits = true;
  for (const bool to_starboard : {false, true}) {
    fits = watch.channels.push_back(
               interruption_channel(acceleration, criterion.stance, to_starboard, watch.gravity)) &&
           fits;
  }
  return fits;
}

}  // namespace

Status list_people_channels(const Criteria& criteria, Watch& watch) {
  std::size_t num_people = 0;
  for (const Criterion& criterion : criteria) {
    const bool is_asked = criterion.is_watched() && (criterion.quantity == Quantity::kMotionSickness ||
                                                     criterion.quantity == Quantity::kMotionInterruptions);
    if (!is_asked || find_channel(watch, criterion.quantity, criterion.place) < watch.channels.size()) {
      continue;
    }
    const std::size_t there = find_channel(watch, Quantity::kVerticalAcceleration, criterion.place);
    if (there >= watch.channels.size()) {
      return Error::kOutOfRange;
    }
    num_people += num_channels(criterion);
    if (num_people > kMaxPeopleChannels || !append(criterion, watch.channels[there], watch)) {
      return Error::kTooMany;
    }
  }
  return {};
}

}  // namespace quickstrip
