// Any words as a compiled hull table, as they are and with the header mended so that they reach the contents;
// what is accepted goes on to strip theory.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include "core/hull/geometry_digest.hpp"
#include "core/strip/hull_table.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/transfer_functions.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::fuzz {
namespace {

using Words = std::vector<std::uint32_t>;

// Three stations: a table of 14 kB.
const Hull& barge() {
  static const auto kBarge = std::make_unique<Hull>(test::box_barge(60.0, 12.0, 2.0, 5.0, 3));
  return *kBarge;
}

void put_two_words(Words& words, std::size_t at, std::uint64_t value) {
  words[at] = static_cast<std::uint32_t>(value);
  words[at + 1] = static_cast<std::uint32_t>(value >> 32U);
}

void mend(Words& words) {
  std::copy(kHullTableMagic.begin(), kHullTableMagic.end(), words.begin());
  words[kWordVersion] = kHullTableVersion;
  words[kWordCount] = static_cast<std::uint32_t>(words.size());
  put_two_words(words, kWordGeometry, geometry_digest(barge()));
  put_two_words(words, kWordChecksum, hull_table_checksum(words));
}

void look_up(const HullTable& table) {
  HullTable::WaveFactors factors;
  for (std::size_t station = 0; station < table.num_stations(); ++station) {
    for (const double z : {table.level(0), table.level(table.num_levels() - 1)}) {
      const LevelStencil at = table.level_stencil(station, z);
      for (const double k : {1e-9, 1e-2, 1.0, 1e6}) {
        for (const double value : table.oscillation(at, k)) {
          require(std::isfinite(value), "what a table holds is finite");
        }
      }
      table.wave_factors(at, 0.7, factors);
    }
  }
}

// Whatever the numbers: refused, or motions that are finite.
void move(const HullTable& table) {
  static const auto loaded = std::make_unique<LoadedHull>();
  static const auto transfer = std::make_unique<TransferFunctions>();
  static const auto work = std::make_unique<TransferWorkspace>();
  StripMethod method;
  method.loads = DiffractionLoads::kBoundaryValue;
  Loading loading = barge().loading;
  loading.draught_aft = table.level(0);
  loading.draught_fwd = table.level(0);
  if (!load(barge(), loading, method, *loaded, &table)) {
    return;
  }
  constexpr std::array kSpeeds = {0.0, 5.0};
  if (!solve_transfer_functions(*loaded, kSpeeds, *work, *transfer)) {
    return;
  }
  for (std::size_t f = 0; f < transfer->num_frequencies; ++f) {
    require(std::isfinite(transfer->row[0][9].re[2][f]), "motions are finite");
  }
}

void try_out(const Words& words) {
  const Result<HullTable> table = HullTable::view(words);
  if (!table) {
    require(message(table.error()) != nullptr, "a refusal has its words");
    return;
  }
  look_up(*table);
  if (table->check_hull(barge())) {
    move(*table);
  }
}

}  // namespace

void run_hull_table(std::span<const std::uint8_t> bytes) {
  Words words(bytes.size() / 4);
  if (!words.empty()) {
    std::memcpy(words.data(), bytes.data(), 4 * words.size());
  }
  try_out(words);
  if (words.size() >= kHullTableHeaderWords) {
    mend(words);
    try_out(words);
  }
}

std::vector<Bytes> hull_table_seeds() {
  std::vector<Bytes> seeds;
  for (const CompiledLoadings& loadings : {CompiledLoadings{{2.0}, {}}, CompiledLoadings{{1.5, 2.0}, {}}}) {
    const CompiledHullTable table = compile_hull_table(barge(), HullSections::kLewis, loadings);
    Bytes bytes(4 * table.words.size());
    std::memcpy(bytes.data(), table.words.data(), bytes.size());
    seeds.push_back(bytes);
  }
  return seeds;
}

}  // namespace quickstrip::fuzz
