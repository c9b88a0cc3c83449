#include "tests/evidence/call_graph.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <regex>

namespace quickstrip::evidence {
namespace {

constexpr long kPerCall = 16;

/// What stands in quotes behind `key: `.
std::string quoted(const std::string& line, const std::string& key) {
  const std::string opening = key + ": \"";
  const std::size_t from = line.find(opening);
  if (from == std::string::npos) {
    return {};
  }
  const std::size_t begin = from + opening.size();
  return line.substr(begin, line.find('"', begin) - begin);
}

/// "TITLE\nFILE:LINE\nN bytes (static)"; the title alone where it is not defined.
void take_label(const std::string& label, Function& function) {
  static const std::regex kFrame(R"(\\n(\d+) bytes \(([a-z,]+)\))");
  std::smatch found;
  if (std::regex_search(label, found, kFrame)) {
    function.frame = std::max(function.frame, std::stol(found[1]));
    function.is_dynamic = function.is_dynamic || found[2] == "dynamic";
    function.title = label.substr(0, label.find("\\n"));
  } else if (function.title.empty()) {
    function.title = label.substr(0, label.find("\\n"));
  }
}

}  // namespace

void CallGraph::read(std::istream& file) {
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with("node: ")) {
      take_label(quoted(line, "label"), functions_[quoted(line, "title")]);
    } else if (line.starts_with("edge: ")) {
      const std::string target = quoted(line, "targetname");
      functions_[quoted(line, "sourcename")].calls.insert(target);
      functions_[target];
    }
  }
}

std::size_t CallGraph::read_all(const std::filesystem::path& folder) {
  std::size_t num_files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".ci") {
      std::ifstream file(entry.path());
      read(file);
      ++num_files;
    }
  }
  return num_files;
}

std::vector<std::string> CallGraph::find(const std::string& name) const {
  std::vector<std::string> found;
  for (const auto& [symbol, function] : functions_) {
    const std::size_t at = function.title.find(name + "(");
    const bool is_whole_name = at != std::string::npos &&
                               (at == 0 || function.title[at - 1] == ' ' || function.title[at - 1] == '&');
    if (is_whole_name && function.frame >= 0) {
      found.push_back(symbol);
    }
  }
  return found;
}

/// Depth first, each function once.
struct CallGraph::Walk {
  const CallGraph& graph;
  std::set<std::string> done{};
  std::vector<std::string> path{};
  std::vector<std::string> cycle{};

  void visit(const std::string& symbol) {
    if (done.contains(symbol) || !cycle.empty()) {
      return;
    }
    if (const auto at = std::find(path.begin(), path.end(), symbol); at != path.end()) {
      cycle.assign(at, path.end());
      return;
    }
    path.push_back(symbol);
    for (const std::string& called : graph.functions_.at(symbol).calls) {
      visit(called);
    }
    path.pop_back();
    done.insert(symbol);
  }
};

std::vector<std::string> CallGraph::recursion_below(const std::string& entry) const {
  Walk walk{*this};
  walk.visit(entry);
  return walk.cycle;
}

std::set<std::string> CallGraph::below(const std::string& entry) const {
  Walk walk{*this};
  walk.visit(entry);
  return walk.done;
}

DeepestPath CallGraph::deepest_path(const std::string& entry, long allowance) const {
  std::map<std::string, DeepestPath> known;
  const std::function<const DeepestPath&(const std::string&)> visit =
      [&](const std::string& symbol) -> const DeepestPath& {
    if (const auto at = known.find(symbol); at != known.end()) {
      return at->second;
    }
    const Function& function = functions_.at(symbol);
    DeepestPath deepest;
    for (const std::string& called : function.calls) {
      const DeepestPath& below_it = visit(called);
      if (below_it.bytes > deepest.bytes) {
        deepest = below_it;
      }
    }
    deepest.bytes += function.frame >= 0 ? function.frame + kPerCall : allowance;
    deepest.symbols.insert(deepest.symbols.begin(), symbol);
    return known[symbol] = deepest;
  };
  return visit(entry);
}

}  // namespace quickstrip::evidence
