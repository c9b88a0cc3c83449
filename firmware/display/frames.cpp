#include "firmware/display/frames.hpp"

#include <cmath>

#include "firmware/display/json_parts.hpp"

namespace quickstrip {
namespace {

using nlohmann::json;

std::string dump(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

template <typename T>
const T* pointer(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

/// Of the cycle of the advice that is shown; nullptr while it has not come.
const outlook_t* outlook_of_advice(const Shown& shown) {
  return shown.outlook && shown.advice && shown.outlook->seq == shown.advice->seq ? &*shown.outlook : nullptr;
}

json entries_json(const EntriesInForce& entries) {
  json out = {{"sea", nullptr}, {"loading", nullptr}};
  if (entries.sea) {
    out["sea"] = {{"words", entries.sea->words},
                  {"author", entries.sea->author},
                  {"utime", entries.sea->message.utime},
                  {"valid_until_utime", entries.sea->message.valid_until_utime}};
  }
  if (entries.loading) {
    out["loading"] = {{"words", entries.loading->words},
                      {"author", entries.loading->author},
                      {"utime", entries.loading->message.utime},
                      {"valid_until_utime", entries.loading->valid_until_utime}};
  }
  return out;
}

template <typename T>
json table(const T (&values)[25][72], const grid_t& grid) {
  json list = json::array();
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      list.push_back(values[s][h]);
    }
  }
  return list;
}

double rounded(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

}  // namespace

std::string beat_frame(const Shown& shown, const FrameContext& context, Shown::Clock::time_point now) {
  json beat = {{"utime", context.utime},
               {"start_id", context.start_id},
               {"recorded", context.is_recorded},
               {"has_bus", context.has_bus},
               {"advice_age_ms", nullptr},
               {"cycle_s", shown.health ? json(shown.health->cycle_period_s) : json(1.0)},
               {"num_refused", shown.num_refused}};
  if (shown.advice) {
    beat["advice_age_ms"] =
        std::chrono::duration_cast<std::chrono::milliseconds>(now - shown.advice_came).count();
  }
  return dump(beat);
}

std::string state_frame(const Shown& shown, const EntriesInForce& entries, const FrameContext& context) {
  const advice_t* const advice = pointer(shown.advice);
  const outlook_t* const outlook = outlook_of_advice(shown);
  json state = {{"utime", context.utime},
                {"recorded", context.is_recorded},
                {"advice", advice != nullptr ? advice_json(*advice) : json(nullptr)},
                {"changes", advice != nullptr ? changes_json(*advice, outlook) : json::array()},
                {"outlook", outlook != nullptr ? outlook_json(*outlook) : json(nullptr)},
                {"criteria", shown.limits ? criteria_json(*shown.limits, advice, outlook) : json::array()},
                {"inputs", inputs_json(advice, pointer(shown.health))},
                {"sea", sea_json(shown.sea())},
                {"own_ship", shown.own_ship ? own_ship_json(*shown.own_ship) : json(nullptr)},
                {"alerts", alerts_json(shown)},
                {"comparison", shown.comparison ? comparison_json(*shown.comparison) : json(nullptr)},
                {"health", shown.health ? health_json(*shown.health) : json(nullptr)},
                {"entries", entries_json(entries)},
                {"notes", notes_json(shown)}};
  return dump(state);
}

std::string grid_frame(const Shown& shown) {
  if (!shown.grid || shown.grid->num_speeds == 0) {
    return dump({{"seq", shown.grid ? json(shown.grid->seq) : json(nullptr)}, {"num_speeds", 0}});
  }
  const grid_t& grid = *shown.grid;
  json speeds = json::array();
  for (int s = 0; s < grid.num_speeds; ++s) {
    speeds.push_back(static_cast<double>(grid.speed_kn[s]));
  }
  json out = {{"seq", grid.seq},
              {"utime", grid.utime},
              {"num_speeds", grid.num_speeds},
              {"num_headings", grid.num_headings},
              {"speed_kn", std::move(speeds)},
              {"verdict", table(grid.verdict, grid)},
              {"governing", table(grid.governing, grid)},
              {"margin", table(grid.margin, grid)},
              {"hazards", table(grid.hazards, grid)}};
  if (shown.outlook && shown.outlook->num_members > 0) {
    out["num_members"] = shown.outlook->num_members;
    out["exceeded"] = table(shown.outlook->exceeded, grid);
  }
  return dump(out);
}

std::string trends_frame(const Shown& shown) {
  json samples = json::array();
  for (const TrendSample& sample : shown.trends.samples()) {
    samples.push_back({sample.minute, rounded(sample.margin), rounded(sample.roll_rms_deg),
                       rounded(sample.hs_m), sample.verdict});
  }
  return dump({{"samples", std::move(samples)}});
}

std::string answer_frame(const Shown& shown) {
  return shown.answer ? dump(answer_json(*shown.answer, pointer(shown.limits))) : std::string("null");
}

}  // namespace quickstrip
