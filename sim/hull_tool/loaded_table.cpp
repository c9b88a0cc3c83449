#include "sim/hull_tool/loaded_table.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "core/base/capacity.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_table_file.hpp"

namespace quickstrip::hull_tool {

std::unique_ptr<LoadedTable> load_table(const std::string& file, const Hull& hull) {
  if (file.empty()) {
    return nullptr;
  }
  auto out = std::make_unique<LoadedTable>();
  out->words.resize(kMaxHullTableBytes / sizeof(std::uint32_t));
  std::optional<HullTable> view;
  require(read_hull_table(file, hull, out->words, view));
  out->view = *view;
  return out;
}

void say_outside(const std::string& file, const HullTable& table, const Loading& loading) {
  fmt::print(stderr,
             "note: {}: waterlines from {:g} to {:g} m above base; at draughts {:g} m aft, {:g} m forward "
             "Lewis forms stand in\n",
             file, table.level(0), table.level(table.num_levels() - 1), loading.draught_aft,
             loading.draught_fwd);
}

}  // namespace quickstrip::hull_tool
