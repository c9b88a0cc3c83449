// What became of a line: taken, of no use to us, or refused and why. Counted, never worded one by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace quickstrip::nmea {

enum class Fate : std::uint8_t {
  kTaken = 0,      // it gave a reading at least
  kNotUsed,        // a good sentence of a kind that we do not read, or one that says nothing new to us
  kEmpty,          // no character
  kTooLong,        // of the line
  kNoSentence,     // no '$' where one should be
  kBadCharacter,   // outside 0x20 ... 0x7E
  kBadTag,         // a TAG block that is not closed or whose checksum is wrong
  kNoChecksum,     // and none may be missing
  kBadChecksum,    // wrong, or no two hexadecimal digits
  kBadAddress,     // no talker and formatter
  kTalker,         // not on the list
  kTooManyFields,  //
  kBadField,       // not a number, not the unit or letter that belongs there, or too few of them
  kOutOfRange,     // a number that no ship gives
  kNotValid,       // the sensor says so itself, or every field is empty
  kBadTime,        // a time before the line that is none
};
inline constexpr std::size_t kNumFates = 16;

inline constexpr std::array<std::string_view, kNumFates> kFateWords{
    "taken",     "not used",     "empty",     "too long",    "no sentence", "bad character",
    "bad TAG",   "no checksum",  "checksum",  "bad address", "talker",      "too many fields",
    "bad field", "out of range", "not valid", "bad time"};

/// Neither taken nor merely of no use.
constexpr bool is_refused(Fate fate) {
  return fate > Fate::kEmpty;
}

/// Lines by fate.
class FateCounts {
 public:
  void count(Fate fate) { ++counts_[static_cast<std::size_t>(fate)]; }
  [[nodiscard]] std::int64_t of(Fate fate) const { return counts_[static_cast<std::size_t>(fate)]; }
  [[nodiscard]] std::int64_t lines() const {
    std::int64_t sum = 0;
    for (const std::int64_t count : counts_) {
      sum += count;
    }
    return sum;
  }
  [[nodiscard]] std::int64_t refused() const {
    return lines() - of(Fate::kTaken) - of(Fate::kNotUsed) - of(Fate::kEmpty);
  }

 private:
  std::array<std::int64_t, kNumFates> counts_{};
};

}  // namespace quickstrip::nmea
