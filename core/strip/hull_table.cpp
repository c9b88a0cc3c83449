#include "core/strip/hull_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/fnv1a64.hpp"
#include "core/base/interpolation.hpp"
#include "core/hull/geometry_digest.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip {
namespace {

constexpr float kGreatestNumber = 1e9F;  // a44 / rho of a section 100 m wide is 1e7 m4; keeps motions a float
constexpr double kLevelMatch = 1e-3;     // of a level: as the draught of stations of minimal form

bool is_increasing(std::span<const double> values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i] > values[i - 1])) {
      return false;
    }
  }
  return std::isfinite(values.back()) && std::isfinite(values.front());
}

// First of four neighbouring nodes about x, and their weights.
template <std::size_t N>
std::size_t cubic_stencil(const std::array<double, N>& nodes, double x, std::array<double, 4>& weight) {
  const auto above =
      static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
  const std::size_t first = std::clamp<std::size_t>(above, 2, N - 2) - 2;
  lagrange_weights(std::span<const double>(nodes).subspan(first, 4), x, weight);
  return first;
}

}  // namespace

const char* name_of(HullSections sections) {
  switch (sections) {
    case HullSections::kLewis:
      return "lewis";
    case HullSections::kCloseFit:
      return "close-fit";
    case HullSections::kFrank:
      return "frank";
  }
  return "unknown";
}

std::uint64_t hull_table_checksum(std::span<const std::uint32_t> words) {
  Fnv1a64 hash;
  for (const std::uint32_t word : words.subspan(kWordGeometry)) {
    hash.add(word);
  }
  return hash.value();
}

Result<HullTable> HullTable::view(std::span<const std::uint32_t> words) {
  if (words.size() < kHullTableHeaderWords || words[kWordMagic] != kHullTableMagic[0] ||
      words[kWordMagic + 1] != kHullTableMagic[1]) {
    return Error::kHullTableForeign;
  }
  if (words[kWordVersion] != kHullTableVersion) {
    return Error::kHullTableVersion;
  }
  if (words[kWordCount] != words.size()) {
    return Error::kHullTableTruncated;
  }
  HullTable table;
  table.words_ = words;
  if (const Status whole = table.check_contents(); !whole) {
    return whole.error();
  }
  table.set_nodes();
  if (const Status ordered = table.check_nodes(); !ordered) {
    return ordered.error();
  }
  return table;
}

Status HullTable::check_contents() const {
  if (hull_table_checksum(words_) != checksum()) {
    return Error::kHullTableCorrupt;
  }
  if (num_stations() > kMaxStations || num_levels() > kMaxHullTableLevels) {
    return Error::kTooMany;
  }
  if (num_levels() == 0 || words_[kWordSections] > static_cast<std::uint32_t>(HullSections::kFrank) ||
      words_.size() != hull_table_words(num_stations(), num_levels())) {
    return Error::kHullTableCorrupt;
  }
  // A checksum says nothing of what a writer got wrong.
  for (std::size_t i = kHullTableHeaderWords; i < words_.size(); ++i) {
    if (!(std::fabs(number(i)) <= kGreatestNumber)) {  // the word that says wet or dry is a denormal
      return Error::kHullTableCorrupt;
    }
  }
  return {};
}

Status HullTable::check_nodes() const {
  std::array<double, kMaxHullTableLevels> levels{};
  for (std::size_t i = 0; i < num_levels(); ++i) {
    levels[i] = level(i);
  }
  const bool in_order = is_increasing(std::span<const double>(levels).first(num_levels())) &&
                        is_increasing(log_k_) && is_increasing(wave_coordinate_);
  return in_order ? Status{} : Status{Error::kHullTableCorrupt};
}

void HullTable::set_nodes() {
  const std::size_t waves = kHullTableHeaderWords + num_stations() + num_levels();
  const std::size_t oscillations = waves + kHullTableWaves;
  for (std::size_t i = 0; i < kHullTableOscillations; ++i) {
    log_k_[i] = std::log(static_cast<double>(number(oscillations + i)));
  }
  // Nodes K1 (q^i - 1): even in ln(K + K1).
  const auto k1 = static_cast<double>(number(waves + 1));
  const auto k2 = static_cast<double>(number(waves + 2));
  wave_shift_ = k1 * k1 / (k2 - 2.0 * k1);
  for (std::size_t i = 0; i < kHullTableWaves; ++i) {
    wave_coordinate_[i] = std::log(static_cast<double>(number(waves + i)) + wave_shift_);
  }
}

std::uint64_t HullTable::two_words(std::size_t at) const {
  return words_[at] | (static_cast<std::uint64_t>(words_[at + 1]) << 32);
}

float HullTable::number(std::size_t word) const {
  return std::bit_cast<float>(words_[word]);
}

double HullTable::level(std::size_t i) const {
  return static_cast<double>(number(kHullTableHeaderWords + num_stations() + i));
}

std::size_t HullTable::block(std::size_t station, std::size_t level) const {
  return hull_table_words(num_stations(), num_levels()) -
         ((num_stations() - station) * num_levels() - level) * kHullTableBlockWords;
}

bool HullTable::is_wet(std::size_t station, std::size_t level) const {
  return words_[block(station, level)] != 0;
}

