#include "msgs/files/limits_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "core/advice/nordforsk.hpp"
#include "core/base/angles.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

const Hull& s175() {
  static Hull hull;
  static const bool is_read =
      read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml", hull).ok();
  EXPECT_TRUE(is_read);
  return hull;
}

std::string criterion(const std::string& lines) {
  return "schema = 1\nname = \"ours\"\n[[criterion]]\nname = \"c\"\n" + lines;
}

LimitsProfile profile_of(const std::string& lines) {
  LimitsProfile profile;
  EXPECT_EQ(parse_limits(criterion(lines), "l.toml", s175(), profile).line(), "");
  return profile;
}

void expect_refused(const std::string& lines, std::initializer_list<const char*> words) {
  LimitsProfile profile;
  const std::string line = parse_limits(criterion(lines), "l.toml", s175(), profile).line();
  EXPECT_EQ(line.rfind("l.toml: ", 0), 0u) << line;
  for (const char* word : words) {
    EXPECT_NE(line.find(word), std::string::npos) << "wanted '" << word << "' in: " << line;
  }
}

TEST(LimitsFile, EachKindOfLimitArrivesInSiUnits) {
  LimitsProfile p = profile_of("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 6.0\n");
  ASSERT_EQ(p.criteria.size(), 1u);
  EXPECT_EQ(p.name.view(), "ours");
  EXPECT_DOUBLE_EQ(p.criteria[0].limit, radians(6.0));
  EXPECT_EQ(p.criteria[0].caution_fraction, 0.75);
  p = profile_of(
      "quantity = \"vertical_acceleration\"\nrole = \"bridge\"\nstatistic = \"significant\"\n"
      "limit_g = 0.3\ncaution_fraction = 0.5\n");
  EXPECT_DOUBLE_EQ(p.criteria[0].limit, 0.3 * 9.80665);
  EXPECT_EQ(p.criteria[0].statistic, Statistic::kSignificant);
  EXPECT_EQ(p.criteria[0].place, 0);
  EXPECT_EQ(p.criteria[0].caution_fraction, 0.5);
  p = profile_of("quantity = \"slamming\"\nstatistic = \"per_hour\"\nlimit_per_hour = 20\n");
  EXPECT_EQ(p.criteria[0].limit, 20.0);
  EXPECT_EQ(p.criteria[0].statistic, Statistic::kPerHour);
  p = profile_of(
      "quantity = \"deck_wetness\"\nplace = \"bow\"\nstatistic = \"probability\"\n"
      "limit_probability = 0.05\n");
  EXPECT_EQ(p.criteria[0].limit, 0.05);
  p = profile_of("quantity = \"propeller_emergence\"\nstatistic = \"per_hour\"\nlimit_per_hour = 90\n");
  EXPECT_EQ(p.criteria[0].quantity, Quantity::kPropellerEmergence);
  EXPECT_EQ(p.criteria[0].limit, 90.0);
  EXPECT_EQ(p.criteria[0].place, 0);
  EXPECT_TRUE(check_criteria(p.criteria, s175()).ok());
  Hull without = s175();
  without.propeller.reset();
  EXPECT_FALSE(check_criteria(p.criteria, without).ok());
  EXPECT_TRUE(check_criteria(p.criteria, s175()).ok());
}

TEST(LimitsFile, ARoleThatTheHullHasNotIsKeptAsNotWatched) {
  const LimitsProfile p = profile_of(
      "quantity = \"lateral_acceleration\"\nrole = \"passengers\"\nstatistic = \"rms\"\nlimit_g = 0.05\n");
  ASSERT_EQ(p.criteria.size(), 1u);
  EXPECT_EQ(p.criteria[0].place, kNowhere);
  EXPECT_FALSE(p.criteria[0].is_watched());
}

std::string shipped(const std::string& name) {
  return std::string(QUICKSTRIP_SOURCE_DIR) + "/firmware/profiles/" + name + ".limits.toml";
}

constexpr std::array kShipped{
    "nordforsk_merchant", "nordforsk_light_work", "nordforsk_heavy_work", "nordforsk_intellectual_work",
    "passengers_transit", "passengers_cruise",    "naval_transit",        "quickstrip_cargo"};

