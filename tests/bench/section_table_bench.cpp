// Cost of the section table: finding a section's column, and coefficients at one frequency.
#include <benchmark/benchmark.h>

#include "core/strip/section_table.hpp"

namespace quickstrip {
namespace {

// The midship section of the S-175: H0 1.337, sigma 0.968.
constexpr double kH0 = 1.337;
constexpr double kSigma = 0.968;

void section_table_column_of_a_section(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(section_table_column(kH0, kSigma));
  }
}
BENCHMARK(section_table_column_of_a_section);

void section_coefficients_at_one_frequency(benchmark::State& state) {
  const auto column = section_table_column(kH0, kSigma);
  if (!column.ok()) {
    state.SkipWithError("the midship section is outside the table");
    return;
  }
  double xi = 0.1;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(section_coefficients(column.value(), xi));
    xi = xi < 5.0 ? xi + 0.01 : 0.1;
  }
}
BENCHMARK(section_coefficients_at_one_frequency);

}  // namespace
}  // namespace quickstrip
