// Time of one cycle at full capacity: 25 speeds x 72 headings, 72 directions with energy, 48 frequencies, the
// default criteria, two wave systems. Prints milliseconds: shortest and median of ten.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>

#include "tests/advice/scene.hpp"

namespace {

using quickstrip::synthetic::Scene;

template <typename Work>
void time_of(const char* what, const Work& work) {
  std::array<double, 10> ms{};
  for (double& one : ms) {
    const auto start = std::chrono::steady_clock::now();
    work();
    one = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  std::sort(ms.begin(), ms.end());
  std::printf("%-28s %8.2f ms shortest, %8.2f ms median\n", what, ms.front(), ms[5]);
}

}  // namespace

int main() {
  auto scene = std::make_unique<Scene>();
  quickstrip::synthetic::fill(scene->transfer, quickstrip::kMaxSpeeds, 0.5, quickstrip::kMaxFrequencies,
                              quickstrip::synthetic::shiplike);
  quickstrip::synthetic::add_system(scene->sea, scene->transfer, 3.0, 8.0, 0, 35);
  quickstrip::synthetic::add_system(scene->sea, scene->transfer, 2.0, 11.0, 22, 35);
  time_of("grid, seas all round", [&] { scene->sweep(); });
  time_of("response of one cell", [&] {
    if (!respond(scene->inputs(), {1.02}, 4.7, scene->response).ok()) {
      std::puts("refused");
    }
  });
  scene->sea = quickstrip::SeaEnergy{};
  quickstrip::synthetic::add_system(scene->sea, scene->transfer, 3.0, 8.0, 0, 0);
  time_of("grid, one long-crested sea", [&] { scene->sweep(); });
  return 0;
}
