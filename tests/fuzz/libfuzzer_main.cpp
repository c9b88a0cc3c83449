// The door of libFuzzer: quickstrip_fuzz --target=NAME [--seeds=FOLDER] [libFuzzer's own options and
// folders].
// --seeds writes the target's seeds into a folder, to start from. libFuzzer leaves options with two dashes
// alone.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/targets.hpp"

namespace {

using namespace quickstrip::fuzz;

const Target* g_target = nullptr;

void write_seeds(const Target& target, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const Bytes& seed : target.seeds()) {
    std::ofstream file(folder / ("seed" + std::to_string(number++)), std::ios::binary);
    file.write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  std::string seeds;
  for (int i = 1; i < *argc; ++i) {
    const std::string word = (*argv)[i];
    if (word.starts_with("--target=")) {
      g_target = target_of(word.substr(std::strlen("--target=")));
    } else if (word.starts_with("--seeds=")) {
      seeds = word.substr(std::strlen("--seeds="));
    }
  }
  if (g_target == nullptr) {
    std::fprintf(stderr, "--target=NAME is needed, one of:");
    for (const Target& target : targets()) {
      std::fprintf(stderr, " %.*s", static_cast<int>(target.name.size()), target.name.data());
    }
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  if (!seeds.empty()) {
    write_seeds(*g_target, seeds);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  g_target->run({data, size});
  return 0;
}
