#include "sim/section_table/lagrange_table.hpp"

#include <algorithm>
#include <span>

#include "core/base/interpolation.hpp"
#include "core/strip/section_table_data.hpp"

namespace quickstrip {
namespace {

namespace data = section_table_data;

constexpr std::size_t kRow = kNumTabulatedFrequencies * kNumSectionQuantities;

// Weights of four neighbouring nodes: between two nodes, the parabola through the three to the left and that
// to the right (second-degree Lagrange) blend linearly. Without it the parabolas leave steps, which slopes
// over frequency and the ship's length would see. At the ends the one parabola alone.
SplineStencil parabolic_blend(std::span<const double> nodes, double x) {
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), x);
  const std::size_t right =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, nodes.size() - 1);
  SplineStencil result;
  result.first = std::min(right < 2 ? 0 : right - 2, nodes.size() - 4);
  const std::span<const double> near = nodes.subspan(result.first, 4);
  // Share of the right-hand parabola: 0 in the first interval, 1 in the last.
  const double share = std::clamp((x - near[1]) / (near[2] - near[1]), 0.0, 1.0);
  const LagrangeStencil left = lagrange_stencil(near.first(3), x);
  const LagrangeStencil beyond = lagrange_stencil(near.last(3), x);
  for (std::size_t i = 0; i < 3; ++i) {
    result.weight[i] += (1.0 - share) * left.weight[i];
    result.weight[i + 1] += share * beyond.weight[i];
  }
  return result;
}

// Value of one quantity of core's spline at a node of all three axes.
float spline_at_node(const SplineStencil& h0, const SplineStencil& fullness, const SplineStencil& frequency,
                     std::size_t quantity) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t section = (h0.first + i) * data::kFullness.size() + fullness.first + j;
        const std::size_t place = section * kRow + (frequency.first + k) * kNumSectionQuantities + quantity;
        sum += h0.weight[i] * fullness.weight[j] * frequency.weight[k] *
               static_cast<double>(data::kCoefficients[place]);
      }
    }
  }
  return static_cast<float>(sum);
}

}  // namespace

LagrangeTable::LagrangeTable() {
  values_.reserve(data::kCoefficients.size());
  for (const std::span<const double> range : {data::kLogH0Below, data::kLogH0Above}) {
    for (const double log_h0 : range) {
      SplineStencil h0 = spline_stencil(range, log_h0);
      h0.first += range.data() == data::kLogH0Below.data() ? 0 : data::kLogH0Below.size();
      for (const double p : data::kFullness) {
        for (const double u : data::kFrequency) {
          for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
            values_.push_back(spline_at_node(h0, spline_stencil(data::kFullness, p),
                                             spline_stencil(data::kFrequency, u), q));
          }
        }
      }
    }
  }
}

SectionQuantities LagrangeTable::at_node(std::size_t h0, std::size_t fullness, std::size_t frequency) const {
  SectionQuantities result{};
  const std::size_t start =
      (h0 * data::kFullness.size() + fullness) * kRow + frequency * kNumSectionQuantities;
  std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(start), kNumSectionQuantities, result.begin());
  return result;
}

Result<LagrangeColumn> LagrangeTable::column(double h0, double sigma) const {
  const Result<TablePosition> position = table_position(h0, sigma);
  if (!position) {
    return position.error();
  }
  const bool below = position->log_h0 <= 0.0;
  SplineStencil row = parabolic_blend(below ? data::kLogH0Below : data::kLogH0Above, position->log_h0);
  row.first += below ? 0 : data::kLogH0Below.size();
  const SplineStencil fullness = parabolic_blend(data::kFullness, position->fullness);
  std::array<double, kRow> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double weight = row.weight[i] * fullness.weight[j];
      const std::size_t section = (row.first + i) * data::kFullness.size() + fullness.first + j;
      for (std::size_t n = 0; n < kRow; ++n) {
        sum[n] += weight * static_cast<double>(values_[section * kRow + n]);
      }
    }
  }
  LagrangeColumn column;
  column.form = position->form;
  for (std::size_t n = 0; n < kRow; ++n) {
    column.values[n] = static_cast<float>(sum[n] * position->scales[n % kNumSectionQuantities]);
  }
  return column;
}

SectionCoefficients section_coefficients(const LagrangeColumn& column, double xi) {
  const double kappa = kappa_in_table(column.form, xi);
  const SplineStencil frequency = parabolic_blend(data::kFrequency, frequency_coordinate(kappa));
  SectionQuantities sum{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
      sum[q] += frequency.weight[k] *
                static_cast<double>(column.values[(frequency.first + k) * kNumSectionQuantities + q]);
    }
  }
  return coefficients_of(column.form, sum, xi);
}

}  // namespace quickstrip
