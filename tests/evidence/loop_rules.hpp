// Loops of a source that are not plainly counted: every while, do and for (;;), and every for that does not
// count its own variable in steps up to a bound, or that changes it in its body. Each needs a reason beside
// it:
// `// bounded: ...` on its line or the line above.
//
// Plainly counted: `for (T i = a; i < b; ++i)` and the like (<=, >, >=, !=, --i, i += c, `i-- > 0`), `i`
// assigned nowhere in the body; every for over a range; `while (i + 1 < n && ...) { ++i; }` with nothing else
// in its body, and the like downwards; `do { ... } while (false)`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quickstrip::evidence {

struct LoopWithoutReason {
  std::size_t line = 0;  // from 1
  std::string text;
};

std::vector<LoopWithoutReason> loops_without_reason(std::string_view source);

/// How many loops there are at all: so that a reader that sees none is noticed.
std::size_t num_loops(std::string_view source);

}  // namespace quickstrip::evidence
