// quickstrip_stack_bound FOLDER [MOST]: the worst-case stack of core from the compiler's call graph
// (call_graph.hpp) below every function that the session calls. Exit 1 when a path recurs, calls through a
// pointer that is not on the list, has a frame that the compiler does not know, or needs more than MOST
// bytes.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/evidence/call_graph.hpp"

namespace {

using namespace quickstrip::evidence;

// What the session and the firmware call each cycle, and at start.
constexpr std::array kEntries{"quickstrip::Advisor::configure", "quickstrip::Advisor::step",
                              "quickstrip::Advisor::rebuild", "quickstrip::Advisor::respond_at"};

// libm's functions on glibc and newlib: tests measure them (stack_high_water_test.cpp).
constexpr long kAllowance = 2048;

struct AllowedCall {
  std::string_view caller;  // in its title
  std::string_view target;
};

// Calls through a pointer, and what stands behind it.
constexpr std::array kAllowedCalls{
    AllowedCall{"quickstrip::check_failed", "the check handler: this process's own, ends it"},
};

bool is_allowed(const std::string& title) {
  for (const AllowedCall& call : kAllowedCalls) {
    if (title.find(call.caller) != std::string::npos) {
      return true;
    }
  }
  return false;
}

/// How many things are wrong below `entry`, each told.
int num_faults(const CallGraph& graph, const std::string& entry) {
  const auto cycle = graph.recursion_below(entry);
  if (!cycle.empty()) {
    std::printf("  recursion:\n");
    for (const std::string& symbol : cycle) {
      std::printf("    %s\n", graph.function(symbol).title.c_str());
    }
    return 1;
  }
  int faults = 0;
  for (const std::string& symbol : graph.below(entry)) {
    const Function& function = graph.function(symbol);
    if (function.is_dynamic) {
      std::printf("  a frame of unknown size: %s\n", function.title.c_str());
      ++faults;
    }
    if (function.calls.contains(CallGraph::kIndirect) && !is_allowed(function.title)) {
      std::printf("  a call through a pointer: %s\n", function.title.c_str());
      ++faults;
    }
  }
  return faults;
}

void print_path(const CallGraph& graph, const DeepestPath& path) {
  for (const std::string& symbol : path.symbols) {
    const Function& function = graph.function(symbol);
    std::printf("  %8ld  %.110s\n", function.frame >= 0 ? function.frame : kAllowance,
                function.title.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: quickstrip_stack_bound FOLDER [MOST]\n");
    return 2;
  }
  CallGraph graph;
  const std::size_t num_files = graph.read_all(argv[1]);
  std::printf("%zu files, %zu functions; %ld bytes allowed for a function of libm\n", num_files, graph.size(),
              kAllowance);
  int faults = num_files == 0 ? 1 : 0;
  long most = 0;
  for (const char* const name : kEntries) {
    const auto symbols = graph.find(name);
    std::printf("%s: ", name);
    if (symbols.size() != 1) {
      std::printf("%zu functions of this name\n", symbols.size());
      ++faults;
      continue;
    }
    const int faults_here = num_faults(graph, symbols.front());
    faults += faults_here;
    if (graph.recursion_below(symbols.front()).empty()) {
      const DeepestPath path = graph.deepest_path(symbols.front(), kAllowance);
      std::printf("%ld bytes\n", path.bytes);
      print_path(graph, path);
      most = path.bytes > most ? path.bytes : most;
    }
  }
  std::printf("worst case: %ld bytes\n", most);
  if (argc == 3 && most > std::atol(argv[2])) {
    std::printf("more than %s\n", argv[2]);
    ++faults;
  }
  return faults == 0 ? 0 : 1;
}
