// read_loading of entry_form.hpp.
#include <fmt/format.h>

#include "firmware/display/form.hpp"
#include "msgs/convert/ship_message.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxAuthor = sizeof(logbook_t::author) - 1;
constexpr std::int64_t kHour_us = 3'600'000'000;
constexpr double kMaxHours = 72.0;

/// Of any ship, where the hull is not known here.
struct LoadingRanges {
  Range draught_m = kDraught_m;
  Range kg_m{0.001, 120.0};
  Range free_surface_m{0.0, 30.0};
  Range gm_m{0.001, 120.0};
};

LoadingRanges ranges_of(const Hull* hull) {
  LoadingRanges ranges;
  if (hull != nullptr) {
    ranges = {draught_range_m(*hull), kg_range_m(*hull), free_surface_range_m(*hull), gm_range_m(*hull)};
    const double deck = highest_deck(*hull);
    ranges.draught_m.to = deck > 0.0 ? std::fmin(deck, hull->breadth) : hull->breadth;
  }
  return ranges;
}

/// One field of the message: its value, its bit, its words.
struct Reader {
  Form& form;
  LoadingEntry& entry;

  bool read(const char* name, Range range, const char* unit, std::int32_t bit, double& out,
            const char* words) {
    const auto value = form.optional_number(name, range, unit);
    if (!value) {
      return false;
    }
    out = *value;
    entry.message.valid |= bit;
    entry.words += fmt::format("{} {:.2f} {}. ", words, *value, unit);
    entry.brief += fmt::format("{}{} {:.2f} {}", entry.brief.empty() ? "" : "; ", words, *value, unit);
    return true;
  }
};

void read_fields(Form& form, const LoadingRanges& ranges, LoadingEntry& entry) {
  using M = loading_t;
  M& m = entry.message;
  Reader reader{form, entry};
  const bool aft =
      reader.read("draught_aft_m", ranges.draught_m, "m", M::VALID_DRAUGHTS, m.draught_aft_m, "Draught aft");
  const bool fwd = reader.read("draught_fwd_m", ranges.draught_m, "m", M::VALID_DRAUGHTS, m.draught_fwd_m,
                               "Draught forward");
  if (aft != fwd) {
    form.fault(aft ? "draught_fwd_m" : "draught_aft_m", "both draughts, or none");
  }
  reader.read("kg_m", ranges.kg_m, "m", M::VALID_KG, m.kg_m, "KG");
  reader.read("free_surface_correction_m", ranges.free_surface_m, "m", M::VALID_FREE_SURFACE,
              m.free_surface_correction_m, "Free-surface correction");
  reader.read("gm_m", ranges.gm_m, "m", M::VALID_GM, m.gm_m, "GM with free surfaces");
  reader.read("measured_roll_period_s", kRollPeriod_s, "s", M::VALID_ROLL_PERIOD, m.measured_roll_period_s,
              "Measured roll period");
}

void check_against(const Hull& hull, Form& form, const loading_t& loading) {
  Loading converted;
  const Conversion fit = to_loading(loading, hull, converted);
  if (fit.ok()) {
    return;
  }
  const bool is_trim_fault = fit.refusal == Refusal::kInconsistent;
  form.fault(fit.field, is_trim_fault
                            ? fmt::format("below the deck, and within {:.1f} m of the other draught",
                                          kMaxTrim * hull.lpp)
                            : std::string(message(fit.refusal)));
}

}  // namespace

FieldErrors read_loading(std::string_view json, std::int64_t now, const Hull* hull, LoadingEntry& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (!form.is_object()) {
    return errors;
  }
  LoadingEntry entry;
  entry.author = form.text("author", kMaxAuthor, "your name");
  entry.message.utime = now;
  entry.message.source_kind = loading_t::SOURCE_MANUAL;
  put_text("entered by hand", entry.message.condition);
  const auto hours = form.optional_number("hours", {0.25, kMaxHours}, "h");
  entry.valid_until_utime = now + kLoadingHolds_us;
  if (hours && *hours <= kMaxHours) {
    entry.valid_until_utime = now + static_cast<std::int64_t>(*hours * static_cast<double>(kHour_us));
  }
  read_fields(form, ranges_of(hull), entry);
  if (errors.empty() && entry.message.valid == 0) {
    form.fault("", "at least one of the fields");
  }
  if (errors.empty() && hull != nullptr) {
    check_against(*hull, form, entry.message);
  }
  if (!errors.empty()) {
    return errors;
  }
  entry.words += fmt::format("All else as in the ship's file. Holds until {}. Entered by {}.",
                             utc_clock(entry.valid_until_utime), entry.author);
  out = std::move(entry);
  return errors;
}

}  // namespace quickstrip
