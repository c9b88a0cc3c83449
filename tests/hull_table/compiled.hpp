// Tables of the S-175 for these tests: of few stations, so that they are quick to compile.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/hull/hull.hpp"
#include "core/strip/hull_table.hpp"
#include "core/strip/loaded_hull.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::test {

/// Every `step`-th station of the S-175, her ends among them.
inline std::unique_ptr<Hull> thinned_s175(std::size_t step) {
  const auto whole = std::make_unique<Hull>(s175());
  auto hull = std::make_unique<Hull>(*whole);
  hull->stations.clear();
  for (std::size_t i = 0; i < whole->stations.size(); ++i) {
    if (i % step == 0 || i + 1 == whole->stations.size()) {
      EXPECT_TRUE(hull->stations.push_back(whole->stations[i]));
    }
  }
  return hull;
}

/// A table and the memory that it looks at.
struct Compiled {
  Compiled(const Hull& hull, HullSections sections, const CompiledLoadings& loadings)
      : table(compile_hull_table(hull, sections, loadings)), view(*HullTable::view(table.words)) {}
  CompiledHullTable table;
  HullTable view;
};

inline std::unique_ptr<LoadedHull> loaded(const Hull& hull, const Loading& loading, const HullTable* table,
                                          const StripMethod& method = {}) {
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, loading, method, *out, table);
  EXPECT_TRUE(status.ok()) << (status.ok() ? "" : message(status.error()));
  return out;
}

}  // namespace quickstrip::test
