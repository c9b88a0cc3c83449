#include "sim/replay/advice_difference.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "msgs/convert/text.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip {
namespace {

std::string first_of_inputs(const advice_t& a, const advice_t& b) {
  constexpr const char* kNames[] = {"sea state", "wave spectrum", "sea forecast",
                                    "own ship",  "loading",       "motion"};
  for (std::size_t i = 0; i < std::size(kNames); ++i) {
    if (a.input_use[i] != b.input_use[i] || a.input_seq[i] != b.input_seq[i] ||
        a.input_utime[i] != b.input_utime[i]) {
      return fmt::format("{} recorded use {} seq {}, replayed use {} seq {}", kNames[i], int{a.input_use[i]},
                         a.input_seq[i], int{b.input_use[i]}, b.input_seq[i]);
    }
  }
  return {};
}

std::string first_of_fields(const advice_t& a, const advice_t& b) {
  if (a.limits_digest != b.limits_digest) {
    return "other limits (--limits)";
  }
  if (a.hull_digest != b.hull_digest) {
    return "another hull file, loading or hull table (--hull, --table)";
  }
  if (std::string inputs = first_of_inputs(a, b); !inputs.empty()) {
    return inputs;
  }
  if (a.no_advice != b.no_advice) {
    return fmt::format("recorded \"{}\", replayed \"{}\"", get_text(a.no_advice_text),
                       get_text(b.no_advice_text));
  }
  const auto numbers = [](const char* name, double recorded, double replayed) {
    return recorded == replayed
               ? std::string()
               : fmt::format("{} recorded {:.9g}, replayed {:.9g}", name, recorded, replayed);
  };
  for (std::string text :
       {numbers("heading_deg", a.heading_deg, b.heading_deg), numbers("speed_kn", a.speed_kn, b.speed_kn),
        numbers("roll_rms_deg", a.roll_rms_deg, b.roll_rms_deg), numbers("verdict", a.verdict, b.verdict),
        numbers("governing", a.governing, b.governing), numbers("margin", a.margin, b.margin),
        numbers("quality", a.quality, b.quality), numbers("num_changes", a.num_changes, b.num_changes)}) {
    if (!text.empty()) {
      return text;
    }
  }
  return "in another field (hull file, method or program version?)";
}

}  // namespace

std::string difference(const advice_t& recorded, const advice_t& replayed) {
  return fmt::format("cycle {}, {}: {}", recorded.seq, format_utc(recorded.utime),
                     first_of_fields(recorded, replayed));
}

}  // namespace quickstrip
