#include "core/base/result.hpp"

namespace quickstrip {

const char* message(Error error) {
  switch (error) {
    case Error::kNone:
      return "no error";
    case Error::kNotFinite:
      return "a number is not finite";
    case Error::kOutOfRange:
      return "a number is outside its physical range";
    case Error::kTooMany:
      return "more items than there is room for";
    case Error::kTooFewStations:
      return "a hull needs at least three stations with immersed area";
    case Error::kStationsNotOrdered:
      return "stations must have increasing, distinct x";
    case Error::kContourNotOrdered:
      return "offsets must run from keel to deck";
    case Error::kNoImmersedVolume:
      return "the hull has no immersed volume at this draught";
    case Error::kDraughtAboveDeck:
      return "the waterline is above the highest offset of a station";
    case Error::kDraughtNotSupported:
      return "a hull of breadth, draught and area has one draught only";
    case Error::kUnstable:
      return "GM is not positive";
    case Error::kEmptySpectrum:
      return "the spectrum holds no energy";
    case Error::kSpeedOutOfGrid:
      return "the speed lies outside the grid";
    case Error::kNotConfigured:
      return "the advisor is not configured";
    case Error::kTableCorrupt:
      return "the section table's checksum is wrong";
    case Error::kHullTableForeign:
      return "this is not a hull table";
    case Error::kHullTableVersion:
      return "the hull table is of another version of the program; compile it again";
    case Error::kHullTableTruncated:
      return "the hull table is cut short or too long";
    case Error::kHullTableCorrupt:
      return "the hull table is damaged: its checksum or contents are wrong";
    case Error::kHullTableOtherHull:
      return "the hull table is of another hull";
    case Error::kHullTableNeeded:
      return "loads by boundary values need a compiled hull table";
    case Error::kSingular:
      return "the equations of motion are singular";
  }
  return "unknown error";
}

}  // namespace quickstrip
