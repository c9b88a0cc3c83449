// The compiled table of one hull: two-dimensional flow about her own sections, solved ashore
// (sim/hull_table), at a few heights of the waterline. A view of memory that somebody else owns (a file read
// at the start, flash): nothing is copied, and it is checked once.
//
// What it holds, by station and height of the waterline above the base line at that station ("level"), rho =
// 1, lengths in m, frequency as K = omega^2/g:
//  - of the oscillating section, at kHullTableOscillations nodes of K: a33, a22, a24, a44 and the signed
//    amplitudes h3, h2, h4 of radiated waves, b_jj / (rho omega) = h_j^2, so that damping keeps its signs;
//  - of the restrained one in waves, at kHullTableWaves nodes of K (the first 0) and at mu = 0, 30, 60, 90
//    degrees: equivalent motions of the water in heave and sway, and the roll lever [m], by the
//    boundary-value problem at V = 0 (boundary_value.hpp).
// Trim needs no tables of its own: sections stay upright, so a station knows its level only.
//
// Between nodes of K: cubic Lagrange polynomials in ln K, and in ln(K + K1) for waves. Between levels:
// parabolas through three (or a line): within 0.5 % at 5 % of the draught between them (tests/hull_table).
// Words of 32 bits, little-endian, floats. Layout: header (kHullTableHeaderWords), x of the stations, levels,
// K of the waves, K of the oscillations, then one block a station and level, levels fastest.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

inline constexpr std::size_t kHullTableOscillations = 48;
inline constexpr std::size_t kHullTableWaves = 25;
inline constexpr std::size_t kHullTableDirections = 4;  // mu = 0, 30, 60, 90 degrees: sin^2 mu = 0 ... 1
inline constexpr std::array<double, kHullTableDirections> kHullTableSinSquared = {0.0, 0.25, 0.75, 1.0};

/// What the table's sections are.
enum class HullSections : std::uint32_t { kLewis, kCloseFit, kFrank };
/// "lewis", "close-fit", "frank".
const char* name_of(HullSections sections);

/// The quantities of an oscillating section, in the order of the table.
enum OscillationQuantity : std::size_t {
  kTableA33,
  kTableH3,
  kTableA22,
  kTableA24,
  kTableA44,
  kTableH2,
  kTableH4,
  kNumOscillationQuantities
};
using OscillationValues = std::array<double, kNumOscillationQuantities>;

/// Equivalent motions of a wave, as sim/parent/section_flow.hpp has them: re and im of heave, sway, lever.
inline constexpr std::size_t kNumWaveQuantities = 6;

/// Block of a station at a level: one word, 1 if it is in the water, then the two tables.
inline constexpr std::size_t kHullTableBlockWords =
    1 + kHullTableOscillations * kNumOscillationQuantities +
    kHullTableWaves * kHullTableDirections * kNumWaveQuantities;

inline constexpr std::size_t kMaxHullTableLevels = 12;
inline constexpr std::uint32_t kHullTableVersion = 1;
inline constexpr std::array<std::uint32_t, 2> kHullTableMagic = {0x48535351, 0x54424C54};  // "QSSHTLBT"
inline constexpr std::size_t kHullTableTextWords = 64;                                     // 256 bytes

/// Words of the header by name; two-word numbers are low word first.
enum HullTableWord : std::size_t {
  kWordMagic = 0,
  kWordVersion = 2,
  kWordCount = 3,     // of all words, the header's included
  kWordChecksum = 4,  // 2 words; over everything from kWordGeometry on
  kWordGeometry = 6,  // 2 words, geometry_digest()
  kWordSections = 8,  // HullSections
  kWordStations = 9,
  kWordLevels = 10,
  kWordFlagged = 11,  // sections whose own check of accuracy failed
  kWordText = 12,     // provenance, UTF-8, zero-padded
  kHullTableHeaderWords = kWordText + kHullTableTextWords,
};

