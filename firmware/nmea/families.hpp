// The sentences that we read, by family. Each takes what its fields give and the sensor calls valid, turned
// to the contract's signs; kTaken when something was. Formats as makers' manuals quote and IEC
// 61162-1 (the standards themselves are not public): Furuno SC-50, FR-1500 and DS-60, Koden MDC, Airmar,
// NovAtel, Trimble. Pure, no heap, below a microsecond each.
#pragma once

#include "firmware/nmea/fields.hpp"
#include "firmware/nmea/sentence.hpp"

namespace quickstrip::nmea {

/// Mode indicators (VTG, RMC; edition 2.3 on): autonomous, differential, precise, float and fixed RTK; and
/// those that are no measurement: estimated, manual, simulator, not valid.
inline constexpr std::string_view kMeasuredModes = "ADPFR";
inline constexpr std::string_view kOtherModes = "EMSN";

// heading_sentences.cpp
Fate read_hdt(const Cut& cut, Readings& out);
Fate read_ths(const Cut& cut, Readings& out);
Fate read_rot(const Cut& cut, Readings& out);

// speed_sentences.cpp
Fate read_vtg(const Cut& cut, Readings& out);
Fate read_vhw(const Cut& cut, Readings& out);
Fate read_vbw(const Cut& cut, Readings& out);

// position_sentences.cpp
Fate read_rmc(const Cut& cut, Readings& out);
Fate read_gga(const Cut& cut, Readings& out);
/// `transducer_depth_m`: below the water line.
Fate read_dpt(const Cut& cut, double transducer_depth_m, Readings& out);
Fate read_dbt(const Cut& cut, double transducer_depth_m, Readings& out);

/// What the last PSXN,20 of a source said.
struct PsxnQuality {
  bool is_height_bad = false;
  bool is_heading_bad = false;
  bool is_attitude_bad = false;
};

// attitude_sentences.cpp
Fate read_psxn(const Cut& cut, PsxnQuality& quality, Readings& out);
Fate read_pashr(const Cut& cut, Readings& out);
Fate read_xdr(const Cut& cut, Readings& out);

}  // namespace quickstrip::nmea
