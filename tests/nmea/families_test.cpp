// Each sentence on an example of its maker's manual or of the real record, and its signs.
#include <gtest/gtest.h>

#include <cmath>

#include "firmware/nmea/reader.hpp"
#include "tests/nmea/support.hpp"

namespace quickstrip::nmea {
namespace {

struct Read {
  Fate fate = Fate::kTaken;
  Readings readings;
  /// NaN: not given.
  [[nodiscard]] double of(Quantity quantity) const {
    for (const Reading& reading : readings) {
      if (reading.quantity == quantity) {
        return reading.value;
      }
    }
    return NAN;
  }
};

Read read(std::string_view body, const ReaderOptions& options = test::reader_options()) {
  Reader reader(options);
  Read result;
  std::size_t rank = 0;
  result.fate = reader.read(test::sealed(body), result.readings, rank);
  return result;
}

TEST(NmeaHeading, HdtAndThsGiveTrueHeading) {
  EXPECT_EQ(read("HEHDT,274.07,T").of(Quantity::kHeading), 274.07);
  EXPECT_EQ(read("HEHDT,360.0,T").of(Quantity::kHeading), 0.0);
  EXPECT_EQ(read("HEHDT,274.07,M").fate, Fate::kBadField);
  EXPECT_EQ(read("HEHDT,361,T").fate, Fate::kOutOfRange);
  EXPECT_EQ(read("HEHDT,-1,T").fate, Fate::kOutOfRange);
  EXPECT_EQ(read("HEHDT,,T").fate, Fate::kNotValid);
  EXPECT_EQ(read("HETHS,77.52,A").of(Quantity::kHeading), 77.52);
  for (const char* mode : {"E", "M", "S", "V"}) {
    EXPECT_EQ(read(std::string("HETHS,77.52,") + mode).fate, Fate::kNotValid) << mode;
  }
  EXPECT_EQ(read("HETHS,77.52,Q").fate, Fate::kBadField);
}

TEST(NmeaHeading, RateOfTurnIsPositiveToStarboard) {
  EXPECT_EQ(read("HEROT,-12.5,A").of(Quantity::kRateOfTurn), -12.5);  // "-": bow turns to port
  EXPECT_EQ(read("HEROT,12.5,V").fate, Fate::kNotValid);
}

TEST(NmeaSpeed, VtgIsOverGroundAndVhwThroughTheWater) {
  const Read vtg = read("INVTG,215.11,T,239.79,M,9.1,N,16.9,K,A");
  EXPECT_EQ(vtg.of(Quantity::kCourse), 215.11);
  EXPECT_EQ(vtg.of(Quantity::kSpeedOverGround), 9.1);
  EXPECT_TRUE(std::isnan(vtg.of(Quantity::kSpeedThroughWater)));
  EXPECT_EQ(read("GPVTG,,T,,M,0.00,N,0.00,K").of(Quantity::kSpeedOverGround), 0.0);  // before edition 2.3
  EXPECT_EQ(read("INVTG,215.11,T,239.79,M,9.1,N,16.9,K,N").fate, Fate::kNotValid);
  EXPECT_EQ(read("INVTG,215.11,T,239.79,M,9.1,N,16.9,K,S").fate, Fate::kNotValid);  // simulator
  const Read vhw = read("VWVHW,045.0,T,047.1,M,12.3,N,22.8,K");
  EXPECT_EQ(vhw.of(Quantity::kSpeedThroughWater), 12.3);
  EXPECT_EQ(vhw.of(Quantity::kHeading), 45.0);
  EXPECT_TRUE(std::isnan(read("VWVHW,,,047.1,M,12.3,N,,").of(Quantity::kHeading)));  // magnetic is not true
}

TEST(NmeaSpeed, VbwGivesEachOfItsSpeedsWhenItsOwnStatusIsGood) {
  const Read both = read("VDVBW,12.3,-0.4,A,3.0,4.0,A,,V,,V");
  EXPECT_EQ(both.of(Quantity::kSpeedThroughWater), 12.3);
  EXPECT_EQ(both.of(Quantity::kSpeedOverGround), 5.0);
  const Read astern = read("VDVBW,-2.5,0.0,A,,,V");
  EXPECT_EQ(astern.of(Quantity::kSpeedThroughWater), -2.5);
  EXPECT_EQ(astern.readings.size(), 1U);
  EXPECT_EQ(read("VDVBW,12.3,-0.4,V,12.0,0.0,V").fate, Fate::kNotValid);
  EXPECT_EQ(read("VDVBW,12.3,-0.4,X,12.0,0.0,A").fate, Fate::kBadField);
  EXPECT_EQ(read("VDVBW,99.9,0,A,,,V").fate, Fate::kOutOfRange);
}

TEST(NmeaPosition, RmcAndGgaGiveSignedDegrees) {
  const Read rmc = read("INRMC,000000.16,A,2200.110899,S,01756.359432,W,9.1,215.11,010814,24.7,W,A");
  EXPECT_NEAR(rmc.of(Quantity::kLatitude), -(22.0 + 0.110899 / 60.0), 1e-12);
  EXPECT_NEAR(rmc.of(Quantity::kLongitude), -(17.0 + 56.359432 / 60.0), 1e-12);
  EXPECT_EQ(rmc.of(Quantity::kSpeedOverGround), 9.1);
  EXPECT_EQ(rmc.of(Quantity::kCourse), 215.11);
  EXPECT_EQ(read("GPRMC,1,V,2200.1,S,01756.3,W,9.1,215.1,010814,,,N").fate, Fate::kNotValid);
  EXPECT_EQ(read("GPRMC,1,A,2260.1,S,01756.3,W,9.1,215.1,010814,,,A").fate, Fate::kBadField);
  EXPECT_EQ(read("GPRMC,1,A,9100.1,S,01756.3,W,9.1,215.1,010814,,,A").fate, Fate::kOutOfRange);
  const Read gga = read("GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,");
  EXPECT_NEAR(gga.of(Quantity::kLatitude), 48.1173, 1e-9);
  EXPECT_NEAR(gga.of(Quantity::kLongitude), 11.516666666, 1e-8);
  EXPECT_EQ(read("GPGGA,123519,4807.038,N,01131.000,E,0,08,0.9,545.4,M,46.9,M,,").fate, Fate::kNotValid);
}

TEST(NmeaDepth, IsFromTheSurface) {
  EXPECT_EQ(read("SDDPT,20.0,5.5").of(Quantity::kDepth), 25.5);   // from the water line to the transducer
  EXPECT_EQ(read("SDDPT,20.0,-1.0").of(Quantity::kDepth), 20.0);  // to the keel: says nothing of the surface
  ReaderOptions deep = test::reader_options();
  deep.transducer_depth_m = 8.0;
  EXPECT_EQ(read("SDDPT,20.0,-1.0", deep).of(Quantity::kDepth), 28.0);
  EXPECT_NEAR(read("SDDBT,65.6,f,20.0,M,10.9,F", deep).of(Quantity::kDepth), 28.0, 1e-12);
}

TEST(NmeaAttitude, SignsAreStarboardDownBowDownAndUp) {
  // The record's first: roll 0.35 port up = starboard down; pitch -1.74 bow up = 1.74 bow down; heave 0.58
  // down.
  const Read psxn = read("PSXN,23,0.35,-1.74,218.26,0.58");
  EXPECT_EQ(psxn.of(Quantity::kRoll), 0.35);
  EXPECT_EQ(psxn.of(Quantity::kPitch), 1.74);
  EXPECT_EQ(psxn.of(Quantity::kHeave), -0.58);
  EXPECT_EQ(psxn.of(Quantity::kHeading), 218.26);
  const Read pashr = read("PASHR,163029.000,158.09,T,-0.30,+0.31,+0.01,0.029,0.029,0.059,1,1");
  EXPECT_EQ(pashr.of(Quantity::kRoll), -0.30);
  EXPECT_EQ(pashr.of(Quantity::kPitch), -0.31);
  EXPECT_EQ(pashr.of(Quantity::kHeave), 0.01);
  EXPECT_EQ(pashr.of(Quantity::kHeading), 158.09);
  const Read xdr = read("YXXDR,A,5.2,D,PTCH,A,7.4,D,ROLL");
  EXPECT_EQ(xdr.of(Quantity::kRoll), 7.4);
  EXPECT_EQ(xdr.of(Quantity::kPitch), -5.2);
  EXPECT_EQ(read("IIXDR,D,1.25,M,HEAVE").of(Quantity::kHeave), 1.25);
  ReaderOptions turned = test::reader_options();
  turned.invert_pitch = true;
  EXPECT_EQ(read("YXXDR,A,5.2,D,PTCH,A,7.4,D,ROLL", turned).of(Quantity::kPitch), 5.2);
  EXPECT_EQ(read("YXXDR,A,5.2,D,PTCH,A,7.4,D,ROLL", turned).of(Quantity::kRoll), 7.4);
}

TEST(NmeaAttitude, OtherKindsOfPsxnPashrAndXdrAreNotUsed) {
  EXPECT_EQ(read("PSXN,22,0.03,-0.80").fate, Fate::kNotUsed);
  EXPECT_EQ(read("PSXN,24,0.1,0.1,0.1,0.1").fate, Fate::kNotUsed);
  EXPECT_EQ(read("PASHR,ATT,88536.0,345.96,0.03,-0.90,0.0024,0.0144,0").fate, Fate::kNotUsed);
  EXPECT_EQ(read("WIXDR,C,20.5,C,AIRT,P,1.012,B,STNP").fate, Fate::kNotUsed);
  EXPECT_EQ(read("YXXDR,A,95.0,D,ROLL").fate, Fate::kOutOfRange);
}

TEST(NmeaAttitude, WhatSeapathItselfCallsBadIsNotTakenUntilItIsGoodAgain) {
  Reader reader(test::reader_options());
  Readings readings;
  std::size_t rank = 0;
  const auto give = [&](std::string_view body) { return reader.read(test::sealed(body), readings, rank); };
  EXPECT_EQ(give("PSXN,20,1,0,0,2"), Fate::kNotUsed);
  EXPECT_EQ(give("PSXN,23,0.35,-1.74,218.26,0.58"), Fate::kTaken);
  EXPECT_EQ(readings.size(), 2U);  // heading and heave
  EXPECT_EQ(give("PSXN,20,2,2,2,2"), Fate::kNotUsed);
  EXPECT_EQ(give("PSXN,23,0.35,-1.74,218.26,0.58"), Fate::kNotValid);
  EXPECT_EQ(give("PSXN,20,0,0,0,0"), Fate::kNotUsed);
  EXPECT_EQ(give("PSXN,23,0.35,-1.74,218.26,0.58"), Fate::kTaken);
  EXPECT_EQ(readings.size(), 4U);
}

TEST(NmeaTalkers, OnlyThoseOfTheListAreBelieved) {
  EXPECT_EQ(read("GPHDT,10.0,T", test::reader_options("HE,GP")).fate, Fate::kTaken);
  EXPECT_EQ(read("GPHDT,10.0,T", test::reader_options("HE")).fate, Fate::kTalker);
  EXPECT_EQ(read("PSXN,23,0,0,0,0", test::reader_options("HE")).fate, Fate::kTalker);
  EXPECT_EQ(read("ECHDT,10.0,T").fate, Fate::kTalker);  // an ECDIS repeats what others measured
  TalkerList list;
  for (const char* bad : {"", "G", "GPS", "gp", "GP,,HE", "GP;HE", "PA"}) {
    EXPECT_FALSE(list.set(bad)) << bad;
  }
}

}  // namespace
}  // namespace quickstrip::nmea
