// Cost of the section table: finding a section's column, and coefficients at one frequency; by the
// spline of core and by Lagrange interpolation.
#include <benchmark/benchmark.h>

#include "core/strip/section_table.hpp"
#include "sim/section_table/lagrange_table.hpp"

namespace quickstrip {
namespace {

// The midship section of the S-175: H0 1.337, sigma 0.968.
constexpr double kH0 = 1.337;
constexpr double kSigma = 0.968;

void spline_column_of_a_section(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(section_table_column(kH0, kSigma));
  }
}
BENCHMARK(spline_column_of_a_section);

void lagrange_column_of_a_section(benchmark::State& state) {
  const LagrangeTable table;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(table.column(kH0, kSigma));
  }
}
BENCHMARK(lagrange_column_of_a_section);

template <typename Column>
void over_frequencies(benchmark::State& state, const Result<Column>& column) {
  if (!column.ok()) {
    state.SkipWithError("the midship section is outside the table");
    return;
  }
  double xi = 0.1;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(section_coefficients(*column, xi));
    xi = xi < 5.0 ? xi + 0.01 : 0.1;
  }
}

void spline_coefficients_at_one_frequency(benchmark::State& state) {
  over_frequencies(state, section_table_column(kH0, kSigma));
}
BENCHMARK(spline_coefficients_at_one_frequency);

void lagrange_coefficients_at_one_frequency(benchmark::State& state) {
  over_frequencies(state, LagrangeTable().column(kH0, kSigma));
}
BENCHMARK(lagrange_coefficients_at_one_frequency);

void checksum_of_the_table(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(section_table_is_intact());
  }
}
BENCHMARK(checksum_of_the_table);

}  // namespace
}  // namespace quickstrip