Status HullTable::check_hull(const Hull& hull) const {
  const bool same =
      num_stations() == hull.stations.size() && two_words(kWordGeometry) == geometry_digest(hull);
  return same ? Status{} : Status{Error::kHullTableOtherHull};
}

bool HullTable::covers(const Hull& hull, const Loading& loading) const {
  const double lowest = level(0);
  const double highest = level(num_levels() - 1);
  for (const Station& station : hull.stations) {
    const double z = waterline_height(hull, loading, station.x);
    if (!(z >= lowest * (1.0 - kLevelMatch) && z <= highest * (1.0 + kLevelMatch))) {
      return false;
    }
  }
  return true;
}

LevelStencil HullTable::level_stencil(std::size_t station, double waterline_z) const {
  LevelStencil out;
  out.station = static_cast<std::uint8_t>(station);
  const std::size_t count = std::min<std::size_t>(3, num_levels());
  out.count = static_cast<std::uint8_t>(count);
  if (count == 1) {
    out.weight[0] = 1.0F;
    return out;
  }
  // The levels on both sides, and the nearer one of those next to them.
  std::size_t above = 1;
  while (above + 1 < num_levels() && level(above) < waterline_z) {
    ++above;
  }
  std::size_t first = above - 1;
  if (count == 3) {
    const bool lower = first > 0 && (above + 1 == num_levels() ||
                                     waterline_z - level(first - 1) < level(above + 1) - waterline_z);
    first = lower ? first - 1 : first;
  }
  out.first = static_cast<std::uint8_t>(first);
  std::array<double, 3> nodes{};
  for (std::size_t i = 0; i < count; ++i) {
    nodes[i] = level(first + i);
  }
  std::array<double, 3> weight{};
  lagrange_weights(std::span<const double>(nodes).first(count), waterline_z, weight);
  for (std::size_t i = 0; i < count; ++i) {
    out.weight[i] = static_cast<float>(weight[i]);
  }
  return out;
}

OscillationValues HullTable::oscillation(const LevelStencil& at, double k) const {
  std::array<double, 4> weight{};
  const std::size_t first =
      cubic_stencil(log_k_, std::clamp(std::log(k), log_k_.front(), log_k_.back()), weight);
  OscillationValues out{};
  for (std::size_t l = 0; l < at.count; ++l) {
    if (!is_wet(at.station, at.first + l)) {
      continue;  // out of the water there: nothing moves
    }
    const std::size_t table = block(at.station, at.first + l) + 1 + first * kNumOscillationQuantities;
    for (std::size_t n = 0; n < weight.size(); ++n) {
      const double w = weight[n] * static_cast<double>(at.weight[l]);
      for (std::size_t q = 0; q < kNumOscillationQuantities; ++q) {
        out[q] += w * static_cast<double>(number(table + n * kNumOscillationQuantities + q));
      }
    }
  }
  return out;
}

// A ratio of loads has no meaning where the section is dry: then that of the wet level that counts most.
LevelStencil HullTable::without_dry_levels(const LevelStencil& at) const {
  LevelStencil out{.station = at.station, .first = at.first, .count = 1, .weight = {1.0F}};
  float most = 0.0F;
  bool all_wet = true;
  for (std::size_t l = 0; l < at.count; ++l) {
    if (!is_wet(at.station, at.first + l)) {
      all_wet = false;
    } else if (std::fabs(at.weight[l]) > most) {
      most = std::fabs(at.weight[l]);
      out.first = static_cast<std::uint8_t>(at.first + l);
    }
  }
  return all_wet ? at : out;
}

void HullTable::wave_factors(const LevelStencil& at, double sin_mu, WaveFactors& out) const {
  std::array<double, kHullTableDirections> direction{};
  lagrange_weights(kHullTableSinSquared, sin_mu * sin_mu, direction);
  const LevelStencil wet = without_dry_levels(at);
  for (std::size_t n = 0; n < kHullTableWaves; ++n) {
    std::array<double, kNumWaveQuantities> sum{};
    for (std::size_t l = 0; l < wet.count; ++l) {
      const auto of_level = static_cast<double>(wet.weight[l]);
      const std::size_t table = block(wet.station, wet.first + l) + 1 +
                                kHullTableOscillations * kNumOscillationQuantities +
                                n * kHullTableDirections * kNumWaveQuantities;
      for (std::size_t d = 0; d < kHullTableDirections; ++d) {
        const double w = of_level * direction[d];
        for (std::size_t q = 0; q < kNumWaveQuantities; ++q) {
          sum[q] += w * static_cast<double>(number(table + d * kNumWaveQuantities + q));
        }
      }
    }
    out.heave[n] = {sum[0], sum[1]};
    out.sway[n] = {sum[2], sum[3]};
    out.roll_lever[n] = {sum[4], sum[5]};
  }
}

HullTable::WaveStencil HullTable::wave_stencil(double k) const {
  WaveStencil out;
  const double at = std::min(std::log(k + wave_shift_), wave_coordinate_.back());
  out.first = cubic_stencil(wave_coordinate_, at, out.weight);
  return out;
}

}  // namespace quickstrip
