// Lines of one source into readings: sentence cut, talker judged, family read. What is kept from line to line
// is the last PSXN,20 alone. Pure otherwise: no heap, no clock, no I/O.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/static_vector.hpp"
#include "firmware/nmea/families.hpp"

namespace quickstrip::nmea {

inline constexpr std::size_t kMaxTalkers = 32;

/// Talkers that may be believed, the first the most. A maker's own sentences have the talker "P".
class TalkerList {
 public:
  /// "GP,HE,...": 1 to 32 of two capitals or digits each, or "P". False, and nothing changed, for all else.
  [[nodiscard]] bool set(std::string_view list);
  /// Its place from 0; kMaxTalkers: not on the list.
  [[nodiscard]] std::size_t rank(std::string_view talker) const;

 private:
  struct Talker {
    char letters[2] = {};
  };
  StaticVector<Talker, kMaxTalkers> talkers_;
};

/// Gyros, then position and speed sensors, then what gathers them: integrated navigation, depth, makers' own.
inline constexpr std::string_view kDefaultTalkers =
    "HE,HN,HC,IN,II,VD,VM,VW,VR,GN,GP,GL,GA,GB,BD,TI,SD,YX,WI,P";

struct ReaderOptions {
  TalkerList talkers;
  bool allow_missing_checksum = false;
  double transducer_depth_m = 0.0;  // below the water line: DPT without an offset, DBT
  bool invert_roll = false;
  bool invert_pitch = false;
  bool invert_heave = false;
};

class Reader {
 public:
  explicit Reader(const ReaderOptions& options) : options_(options) {}

  /// `line` without its end. kTaken: `out` holds a reading at least, and `talker_rank` who sent it.
  Fate read(std::string_view line, Readings& out, std::size_t& talker_rank);

 private:
  Fate read_family(const Cut& cut, Readings& out);

  ReaderOptions options_;
  PsxnQuality psxn_quality_;
};

}  // namespace quickstrip::nmea
