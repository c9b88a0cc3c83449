#include "sim/hull_table/compile_hull_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "core/base/capacity.hpp"
#include "core/hull/geometry_digest.hpp"
#include "sim/hull_table/table_section.hpp"

namespace quickstrip {
namespace {

constexpr unsigned kMostThreads = 2;

// Every station at every level, levels fastest; nothing where it is dry.
using TableSections = std::vector<std::optional<TableSection>>;

class Work {
 public:
  Work(const Hull& hull, HullSections method, const std::vector<double>& levels)
      : hull_(hull),
        method_(method),
        levels_(levels),
        nodes_(table_nodes(hull)),
        sections_(hull.stations.size() * levels.size()) {}

  // Takes the sections that no other thread has, until none is left or one has failed.
  void run(const std::function<void(double)>& progress) {
    for (std::size_t i = next_++; i < sections_.size(); i = next_++) {
      try {
        solve(i);
      } catch (...) {
        const std::lock_guard lock(failing_);
        if (i <= failed_) {  // the first in order, whichever thread was quicker
          failed_ = i;
          failure_ = std::current_exception();
        }
        return;
      }
      ++done_;
      if (progress) {
        progress(static_cast<double>(done_) / static_cast<double>(sections_.size()));
      }
    }
  }

  TableSections finish() {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return std::move(sections_);
  }

 private:
  void solve(std::size_t i) {
    const std::size_t station = i / levels_.size();
    const double level = levels_[i % levels_.size()];
    const std::optional<ImmersedSection> cut = cut_station(hull_, station, level);
    if (!cut) {
      return;
    }
    try {
      sections_[i] = solve_section(*cut, method_, nodes_);
    } catch (const std::invalid_argument& reason) {
      throw std::invalid_argument(fmt::format("station x_m = {:g}, waterline {:g} m above base: {}",
                                              hull_.stations[station].x, level, reason.what()));
    }
  }

  const Hull& hull_;
  HullSections method_;
  const std::vector<double>& levels_;
  TableNodes nodes_;
  TableSections sections_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::mutex failing_;
  std::size_t failed_ = SIZE_MAX;
  std::exception_ptr failure_;
};

TableSections solve_all(const Hull& hull, HullSections method, const std::vector<double>& levels,
                        const std::function<void(double)>& progress) {
  Work work(hull, method, levels);
  const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads);
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < count; ++i) {
    others.emplace_back([&work] { work.run({}); });
  }
  work.run(progress);
  others.clear();
  return work.finish();
}

class Writer {
 public:
  explicit Writer(std::vector<std::uint32_t>& words) : words_(words) {}
  void add(double value) { words_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  template <typename Range>
  void add_all(const Range& values) {
    for (const double value : values) {
      add(value);
    }
  }
  void add_word(std::uint32_t word) { words_.push_back(word); }

 private:
  std::vector<std::uint32_t>& words_;
};

void put_two_words(std::vector<std::uint32_t>& words, std::size_t at, std::uint64_t value) {
  words[at] = static_cast<std::uint32_t>(value);
  words[at + 1] = static_cast<std::uint32_t>(value >> 32U);
}

void put_text(std::vector<std::uint32_t>& words, const std::string& text) {
  const std::size_t most = 4 * kHullTableTextWords - 1;
  for (std::size_t i = 0; i < std::min(text.size(), most); ++i) {
    words[kWordText + i / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]))
                                << (8 * (i % 4));
  }
}

void put_header(const Hull& hull, HullSections method, CompiledHullTable& out) {
  std::vector<std::uint32_t>& words = out.words;
  std::copy(kHullTableMagic.begin(), kHullTableMagic.end(), words.begin() + kWordMagic);
  words[kWordVersion] = kHullTableVersion;
  words[kWordCount] = static_cast<std::uint32_t>(words.size());
  put_two_words(words, kWordGeometry, geometry_digest(hull));
  words[kWordSections] = static_cast<std::uint32_t>(method);
  words[kWordStations] = static_cast<std::uint32_t>(hull.stations.size());
  words[kWordLevels] = static_cast<std::uint32_t>(out.levels.size());
  words[kWordFlagged] = static_cast<std::uint32_t>(out.num_flagged);
  put_text(words, out.provenance);
  put_two_words(words, kWordChecksum, hull_table_checksum(words));
}

void add_block(const std::optional<TableSection>& section, Writer& writer) {
  writer.add_word(section ? 1 : 0);
  const TableSection values = section.value_or(TableSection{});
  for (const OscillationValues& row : values.oscillation) {
    writer.add_all(row);
  }
  for (const auto& directions : values.wave) {
    for (const WaveValues& row : directions) {
      writer.add_all(row);
    }
  }
}

void count(const Hull& hull, const TableSections& sections, HullSections method, CompiledHullTable& out) {
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::optional<TableSection>& section = sections[i];
    if (!section) {
      continue;
    }
    ++out.num_sections;
    out.num_flagged += static_cast<std::size_t>(section->is_flagged);
    if (section->method != method) {
      ++out.num_other_method;
      const double x = hull.stations[i / out.levels.size()].x;
      if (out.other_method_x.empty() || out.other_method_x.back() != x) {
        out.other_method_x.push_back(x);
      }
    }
  }
}

std::string provenance(const Hull& hull, HullSections method, const CompiledHullTable& out) {
  return fmt::format("quickstrip-hull " QUICKSTRIP_VERSION
                     ": {}, {} sections, {} of {} sections flagged, {} by another method",
                     hull.name.view(), name_of(method), out.num_flagged, out.num_sections,
                     out.num_other_method);
}

void check_size(const Hull& hull, const std::vector<double>& levels) {
  const std::size_t bytes = 4 * hull_table_words(hull.stations.size(), levels.size());
  if (bytes > kMaxHullTableBytes) {
    const std::size_t one =
        4 * (hull_table_words(hull.stations.size(), 2) - hull_table_words(hull.stations.size(), 1));
    const std::size_t rest = 4 * hull_table_words(hull.stations.size(), 0);
    throw std::invalid_argument(fmt::format(
        "{} levels of {} stations make {} bytes: at most {} fit on board, {} levels", levels.size(),
        hull.stations.size(), bytes, kMaxHullTableBytes, (kMaxHullTableBytes - rest) / one));
  }
}

}  // namespace

CompiledHullTable compile_hull_table(const Hull& hull, HullSections sections,
                                     const CompiledLoadings& loadings,
                                     const std::function<void(double)>& progress) {
  CompiledHullTable out;
  out.levels = table_levels(hull, loadings);
  check_size(hull, out.levels);
  const TableSections solved = solve_all(hull, sections, out.levels, progress);
  count(hull, solved, sections, out);
  out.provenance = provenance(hull, sections, out);
  out.words.reserve(hull_table_words(hull.stations.size(), out.levels.size()));
  out.words.resize(kHullTableHeaderWords);
  Writer writer(out.words);
  for (const Station& station : hull.stations) {
    writer.add(station.x);
  }
  writer.add_all(out.levels);
  const TableNodes nodes = table_nodes(hull);
  writer.add_all(nodes.wave);
  writer.add_all(nodes.oscillation);
  for (const std::optional<TableSection>& section : solved) {
    add_block(section, writer);
  }
  put_header(hull, sections, out);
  return out;
}

}  // namespace quickstrip
