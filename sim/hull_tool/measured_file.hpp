// Measured figures from a CSV file that may hold several models: one column then says of which model a line
// is.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/csv_file.hpp"

namespace quickstrip::hull_tool {

/// What `read(file)` makes of each line of `model`, in the order of the file; of all lines where the header
/// has no column `model_column`. Throws InputError, which names the models of the file if `model` is none of
/// them.
template <typename Figure, typename Read>
std::vector<Figure> figures_of_model(CsvFile& file, const std::string& path, std::string_view model_column,
                                     const std::string& model, Read read) {
  const std::size_t column = file.column({model_column});
  std::vector<Figure> figures;
  std::vector<std::string> models;
  while (file.next_line()) {
    Figure figure = read(file);
    if (column != CsvFile::kNone) {
      const std::string of(file.field(column));
      if (std::find(models.begin(), models.end(), of) == models.end()) {
        models.push_back(of);
      }
      if (of != model) {
        continue;
      }
    }
    figures.push_back(std::move(figure));
  }
  if (figures.empty()) {
    throw InputError{models.empty() ? path + ": holds no figure"
                                    : fmt::format("{}: {} = {}: --model takes one of {}", path, model_column,
                                                  model, fmt::join(models, ", "))};
  }
  return figures;
}

/// "a/b/kcs.hull.toml" -> "kcs": what --model is, where it is silent.
inline std::string file_stem(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.substr(0, name.find('.'));
}

}  // namespace quickstrip::hull_tool
