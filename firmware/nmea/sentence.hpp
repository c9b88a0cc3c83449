// One line into a sentence: TAG blocks passed over, checksum proved, talker and formatter parted, fields cut.
//
// `$ttfff,field,...*hh`, tt the talker, fff the formatter, hh the exclusive or of all characters
// between '$' and '*'; `$Pmmm...` is a maker's own. A TAG block (NMEA 0183 version 4, IEC 61162-450) stands
// before it between backslashes with a checksum of its own: `\s:GP0001,c:1120959341*hh\`; what it says is not
// used. `!` opens an encapsulated sentence (AIS): not used.
//
// Pure: views into the caller's line, no heap, time linear in its length (<= kMaxLine).
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/static_vector.hpp"
#include "firmware/nmea/fate.hpp"

namespace quickstrip::nmea {

/// The standard's line has 82 characters and a TAG block 80; makers' own are longer, and a stamp may precede.
inline constexpr std::size_t kMaxLine = 512;
inline constexpr std::size_t kMaxFields = 48;  // XDR of four transducers has 16, the longest of ours 12

/// Views into the line.
struct Cut {
  std::string_view talker;     // two letters; "P" for a maker's own
  std::string_view formatter;  // three letters; the maker's whole address without the P: "ASHR", "SXN"
  StaticVector<std::string_view, kMaxFields> fields;

  /// Empty beyond the last.
  [[nodiscard]] std::string_view field(std::size_t i) const {
    return i < fields.size() ? fields[i] : std::string_view{};
  }
};

/// kTaken: `out` is whole. `line` without its end of line.
[[nodiscard]] Fate cut_sentence(std::string_view line, bool allow_missing_checksum, Cut& out);

/// Passes over an IEC 61162-450 datagram header ("UdPbC" and a NUL), if there is one.
std::string_view without_datagram_header(std::string_view datagram);

/// The exclusive or of all characters.
unsigned checksum(std::string_view characters);

}  // namespace quickstrip::nmea
