// Every fuzz target on its seeds, on what fuzzing has found, and on some seconds' worth of seeded mutations.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tests/fuzz/mutations.hpp"
#include "tests/fuzz/targets.hpp"

namespace quickstrip::fuzz {
namespace {

/// tests/fuzz/findings/TARGET/SYMPTOM
std::vector<Bytes> findings(std::string_view target) {
  std::vector<Bytes> list;
  std::filesystem::path folder = std::string(QUICKSTRIP_SOURCE_DIR) + "/tests/fuzz/findings";
  folder /= target;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    std::ifstream file(entry.path(), std::ios::binary);
    list.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return list;
}

class ShortFuzz : public testing::TestWithParam<Target> {};

TEST_P(ShortFuzz, SeedsFindingsAndMutationsOfThemBreakNothing) {
  const Target& target = GetParam();
  std::vector<Bytes> seeds = target.seeds();
  for (const Bytes& finding : findings(target.name)) {
    seeds.push_back(finding);
  }
  for (const Bytes& seed : seeds) {
    target.run(seed);
  }
  std::mt19937 random(20'261'122);
  for (int i = 0; i < target.num_mutations; ++i) {
    target.run(mutated(seeds, random));  // a broken promise aborts
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, ShortFuzz, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace quickstrip::fuzz
