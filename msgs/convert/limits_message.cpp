#include "msgs/convert/limits_message.hpp"

#include <array>
#include <bit>

#include "core/base/check.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {

std::string_view place_name(const Hull& hull, Quantity quantity, std::uint8_t place) {
  switch (quantity) {
    case Quantity::kLongitudinalAcceleration:
    case Quantity::kLateralAcceleration:
    case Quantity::kVerticalAcceleration:
    case Quantity::kMotionSickness:
    case Quantity::kMotionInterruptions:
      return place < hull.points.size() ? hull.points[place].name.view() : std::string_view();
    case Quantity::kSlamming:
      return place < hull.slamming.size() ? hull.slamming[place].name.view() : std::string_view();
    case Quantity::kDeckWetness:
      return place < hull.freeboard.size() ? hull.freeboard[place].name.view() : std::string_view();
    case Quantity::kPropellerEmergence:
      return hull.propeller ? std::string_view("propeller") : std::string_view();
    default:
      return "G";
  }
}

namespace {

/// What the message has no field for: time of exposure and stance. Nothing for a profile without people.
std::int64_t digest_with_people(const Criteria& criteria, std::int64_t digest) {
  Fnv1a fnv;
  fnv.add(std::bit_cast<double>(digest));
  bool has_people = false;
  for (const Criterion& criterion : criteria) {
    if (criterion.quantity == Quantity::kMotionSickness) {
      fnv.add(criterion.exposure);
    } else if (criterion.quantity == Quantity::kMotionInterruptions) {
      fnv.add(criterion.stance.height);
      fnv.add(criterion.stance.half_width_ratio);
    } else {
      continue;
    }
    has_people = true;
  }
  return has_people ? fnv.as_int64() : digest;
}

}  // namespace

void to_message(const Criteria& criteria, const Hull& hull, std::string_view profile_name, limits_t& out) {
  const limits_t sent = out;
  out = limits_t{};
  put_text(profile_name, out.profile_name);
  out.num_criteria = static_cast<std::int16_t>(criteria.size());
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    const Criterion& criterion = criteria[i];
    const RimUnit unit = rim_unit(criterion.quantity, criterion.statistic);
    put_text(criterion.name.view(), out.name[i]);
    out.quantity[i] = static_cast<std::int8_t>(criterion.quantity);
    out.place[i] = criterion.is_watched() ? std::int16_t{criterion.place} : std::int16_t{-1};
    put_text(criterion.is_watched() ? place_name(hull, criterion.quantity, criterion.place) : "",
             out.place_name[i]);
    out.statistic[i] = static_cast<std::int8_t>(criterion.statistic);
    out.unit[i] = static_cast<std::int8_t>(unit);
    out.limit[i] = to_rim(criterion.limit, unit);
    out.caution_fraction[i] = criterion.caution_fraction;
    out.watched[i] = criterion.is_watched() ? 1 : 0;
  }
  std::array<std::uint8_t, 4096> scratch;  // the type takes 2,816 bytes (pinned in tests/msgs)
  QS_CHECK(seal(out, scratch));
  out.digest = digest_with_people(criteria, out.digest);
  out.utime = sent.utime;
  out.seq = sent.seq;
  out.source_id = sent.source_id;
}

}  // namespace quickstrip