/// Words of a table of this size.
constexpr std::size_t hull_table_words(std::size_t stations, std::size_t levels) {
  return kHullTableHeaderWords + stations + levels + kHullTableWaves + kHullTableOscillations +
         stations * levels * kHullTableBlockWords;
}

/// The checksum of words that begin with a header.
std::uint64_t hull_table_checksum(std::span<const std::uint32_t> words);

/// Levels and their weights.
struct LevelStencil {
  std::uint8_t station = 0;
  std::uint8_t first = 0;
  std::uint8_t count = 0;  // 1 ... 3
  std::array<float, 3> weight{};
};

class HullTable {
 public:
  /// Keeps the span: its memory must outlive the view. kHullTableForeign (no table, or of another machine),
  /// kHullTableVersion, kHullTableTruncated, kHullTableCorrupt (checksum, counts, nodes out of order),
  /// kTooMany.
  static Result<HullTable> view(std::span<const std::uint32_t> words);

  [[nodiscard]] std::uint64_t checksum() const { return two_words(kWordChecksum); }
  /// The checksum over the words as they are in memory now.
  [[nodiscard]] bool is_intact() const { return hull_table_checksum(words_) == checksum(); }
  [[nodiscard]] HullSections sections() const { return HullSections{words_[kWordSections]}; }
  [[nodiscard]] std::size_t num_stations() const { return words_[kWordStations]; }
  [[nodiscard]] std::size_t num_levels() const { return words_[kWordLevels]; }
  [[nodiscard]] std::size_t num_flagged() const { return words_[kWordFlagged]; }
  [[nodiscard]] double level(std::size_t i) const;  // m above base
  /// Zero-padded bytes of the provenance, by word.
  [[nodiscard]] std::span<const std::uint32_t> text() const {
    return words_.subspan(kWordText, kHullTableTextWords);
  }

  /// Ok, or kHullTableOtherHull.
  [[nodiscard]] Status check_hull(const Hull& hull) const;

  /// Whether every station's waterline lies within the levels, to 0.1 % of its height.
  [[nodiscard]] bool covers(const Hull& hull, const Loading& loading) const;

  /// For a station whose waterline covers() found inside. Levels at which it is out of the water count with
  /// zeros.
  [[nodiscard]] LevelStencil level_stencil(std::size_t station, double waterline_z) const;

  /// K > 0 [1/m]; outside the nodes the values at the last one (a33's logarithm is not continued).
  [[nodiscard]] OscillationValues oscillation(const LevelStencil& at, double k) const;

  struct WaveFactors {
    std::array<std::complex<double>, kHullTableWaves> heave;
    std::array<std::complex<double>, kHullTableWaves> sway;
    std::array<std::complex<double>, kHullTableWaves> roll_lever;
  };
  /// Of waves from one direction, at the nodes of K.
  void wave_factors(const LevelStencil& at, double sin_mu, WaveFactors& out) const;

  /// Cubic weights among the nodes of K of the waves.
  struct WaveStencil {
    std::size_t first = 0;
    std::array<double, 4> weight{};
  };
  [[nodiscard]] WaveStencil wave_stencil(double k) const;

 private:
  [[nodiscard]] std::uint64_t two_words(std::size_t at) const;
  [[nodiscard]] float number(std::size_t word) const;
  [[nodiscard]] std::size_t block(std::size_t station, std::size_t level) const;
  [[nodiscard]] bool is_wet(std::size_t station, std::size_t level) const;
  [[nodiscard]] LevelStencil without_dry_levels(const LevelStencil& at) const;
  Status check_contents() const;
  void set_nodes();
  Status check_nodes() const;

  std::span<const std::uint32_t> words_;
  std::array<double, kHullTableOscillations> log_k_{};
  std::array<double, kHullTableWaves> wave_coordinate_{};
  double wave_shift_ = 0.0;
};

}  // namespace quickstrip
