#include "tests/arch/include_rules.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "tests/arch/source_tree.hpp"

namespace quickstrip::arch {
namespace {

using Prefixes = std::vector<std::string_view>;

struct RoomRule {
  std::string_view room;  // the longest matching prefix decides
  Prefixes may_include;   // project files, by prefix
};

// firmware -> msgs -> core; inside core base <- sea <- hull <- strip <- response <- hazard <- advice <-
// advisor.
const std::vector<RoomRule>& rules() {
  static const std::vector<RoomRule> table = {
      {"core/base/", {"core/base/"}},
      {"core/sea/", {"core/base/", "core/sea/"}},
      {"core/hull/", {"core/base/", "core/sea/", "core/hull/"}},
      {"core/strip/", {"core/base/", "core/sea/", "core/hull/", "core/strip/"}},
      {"core/response/", {"core/base/", "core/sea/", "core/hull/", "core/strip/", "core/response/"}},
      {"core/hazard/",
       {"core/base/", "core/sea/", "core/hull/", "core/strip/", "core/response/", "core/hazard/"}},
      {"core/advice/",
       {"core/base/", "core/sea/", "core/hull/", "core/strip/", "core/response/", "core/hazard/",
        "core/advice/"}},
      {"core/", {"core/"}},  // the advisor, last in the row
      {"msgs/", {"core/", "msgs/"}},
      {"firmware/", {"core/", "msgs/", "firmware/"}},
      // The generator makes the table that core/strip holds: it must not lean on what uses the table.
      {"sim/section_table/", {"core/base/", "core/hull/", "sim/section_table/"}},
      {"sim/", {"core/", "msgs/", "firmware/session/", "sim/"}},
      {"tests/", {"core/", "msgs/", "firmware/", "sim/", "tests/"}},
  };
  return table;
}

// The standard headers that core may use: none allocates, throws, prints, waits or asks for the time.
const std::set<std::string, std::less<>>& core_standard_headers() {
  static const std::set<std::string, std::less<>> headers = {
      "algorithm",   "array",   "bit",      "bitset",   "cassert", "cfloat",  "climits",          "cmath",
      "compare",     "complex", "concepts", "cstddef",  "cstdint", "cstring", "initializer_list", "iterator",
      "limits",      "numbers", "numeric",  "optional", "ranges",  "span",    "string_view",      "tuple",
      "type_traits", "utility", "variant"};
  return headers;
}

bool starts_with_one(std::string_view path, const Prefixes& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](std::string_view prefix) { return path.starts_with(prefix); });
}

const RoomRule* rule_of(std::string_view path) {
  const RoomRule* best = nullptr;
  for (const RoomRule& rule : rules()) {
    if (path.starts_with(rule.room) && (best == nullptr || rule.room.size() > best->room.size())) {
      best = &rule;
    }
  }
  return best;
}

bool is_project_path(std::string_view name) {
  return starts_with_one(name, {"core/", "msgs/", "firmware/", "sim/", "tests/"});
}

// The tool's main program and its measurement of accuracy read the finished table; what makes it does not.
bool judges_the_finished_table(std::string_view path, std::string_view name) {
  return (path == "sim/section_table/main.cpp" || path == "sim/section_table/accuracy.cpp" ||
          path.starts_with("sim/section_table/lagrange_table.")) &&
         name.starts_with("core/strip/section_table");
}

bool is_allowed_outside(std::string_view path, std::string_view name, bool is_quoted) {
  if (path.starts_with("core/")) {
    const bool is_eigen_door = path == "core/base/eigen.hpp";
    return !is_quoted &&
           (core_standard_headers().contains(name) || (is_eigen_door && name.starts_with("Eigen/")));
  }
  if (name.starts_with("toml++/")) {  // files are read in one place
    return path.starts_with("msgs/files/") || path.starts_with("tests/");
  }
  if (path.starts_with("firmware/session/") || path.starts_with("sim/section_table/")) {
    return !name.starts_with("lcm/");  // the live process and the replay run the same code, without a bus
  }
  // Quoted and not ours: only what lcm-gen wrote.
  return !is_quoted || name.starts_with("quickstrip/") || name.starts_with("quickstrip_");
}

}  // namespace

std::vector<std::string> forbidden_includes(const std::string& path, std::string_view text) {
  const RoomRule* const rule = rule_of(path);
  if (rule == nullptr) {
    return {path + ": belongs to no room"};
  }
  std::vector<std::string> found;
  for (const std::string& include : includes_of(text)) {
    const std::string name = include.substr(1, include.size() - 2);
    const bool is_allowed = is_project_path(name) ? starts_with_one(name, rule->may_include) ||
                                                        judges_the_finished_table(path, name)
                                                  : is_allowed_outside(path, name, include.front() == '"');
    if (!is_allowed) {
      found.push_back(path + " may not include " + include);
    }
  }
  return found;
}

}  // namespace quickstrip::arch
