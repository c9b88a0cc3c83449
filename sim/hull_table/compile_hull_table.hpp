// Compiles the table of a hull's own sections (core/strip/hull_table.hpp) that the advisor takes on board:
// every station at every level, by the parent's methods.
//
// The same hull, levels and method give the same words, on any number of threads. Cost: 72 flows a section;
// the S-175 at 5 draughts, 117 sections, on one core: Lewis forms 4 s, close fit 6 s, Frank's method 7 s.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/strip/hull_table.hpp"
#include "sim/hull_table/levels.hpp"

namespace quickstrip {

struct CompiledHullTable {
  std::vector<std::uint32_t> words;
  std::string provenance;
  std::vector<double> levels;
  std::vector<double> other_method_x;  // of stations that have such sections [m]
  std::size_t num_sections = 0;        // in the water
  std::size_t num_flagged = 0;         // whose own check of accuracy failed at a node
  std::size_t num_other_method = 0;    // by another method than asked for, which did not fit
};

/// `progress`: called from one thread with the share done, 0 ... 1. Throws std::invalid_argument in one
/// sentence: those of table_levels, cut_station and solve_section; a table larger than kMaxHullTableBytes.
CompiledHullTable compile_hull_table(const Hull& hull, HullSections sections,
                                     const CompiledLoadings& loadings,
                                     const std::function<void(double)>& progress = {});

}  // namespace quickstrip
