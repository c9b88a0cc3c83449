// --table: a compiled hull table in memory, and the view of it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/hull/hull.hpp"
#include "core/strip/hull_table.hpp"

namespace quickstrip::hull_tool {

struct LoadedTable {
  std::vector<std::uint32_t> words;
  HullTable view;  // of them
};

/// Null when `file` is empty. Throws InputError: one line names the file and why it is refused.
std::unique_ptr<LoadedTable> load_table(const std::string& file, const Hull& hull);

inline const HullTable* view_of(const std::unique_ptr<LoadedTable>& table) {
  return table ? &table->view : nullptr;
}

/// On standard error: which levels it has, and that Lewis forms stand in at this loading.
void say_outside(const std::string& file, const HullTable& table, const Loading& loading);

}  // namespace quickstrip::hull_tool
