// Seeded mutations of bytes, as a fuzzer makes them: the same on every machine.
#pragma once

#include <random>
#include <vector>

#include "tests/fuzz/targets.hpp"

namespace quickstrip::fuzz {

/// One to eight changes of one of `seeds`: bits, bytes, numbers and words replaced, stretches dropped,
/// doubled or taken from another seed.
Bytes mutated(const std::vector<Bytes>& seeds, std::mt19937& random);

}  // namespace quickstrip::fuzz
