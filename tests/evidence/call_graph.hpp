// The call graph that gcc writes beside each object (-fcallgraph-info=su): who calls whom, and the stack
// frame of each function in bytes; and what follows for the whole: the deepest path below a function,
// recursion, calls through pointers, frames whose size the compiler does not know.
//
// A function that several objects hold (inline, template) counts with its largest frame and the calls of all.
// What no object defines is the world outside: libm and memory functions, which get an allowance. 16 bytes a
// call are added for what gcc leaves out (return address, alignment).
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace quickstrip::evidence {

struct Function {
  std::string title;  // "Status quickstrip::Advisor::rebuild()" as the compiler words it
  long frame = -1;    // bytes; -1: not defined in any file read
  bool is_dynamic = false;
  std::set<std::string> calls;  // symbols
};

struct DeepestPath {
  long bytes = 0;
  std::vector<std::string> symbols;
};

class CallGraph {
 public:
  /// Adds one .ci file.
  void read(std::istream& file);
  /// Adds every .ci file below a folder; how many there were.
  std::size_t read_all(const std::filesystem::path& folder);

  /// Symbols of the functions whose title has "NAME(" in it.
  [[nodiscard]] std::vector<std::string> find(const std::string& name) const;
  [[nodiscard]] const Function& function(const std::string& symbol) const { return functions_.at(symbol); }
  [[nodiscard]] std::size_t size() const { return functions_.size(); }

  /// A cycle that can be reached from `entry`; empty: none.
  [[nodiscard]] std::vector<std::string> recursion_below(const std::string& entry) const;
  /// Everything reachable.
  [[nodiscard]] std::set<std::string> below(const std::string& entry) const;
  /// Of a graph without recursion. `allowance`: bytes for a function of the outside world.
  [[nodiscard]] DeepestPath deepest_path(const std::string& entry, long allowance) const;

  static constexpr const char* kIndirect = "__indirect_call";

 private:
  struct Walk;
  std::map<std::string, Function> functions_;
};

}  // namespace quickstrip::evidence
