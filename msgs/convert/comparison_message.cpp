#include "msgs/convert/comparison_message.hpp"

#include <string_view>

#include "core/base/constants.hpp"
#include "msgs/convert/limits_message.hpp"
#include "msgs/convert/rim_units.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

const char* words(Quantity quantity) {
  switch (quantity) {
    case Quantity::kRoll:
      return "roll";
    case Quantity::kPitch:
      return "pitch";
    case Quantity::kHeave:
      return "heave";
    case Quantity::kLongitudinalAcceleration:
      return "longitudinal acc.";
    case Quantity::kLateralAcceleration:
      return "lateral acc.";
    default:
      return "vertical acc.";
  }
}

void add_rms(double value, RimUnit unit, Sentence& out) {
  switch (unit) {
    case RimUnit::kDegree:
      return out.add("{:.1f}°", value);
    case RimUnit::kMetre:
      return out.add("{:.2f} m", value);
    default:
      return out.add("{:.3f} g", value / kStandardGravity);
  }
}

void add_window(double window_s, Sentence& out) {
  if (window_s >= 5400.0) {
    return out.add("the last {:.0f} hours", window_s / 3600.0);
  }
  if (window_s >= 3000.0) {
    return out.add("the last hour");
  }
  out.add("the last {:.0f} min", window_s / 60.0);
}

void put_line(const ComparedLine& line, const Hull& hull, double window_s, std::size_t i, comparison_t& out) {
  const RimUnit unit = rim_unit(line.quantity);
  const std::string_view place = line.is_place_known ? place_name(hull, line.quantity, line.place)
                                                     : std::string_view("not in hull file");
  out.quantity[i] = static_cast<std::int8_t>(line.quantity);
  put_text(place, out.place_name[i]);
  out.unit[i] = static_cast<std::int8_t>(unit);
  out.predicted_rms[i] = to_rim(line.predicted_rms, unit);
  out.measured_rms[i] = to_rim(line.measured_rms, unit);
  out.low_rms[i] = to_rim(line.low_rms, unit);
  out.high_rms[i] = to_rim(line.high_rms, unit);
  out.state[i] = static_cast<std::int8_t>(line.state);
  out.gap_since_s[i] = line.gap_since;
  Sentence text;
  text.add("{}", words(line.quantity));
  if (line.quantity > Quantity::kYaw) {
    text.add(" at {}", place);
  }
  if (line.state == GapState::kNotCompared) {
    text.add(": no prediction, measured ");
  } else {
    text.add(": predicted ");
    add_rms(out.predicted_rms[i], unit, text);
    text.add(", measured ");
  }
  add_rms(out.measured_rms[i], unit, text);
  text.add(" over ");
  add_window(window_s, text);
  put_text(text.view(), out.text[i]);
}

}  // namespace

void to_message(const Comparison& comparison, const Hull& hull, double window_s, comparison_t& out) {
  const std::int32_t seq = out.seq;
  out = comparison_t{};
  out.seq = seq;
  out.window_s = window_s;
  out.predicted_over_s = comparison.predicted_over;
  out.num_lines = static_cast<std::int16_t>(comparison.lines.size());
  bool is_compared = false;
  for (std::size_t i = 0; i < comparison.lines.size(); ++i) {
    put_line(comparison.lines[i], hull, window_s, i, out);
    is_compared = is_compared || comparison.lines[i].state != GapState::kNotCompared;
  }
  out.confidence = !is_compared                 ? comparison_t::CONFIDENCE_NOT_KNOWN
                   : comparison.has_lasting_gap ? comparison_t::CONFIDENCE_LOWERED
                                                : comparison_t::CONFIDENCE_NORMAL;
}

}  // namespace quickstrip
