// The reader of the compiler's call graph must be able to fail: a planted recursion, a call through a
// pointer, a frame of unknown size; and its bound is that of a graph worked by hand.
#include "tests/evidence/call_graph.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace quickstrip::evidence {
namespace {

// As gcc 12 writes it. One line a string: a formatter takes a raw string with braces for code.
const std::string kFile =
    "graph: { title: \"a.cpp\"\n"
    "node: { title: \"_Z3topv\" label: \"void a::top()\\na.cpp:1:5\\n100 bytes (static)\" }\n"
    "node: { title: \"_Z4leftv\" label: \"void a::left()\\na.cpp:2:5\\n1000 bytes (static)\" }\n"
    "node: { title: \"a.cpp:_ZL5rightv\" label: \"void a::right()\\na.cpp:3:5\\n200 bytes (static)\" }\n"
    "node: { title: \"sin\" label: \"double __builtin_sin(double)\\n<built-in>\" shape : ellipse }\n"
    "node: { title: \"_Z4loopv\" label: \"void a::loop()\\na.cpp:4:5\\n48 bytes (static)\" }\n"
    "node: { title: \"_Z5roundv\" label: \"void a::round()\\na.cpp:5:5\\n48 bytes (dynamic)\" }\n"
    "node: { title: \"__indirect_call\" label: \"Indirect Call Placeholder\" shape : ellipse }\n"
    "edge: { sourcename: \"_Z3topv\" targetname: \"_Z4leftv\" label: \"a.cpp:9:1\" }\n"
    "edge: { sourcename: \"_Z3topv\" targetname: \"a.cpp:_ZL5rightv\" label: \"a.cpp:9:2\" }\n"
    "edge: { sourcename: \"a.cpp:_ZL5rightv\" targetname: \"sin\" label: \"a.cpp:9:3\" }\n"
    "edge: { sourcename: \"_Z4loopv\" targetname: \"_Z5roundv\" label: \"a.cpp:9:4\" }\n"
    "edge: { sourcename: \"_Z5roundv\" targetname: \"_Z4loopv\" label: \"a.cpp:9:5\" }\n"
    "edge: { sourcename: \"_Z5roundv\" targetname: \"__indirect_call\" label: \"a.cpp:9:6\" }\n";

CallGraph planted() {
  CallGraph graph;
  std::istringstream file(kFile);
  graph.read(file);
  return graph;
}

TEST(CallGraph, DeepestPathIsThatWorkedByHand) {
  const CallGraph graph = planted();
  ASSERT_EQ(graph.find("a::top"), std::vector<std::string>{"_Z3topv"});
  EXPECT_TRUE(graph.find("op").empty());
  // Left: 100 + 1000 and 16 a call. Right with an allowance of 2000 for sin is deeper.
  EXPECT_EQ(graph.deepest_path("_Z3topv", 500).bytes, 100 + 1000 + 2 * 16);
  const DeepestPath right = graph.deepest_path("_Z3topv", 2000);
  EXPECT_EQ(right.bytes, 100 + 200 + 2 * 16 + 2000);
  EXPECT_EQ(right.symbols, (std::vector<std::string>{"_Z3topv", "a.cpp:_ZL5rightv", "sin"}));
}

TEST(CallGraph, PlantedRecursionIsFound) {
  const CallGraph graph = planted();
  EXPECT_TRUE(graph.recursion_below("_Z3topv").empty());
  EXPECT_EQ(graph.recursion_below("_Z4loopv").size(), 2U);
}

TEST(CallGraph, PlantedPointerCallAndUnknownFrameAreSeen) {
  const CallGraph graph = planted();
  EXPECT_TRUE(graph.function("_Z5roundv").calls.contains(CallGraph::kIndirect));
  EXPECT_TRUE(graph.function("_Z5roundv").is_dynamic);
  EXPECT_FALSE(graph.function("_Z4leftv").is_dynamic);
}

TEST(CallGraph, AFunctionOfSeveralFilesHasItsLargestFrame) {
  CallGraph graph = planted();
  std::istringstream other(
      "node: { title: \"_Z4leftv\" label: \"void a::left()\\nb.cpp:2:5\\n64 bytes (static)\" }");
  graph.read(other);
  EXPECT_EQ(graph.function("_Z4leftv").frame, 1000);
}

}  // namespace
}  // namespace quickstrip::evidence
