// What a browser posts to the display: any bytes are read or refused with words for a field, and what is read
// the advisor's own converters take.
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "firmware/display/entry_form.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/ship_message.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr std::int64_t kNow = 1'567'600'800'000'000;  // 2019-09-04 12:40 UTC

const Hull& hull() {
  static const auto kHull = std::make_unique<Hull>(test::s175());
  return *kHull;
}

void check(const FieldErrors& errors) {
  for (const FieldError& error : errors) {
    require(!error.text.empty(), "a refusal says what is wrong");
  }
  require(nlohmann::json::accept(errors_json(errors)), "refusals are JSON");
}

void run_sea_form(std::string_view text) {
  SeaEntry entry;
  const FieldErrors errors = read_sea(text, kNow, entry);
  check(errors);
  if (errors.empty()) {
    SeaState sea;
    std::uint32_t assumed = 0;
    require(to_sea_state(entry.message, sea, assumed).ok(), "the advisor takes a sea that the display takes");
    require(!entry.words.empty() && entry.message.valid_until_utime > kNow, "it is read back and has an end");
  }
}

void run_loading_form(std::string_view text) {
  LoadingEntry entry;
  check(read_loading(text, kNow, nullptr, entry));
  LoadingEntry of_hull;
  const FieldErrors errors = read_loading(text, kNow, &hull(), of_hull);
  check(errors);
  Loading loading;
  require(!errors.empty() || to_loading(of_hull.message, hull(), loading).ok(),
          "the advisor takes a loading that the display takes");
}

}  // namespace

void run_entry(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  run_sea_form(text);
  run_loading_form(text);
  MarkEntry mark;
  check(read_mark(text, mark));
  query_t query{};
  check(read_query(text, query));
  AcknowledgeEntry acknowledge;
  check(read_acknowledge(text, acknowledge));
  WithdrawEntry withdraw;
  check(read_withdraw(text, withdraw));
  std::string ticket;
  check(read_confirm(text, ticket));
}

std::vector<Bytes> entry_seeds() {
  const std::string seeds[] = {
      R"({"author":"A","hours":2,"systems":[{"kind":"wind_sea","hs_m":3.2,"period_s":8,"period_kind":"tm02","dir_from_deg":240}]})",
      R"({"author":"A","systems":[{"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":360,"spreading_deg":15}]})",
      R"({"author":"A","draught_aft_m":9,"draught_fwd_m":8.5,"kg_m":9.5,"free_surface_correction_m":0.1,"gm_m":1,"measured_roll_period_s":18})",
      R"({"author":"A","text":"green water","kind":"sea","ticket":"0123"})",
      R"({"heading_deg":355,"speed_kn":12,"alert_id":1,"instance":1,"revision":3,"what":"silence"})"};
  std::vector<Bytes> list;
  for (const std::string& seed : seeds) {
    list.emplace_back(seed.begin(), seed.end());
  }
  return list;
}

}  // namespace quickstrip::fuzz
