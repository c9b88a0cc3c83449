// Every loop of core is bounded: counted, or with its reason beside it.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/arch/source_tree.hpp"
#include "tests/evidence/loop_rules.hpp"

namespace quickstrip::evidence {
namespace {

TEST(Loops, EveryLoopOfCoreIsCountedOrHasItsReasonBesideIt) {
  std::size_t count = 0;
  for (const arch::SourceFile& file : arch::source_files({"core"}, {".cpp", ".hpp"})) {
    if (file.path.ends_with("section_table_data.cpp")) {
      continue;  // numbers
    }
    count += num_loops(file.text);
    for (const LoopWithoutReason& loop : loops_without_reason(file.text)) {
      ADD_FAILURE() << file.path << ":" << loop.line << ": why does it end? (// bounded: ...) " << loop.text;
    }
  }
  EXPECT_GT(count, 300U);
  std::printf("%zu loops\n", count);
}

TEST(Loops, PlainlyCountedOnesNeedNoReason) {
  for (const char* const text :
       {"for (std::size_t i = 0; i < n; ++i) { a[i] = i; }\n",
        "for (std::size_t i = n; i-- > 0;) { a[i] = 0; }\n",
        "for (std::size_t i = 0; i + 1 < n; ++i) { a[i] = a[i + 1]; }\n",
        "for (int i = 8; i >= 0; i -= 2) a[i] = 1;\n", "while (i + 1 < n && a[i] < x) {\n  ++i;\n}\n",
        "while (end > first && is_empty(end - 1)) { --end; }\n",
        "for (const double x : values) { sum += x; }\n",
        "for (std::size_t i = 0; i < n && !found; ++i) { found = a[i] == i; }\n"}) {
    EXPECT_TRUE(loops_without_reason(text).empty()) << text;
    EXPECT_EQ(num_loops(text), 1U);
  }
}

TEST(Loops, PlantedOnesAreFound) {
  for (const char* const text :
       {"while (a[i] < x) { ++i; }\n", "while (i < n && a[i] < x) { --i; }\n",
        "while (!converged) { iterate(); }\n", "do { x *= 0.5; } while (x > 1e-9);\n",
        "for (;;) { wait(); }\n", "for (double x = 0.0; x < end; x += step) { f(x); }\n",
        "for (std::size_t i = 0; i < n; ++i) { if (again) { --i; } }\n",
        "for (std::size_t i = 0; i < n; ++i) { i = next[i]; }\n",
        "for (std::size_t i = 0; !done(i); ++i) { f(i); }\n",
        "for (std::size_t i = 0; i < n || !done; ++i) { f(i); }\n"}) {
    EXPECT_FALSE(loops_without_reason(text).empty()) << text;
  }
  EXPECT_TRUE(loops_without_reason("// bounded: i grows to n\nwhile (i < n) { ++i; }\n").empty());
}

}  // namespace
}  // namespace quickstrip::evidence
