#include "core/advice/next_criterion.hpp"

#include <array>
#include <cmath>
#include <span>

#include "core/response/moments.hpp"

namespace quickstrip {

Result<NextCriterion> next_criterion(const GridInputs& inputs, Heading heading, double speed,
                                     std::uint8_t governing) {
  std::array<ResponseMoments, kMaxChannels> all{};
  const auto moments = std::span(all).first(inputs.watch.channels.size());
  const Result<RollDampingInUse> damping =
      response_moments(inputs.transfer, inputs.watch, inputs.sea, heading, speed, moments,
                       &inputs.channels.is_watched, inputs.is_stabilised);
  if (!damping) {
    return damping.error();
  }
  NextCriterion next;
  bool next_is_caution = false;
  for (std::size_t i = 0; i < inputs.criteria.size(); ++i) {
    const std::size_t c = inputs.channels.of_criterion[i];
    if (c == kNoChannel || i == governing) {
      continue;
    }
    const Criterion& criterion = inputs.criteria[i];
    const Channel& channel = inputs.watch.channels[c];
    const double margin = height_margin(criterion, channel, speed, moments[c]);
    const bool is_caution =
        criterion_value(criterion, channel, speed, moments[c]) > criterion.caution_fraction * criterion.limit;
    if (!std::isfinite(margin)) {
      return Error::kNotFinite;
    }
    const bool goes_before =
        is_caution != next_is_caution ? is_caution : margin < static_cast<double>(next.margin);
    if (next.criterion == kNoCriterion || goes_before) {
      next = {static_cast<std::uint8_t>(i), static_cast<float>(margin)};
      next_is_caution = is_caution;
    }
  }
  return next;
}

}  // namespace quickstrip