TEST(Profiles, NordforskForMerchantShipsIsTheOneThatIsBuiltIn) {
  for (const double lpp : {60.0, 100.0, 175.0, 250.0, 315.0, 400.0}) {
    for (const bool has_places : {true, false}) {
      Hull hull = s175();
      hull.lpp = lpp;
      if (!has_places) {
        hull.points.clear();
        hull.slamming.clear();
        hull.freeboard.clear();
      }
      LimitsProfile profile;
      ASSERT_EQ(read_limits_file(shipped("nordforsk_merchant"), hull, profile).line(), "");
      const auto built_in = nordforsk_merchant(hull);
      ASSERT_EQ(profile.criteria.size(), built_in->size());
      EXPECT_EQ(profile.name.view(), "NORDFORSK 1987, merchant ships");
      for (std::size_t i = 0; i < built_in->size(); ++i) {
        const Criterion& ours = profile.criteria[i];
        const Criterion& theirs = (*built_in)[i];
        EXPECT_EQ(ours.name.view(), theirs.name.view());
        EXPECT_EQ(ours.quantity, theirs.quantity);
        EXPECT_EQ(ours.place, theirs.place) << theirs.name.view();
        EXPECT_EQ(ours.statistic, theirs.statistic);
        EXPECT_EQ(ours.limit, theirs.limit) << theirs.name.view() << ", " << lpp << " m";  // bit for bit
        EXPECT_EQ(ours.caution_fraction, theirs.caution_fraction);
      }
    }
  }
}

TEST(Profiles, OfEveryKindFitEveryShipAndSayWhatTheyCannotWatch) {
  for (const char* profile_name : kShipped) {
    for (const char* ship : {"s175", "tanker", "trawler", "shortest", "wigley_i"}) {
      const auto hull = std::make_unique<Hull>();
      const std::string file = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/" + ship + ".hull.toml";
      ASSERT_TRUE(read_hull_file(file, *hull).ok());
      LimitsProfile profile;
      ASSERT_EQ(read_limits_file(shipped(profile_name), *hull, profile).line(), "");
      EXPECT_TRUE(check_criteria(profile.criteria, *hull).ok()) << profile_name << ", " << ship;
      const std::size_t num_criteria = profile.criteria.size();
      hull->points.clear();
      hull->slamming.clear();
      hull->freeboard.clear();
      hull->propeller.reset();
      ASSERT_EQ(read_limits_file(shipped(profile_name), *hull, profile).line(), "");
      EXPECT_LE(profile.criteria.size(), num_criteria);
      for (const Criterion& criterion : profile.criteria) {
        EXPECT_EQ(criterion.is_watched(), criterion.quantity <= Quantity::kYaw) << criterion.name.view();
      }
    }
  }
}

TEST(Profiles, OfTheNavyCountByTheHourAndHaveNoPassengers) {
  LimitsProfile p;
  ASSERT_EQ(read_limits_file(shipped("naval_transit"), s175(), p).line(), "");
  const auto find = [&p](Quantity quantity) {
    for (const Criterion& criterion : p.criteria) {
      if (criterion.quantity == quantity) {
        return criterion;
      }
    }
    ADD_FAILURE();
    return Criterion{};
  };
  EXPECT_EQ(find(Quantity::kMotionSickness).limit, 0.2);  // STANAG 4154: 20 % in 4 h
  EXPECT_EQ(find(Quantity::kMotionSickness).exposure, 4.0 * 3600.0);
  EXPECT_EQ(find(Quantity::kMotionInterruptions).limit, 1.0);
  for (const auto& [quantity, per_hour] :
       {std::pair{Quantity::kDeckWetness, 30.0}, std::pair{Quantity::kSlamming, 20.0},
        std::pair{Quantity::kPropellerEmergence, 90.0}}) {
    EXPECT_EQ(find(quantity).statistic, Statistic::kPerHour);
    EXPECT_EQ(find(quantity).limit, per_hour);
  }
}

