// Prints the bytes of everything that the advisor holds, in the profile of capacities that it is built with,
// of a compiled hull table beside it (0: read where it lies), and of the section table, which is constant
// and lies in flash.
#include <algorithm>
#include <cstdio>

#include "core/advisor.hpp"
#include "core/strip/section_table.hpp"

namespace {

void print(const char* what, std::size_t bytes) {
  std::printf("  %-44s %9zu\n", what, bytes);
}

}  // namespace

int main() {
  using namespace quickstrip;
  std::printf("Memory in bytes, profile %s:\n", capacity::kProfileName);
  print("Advisor, everything included", sizeof(Advisor));
  print("  allowed", kMostAdvisorBytes);
  print("  TransferFunctions", sizeof(TransferFunctions));
  print("    motions at wave frequencies", sizeof(TransferFunctions::row));
  print("    motions at roll peaks", sizeof(TransferFunctions::peak));
  constexpr std::size_t kOfCycle = sizeof(SeaEnergy) + sizeof(GridWorkspace) + sizeof(StepOutput);
  constexpr std::size_t kOfBuilding = sizeof(LoadedHull) + sizeof(TransferWorkspace);
  print("  One after the other: the larger of these", std::max(kOfCycle, kOfBuilding));
  print("    cycle: SeaEnergy", sizeof(SeaEnergy));
  print("    cycle: scratch", sizeof(GridWorkspace));
  print("    cycle: StepOutput", sizeof(StepOutput));
  print("    change of loading: LoadedHull", sizeof(LoadedHull));
  print("      coefficients at encounter frequencies", sizeof(LoadedHull::node));
  print("      contours for wave loads",
        sizeof(LoadedHull::wave_contour) + sizeof(LoadedHull::lewis_contour));
  print("    change of loading: scratch", sizeof(TransferWorkspace));
  print("Hull, beside it", sizeof(Hull));
  print("Hull table, where one is loaded: at most", kMaxHullTableBytes);
  print("Section table, constant", section_table_bytes());
  return 0;
}
