// What the page posts: taken by the ranges of msgs/convert, refused in words beside the field.
#include "firmware/display/entry_form.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "msgs/convert/sea_message.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kNow = 1'567'600'800'000'000;  // 2019-09-04 12:40 UTC

std::string sea_json(const std::string& system) {
  return R"({"author":"A. Mate","systems":[)" + system + "]}";
}

constexpr const char* kWindSea =
    R"({"kind":"wind_sea","hs_m":3.2,"period_s":8,"period_kind":"tm02","dir_from_deg":240})";

std::string first_field(const FieldErrors& errors) {
  return errors.empty() ? "accepted" : errors.front().field;
}

TEST(SeaForm, BecomesAMessageThatTheAdvisorTakes) {
  SeaEntry entry;
  const auto errors = read_sea(
      sea_json(
          std::string(kWindSea) +
          R"(,{"kind":"swell","hs_m":2,"period_s":12.5,"period_kind":"tp","dir_from_deg":300,"spreading_deg":15})"),
      kNow, entry);
  ASSERT_TRUE(errors.empty()) << errors_json(errors);
  const sea_state_t& sea = entry.message;
  EXPECT_EQ(sea.utime, kNow);
  EXPECT_EQ(sea.source_kind, int{sea_state_t::SOURCE_MANUAL});
  EXPECT_EQ(sea.num_systems, 2);
  EXPECT_EQ(sea.hs_m[0], 3.2);
  EXPECT_EQ(sea.dir_from_deg[0], 240.0);
  EXPECT_EQ(sea.period_kind[0], int{sea_state_t::PERIOD_TM02});
  EXPECT_EQ(sea.system_kind[0], int{sea_state_t::SYSTEM_WIND_SEA});
  EXPECT_EQ(sea.period_kind[1], int{sea_state_t::PERIOD_TP});
  EXPECT_EQ(sea.spreading_deg[1], 15.0);
  EXPECT_EQ(sea.valid_until_utime, kNow + 7'200'000'000);  // two hours by default
  SeaState converted;
  std::uint32_t assumed = 0;
  EXPECT_TRUE(to_sea_state(sea, converted, assumed).ok());
}

TEST(SeaForm, ReadsBackInWords) {
  SeaEntry entry;
  ASSERT_TRUE(read_sea(sea_json(kWindSea), kNow, entry).empty());
  EXPECT_EQ(entry.words,
            "Wind sea 3.2 m, zero-crossing period 8 s, from 240° (WSW), spreading 25°. Seen at 12:40 UTC, "
            "holds until 14:40 UTC. Entered by A. Mate.");
}

TEST(SeaForm, NorthMayBeCalled360) {
  SeaEntry entry;
  const auto errors =
      read_sea(sea_json(R"({"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":360})"),
               kNow, entry);
  ASSERT_TRUE(errors.empty());
  EXPECT_EQ(entry.message.dir_from_deg[0], 0.0);
}

struct BadSea {
  const char* system;
  const char* field;
};

TEST(SeaForm, NamesTheFieldThatIsWrong) {
  const BadSea bad[] = {
      {R"({"kind":"swell","hs_m":0,"period_s":12,"period_kind":"tp","dir_from_deg":1})", "systems.0.hs_m"},
      {R"({"kind":"swell","hs_m":30.1,"period_s":12,"period_kind":"tp","dir_from_deg":1})", "systems.0.hs_m"},
      {R"({"kind":"swell","hs_m":-1,"period_s":12,"period_kind":"tp","dir_from_deg":1})", "systems.0.hs_m"},
      {R"({"kind":"swell","hs_m":"3,2 m","period_s":12,"period_kind":"tp","dir_from_deg":1})",
       "systems.0.hs_m"},
      {R"({"kind":"swell","hs_m":2,"period_s":0.9,"period_kind":"tp","dir_from_deg":1})",
       "systems.0.period_s"},
      {R"({"kind":"swell","hs_m":2,"period_s":41,"period_kind":"tp","dir_from_deg":1})",
       "systems.0.period_s"},
      {R"({"kind":"swell","hs_m":2,"period_s":12,"period_kind":"t9","dir_from_deg":1})",
       "systems.0.period_kind"},
      {R"({"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":361})",
       "systems.0.dir_from_deg"},
      {R"({"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":-5})",
       "systems.0.dir_from_deg"},
      {R"({"kind":"swell","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":1,"spreading_deg":81})",
       "systems.0.spreading_deg"},
      {R"({"kind":"tide","hs_m":2,"period_s":12,"period_kind":"tp","dir_from_deg":1})", "systems.0.kind"},
      {R"({"kind":"swell","hs_m":1e999,"period_s":12,"period_kind":"tp","dir_from_deg":1})", ""},
      {"17", "systems.0"},
  };
  for (const BadSea& one : bad) {
    SeaEntry entry;
    EXPECT_EQ(first_field(read_sea(sea_json(one.system), kNow, entry)), one.field) << one.system;
  }
}

TEST(SeaForm, TellsAllFaultsAtOnce) {
  SeaEntry entry;
  const auto errors =
      read_sea(R"({"systems":[{"kind":"swell","period_kind":"tp"}],"hours":99})", kNow, entry);
  EXPECT_EQ(errors.size(), 5U);  // author, hours, height, period, direction
}

TEST(SeaForm, RefusesThreeSystemsTogetherAboveThirtyMetres) {
  const std::string high = R"({"kind":"swell","hs_m":22,"period_s":12,"period_kind":"tp","dir_from_deg":1})";
  SeaEntry entry;
  EXPECT_EQ(first_field(read_sea(sea_json(high), kNow, entry)), "accepted");
  EXPECT_EQ(first_field(read_sea(sea_json(high + "," + high), kNow, entry)), "hs_m");
}

TEST(SeaForm, RefusesNonsenseWhole) {
  const std::string deep(5000, '[');
  for (const std::string& text :
       {std::string(), std::string("nonsense"), std::string("[]"), std::string("null"),
        std::string("{\"author\":\"\xFF\"}"), deep, std::string("{\"a\":") + deep}) {
    SeaEntry entry;
    EXPECT_FALSE(read_sea(text, kNow, entry).empty());
  }
}

TEST(SeaForm, AuthorIsOneShortLine) {
  const std::string systems = std::string(R"(,"systems":[)") + kWindSea + "]}";
  SeaEntry entry;
  EXPECT_EQ(first_field(read_sea(R"({"author":"two\nlines")" + systems, kNow, entry)), "author");
  EXPECT_EQ(first_field(read_sea(R"({"author":"  ")" + systems, kNow, entry)), "author");
  EXPECT_EQ(first_field(read_sea("{\"author\":\"" + std::string(32, 'a') + "\"" + systems, kNow, entry)),
            "author");
  EXPECT_EQ(first_field(read_sea("{\"author\":\"" + std::string(31, 'a') + "\"" + systems, kNow, entry)),
            "accepted");
}

TEST(LoadingForm, FieldsLeftEmptyAreNotSent) {
  LoadingEntry entry;
  ASSERT_TRUE(read_loading(R"({"author":"Chief","gm_m":1.2,"measured_roll_period_s":16.5,"kg_m":null})", kNow,
                           nullptr, entry)
                  .empty());
  EXPECT_EQ(entry.message.valid,
            std::int32_t{loading_t::VALID_GM} | std::int32_t{loading_t::VALID_ROLL_PERIOD});
  EXPECT_EQ(entry.message.gm_m, 1.2);
  EXPECT_EQ(entry.message.source_kind, int{loading_t::SOURCE_MANUAL});
  EXPECT_EQ(
      entry.words,
      "GM with free surfaces 1.20 m. Measured roll period 16.50 s. All else as in the ship's file. Holds "
      "until 12:40 UTC. Entered by Chief.");
}

TEST(LoadingForm, IsJudgedAgainstTheHullAsTheAdvisorDoes) {
  const auto hull = std::make_unique<Hull>(test::s175());
  LoadingEntry entry;
  const auto field = [&](const std::string& json) {
    return first_field(read_loading(R"({"author":"Chief",)" + json + "}", kNow, hull.get(), entry));
  };
  EXPECT_EQ(field(R"("draught_aft_m":9.0,"draught_fwd_m":8.5)"), "accepted");
  EXPECT_EQ(field(R"("draught_aft_m":9.0)"), "draught_fwd_m");                        // both or none
  EXPECT_EQ(field(R"("draught_aft_m":39.0,"draught_fwd_m":39.0)"), "draught_aft_m");  // above the deck
  EXPECT_EQ(field(R"("draught_aft_m":14.0,"draught_fwd_m":4.0)"), "draught_aft_m");   // trim above lpp / 20
  EXPECT_EQ(field(R"("kg_m":60)"), "kg_m");                                           // above 2 B
  EXPECT_EQ(field(R"("free_surface_correction_m":-0.1)"), "free_surface_correction_m");
  EXPECT_EQ(field(R"("gm_m":0)"), "gm_m");
  EXPECT_EQ(field(R"("measured_roll_period_s":81)"), "measured_roll_period_s");
  EXPECT_EQ(field(R"("hours":3)"), "");  // nothing but a time
}

TEST(SmallForms, AreReadOrRefused) {
  MarkEntry mark;
  EXPECT_TRUE(read_mark(R"({"author":"A","text":"heavy roll"})", mark).empty());
  EXPECT_EQ(mark.text, "heavy roll");
  EXPECT_EQ(first_field(read_mark(R"({"author":"A"})", mark)), "text");
  query_t query{};
  EXPECT_TRUE(read_query(R"({"heading_deg":355,"speed_kn":12})", query).empty());
  EXPECT_EQ(first_field(read_query(R"({"heading_deg":355,"speed_kn":120})", query)), "speed_kn");
  AcknowledgeEntry acknowledge;
  EXPECT_TRUE(
      read_acknowledge(R"({"alert_id":1,"instance":1,"revision":3,"what":"silence"})", acknowledge).empty());
  EXPECT_TRUE(acknowledge.silence_only);
  EXPECT_EQ(first_field(read_acknowledge(R"({"alert_id":1e12,"instance":1,"revision":3,"what":"silence"})",
                                         acknowledge)),
            "alert_id");
  EXPECT_EQ(first_field(read_acknowledge(R"({"alert_id":1,"instance":1,"revision":3})", acknowledge)),
            "what");
}

}  // namespace
}  // namespace quickstrip