TEST(LimitsFile, LimitsByLengthAreLinearBetweenAndConstantBeyond) {
  Hull hull = s175();
  const std::string lines = criterion(
      "quantity = \"pitch\"\nstatistic = \"rms\"\nlimit_deg_by_length = [[100, 3.0], [200, 2.0], "
      "[300, 1.5]]\n");
  for (const auto& [lpp, expected] : {std::pair{50.0, 3.0}, std::pair{100.0, 3.0}, std::pair{125.0, 2.75},
                                      std::pair{200.0, 2.0}, std::pair{250.0, 1.75}, std::pair{400.0, 1.5}}) {
    hull.lpp = lpp;
    LimitsProfile profile;
    ASSERT_EQ(parse_limits(lines, "l.toml", hull, profile).line(), "");
    EXPECT_NEAR(profile.criteria[0].limit, radians(expected), 1e-15) << lpp;
  }
}

TEST(LimitsFile, PeopleHaveAPlaceOfTheirOwnATimeAndAStance) {
  Hull hull = s175();
  ASSERT_TRUE(hull.points.push_back({Name("saloon"), PointRole::kPassengers, 60.0, 0.0, 20.0}));
  ASSERT_TRUE(hull.points.push_back({Name("hatch"), PointRole::kDeck, 90.0, 5.0, 16.0}));
  const auto read = [&hull](const std::string& lines) {
    LimitsProfile profile;
    EXPECT_EQ(parse_limits(criterion(lines), "l.toml", hull, profile).line(), "");
    return profile.criteria[0];
  };
  const std::string sick =
      "quantity = \"motion_sickness\"\nstatistic = \"share_of_people\"\nlimit_percent = 10\n";
  EXPECT_EQ(hull.points[read(sick).place].name.view(), "saloon");
  EXPECT_EQ(read(sick).limit, 0.1);
  EXPECT_EQ(read(sick).exposure, 0.0);
  EXPECT_EQ(read(sick + "exposure_min = 240\nrole = \"bridge\"\n").exposure, 14'400.0);
  const std::string stand =
      "quantity = \"motion_interruptions\"\nstatistic = \"per_minute\"\nlimit_per_minute = 0.5\n";
  EXPECT_EQ(hull.points[read(stand).place].name.view(), "hatch");
  EXPECT_EQ(read(stand).stance, Stance{});
  EXPECT_EQ(read(stand + "stance_height_m = 1.0\nstance_half_width_ratio = 0.17\n").stance,
            (Stance{1.0, 0.17}));
}

TEST(LimitsFile, WhatIsWrongIsNamed) {
  expect_refused("quantity = \"rol\"\nstatistic = \"rms\"\nlimit_deg = 6.0\n",
                 {"criterion[1].quantity = \"rol\"", "\"roll\""});
  expect_refused("quantity = \"roll\"\nstatistic = \"probability\"\nlimit_deg = 6.0\n",
                 {"criterion[1].statistic = \"probability\"", "\"rms\", \"significant\""});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_g = 6.0\n", {"limit_g = 6.0", "limit_deg"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\n", {"limit_deg", "missing"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 0.0\n", {"limit_deg = 0.0"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 6.0\nrole = \"bridge\"\n",
                 {"role = \"bridge\"", "no place is wanted"});
  expect_refused(
      "quantity = \"vertical_acceleration\"\nplace = \"crane\"\nstatistic = \"rms\"\nlimit_g = 0.1\n",
      {"place = \"crane\"", "\"bridge\""});
  expect_refused(
      "quantity = \"vertical_acceleration\"\nrole = \"bridge\"\nstatistic = \"rms\"\nlimit_g = 0.1\n"
      "limit_m_s2 = 1.0\n",
      {"limit_m_s2", "only one"});
  expect_refused("quantity = \"slamming\"\nstatistic = \"rms\"\nlimit_m = 1.0\n",
                 {"statistic = \"rms\"", "\"per_hour\""});
  expect_refused("quantity = \"slamming\"\nstatistic = \"probability\"\nlimit_probability = 3\n",
                 {"limit_probability = 3", "0.999"});
  LimitsProfile profile;
  EXPECT_NE(
      parse_limits("schema = 1\nname = \"none\"\n", "l.toml", s175(), profile).line().find("none given"),
      std::string::npos);
}

}  // namespace
}  // namespace quickstrip
