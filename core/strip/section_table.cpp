#include "core/strip/section_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <tuple>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "core/base/fnv1a64.hpp"
#include "core/base/interpolation.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/strip/section_table_data.hpp"

namespace quickstrip {
namespace {

namespace data = section_table_data;

// Rounding at the bounds is not a fault: sections are clipped to them.
constexpr double kBoundTolerance = 1e-9;

// Not across H0 = 1, where the bounds of a3 have a fold.
SplineStencil log_h0_stencil(double log_h0) {
  if (log_h0 <= 0.0) {
    return spline_stencil(data::kLogH0Below, log_h0);
  }
  SplineStencil stencil = spline_stencil(data::kLogH0Above, log_h0);
  stencil.first += data::kLogH0Below.size();
  return stencil;
}

// The spline over frequency at one H0 and fullness, scaled.
void set_spline(const TablePosition& position, SectionTableColumn& column) {
  const std::size_t row = column.spline.size();
  const SplineStencil h0 = log_h0_stencil(position.log_h0);
  const SplineStencil fullness = spline_stencil(data::kFullness, position.fullness);
  std::array<double, std::tuple_size_v<decltype(column.spline)>> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double weight = h0.weight[i] * fullness.weight[j];
      const std::size_t section = (h0.first + i) * data::kFullness.size() + fullness.first + j;
      const std::span<const float> stored = data::kCoefficients.subspan(section * row, row);
      for (std::size_t n = 0; n < row; ++n) {
        sum[n] += weight * static_cast<double>(stored[n]);
      }
    }
  }
  for (std::size_t n = 0; n < row; ++n) {
    column.spline[n] = static_cast<float>(sum[n] * position.scales[n % kNumSectionQuantities]);
  }
}

SectionQuantities smooth_quantities(const SectionTableColumn& column, double kappa) {
  const SplineStencil frequency = spline_stencil(data::kFrequency, frequency_coordinate(kappa));
  const std::span<const float> near =
      std::span<const float>(column.spline)
          .subspan(frequency.first * kNumSectionQuantities, 4 * kNumSectionQuantities);
  SectionQuantities sum{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
      sum[q] += frequency.weight[k] * static_cast<double>(near[k * kNumSectionQuantities + q]);
    }
  }
  return sum;
}

}  // namespace

Result<TablePosition> table_position(double h0, double sigma) {
  if (!std::isfinite(h0) || !std::isfinite(sigma)) {
    return Error::kNotFinite;
  }
  if (!(h0 >= kMinTabulatedH0 * (1.0 - kBoundTolerance) && h0 <= kMaxTabulatedH0 * (1.0 + kBoundTolerance) &&
        sigma > 0.0)) {
    return Error::kOutOfRange;
  }
  const double limit = upper_limit(h0);
  const double inside = sigma > limit && sigma <= limit * (1.0 + kBoundTolerance) ? limit : sigma;
  const Result<LewisSection> section = lewis_section(2.0 * h0, 1.0, 2.0 * h0 * inside);
  if (!section) {
    return section.error();
  }
  const double q = breadth_draught_parameter(h0);
  const double p = fullness(q, section->a3);
  if (!(p <= 1.0 + kBoundTolerance)) {
    return Error::kOutOfRange;
  }
  return TablePosition{
      .log_h0 = std::log(h0),
      .fullness = p,
      .scales = quantity_scales(q),
      .form = {.bluntness = waterline_bluntness(section->a1, section->a3),
               .lateral_at_infinity = lateral_added_mass_at_infinity(section->a1, section->a3),
               .heave_at_infinity = heave_added_mass_at_infinity(section->a1, section->a3),
               .breadth = breadth_in_scale(section->a1, section->a3),
               .area = area_in_scale(section->a1, section->a3)}};
}

Result<SectionTableColumn> section_table_column(double h0, double sigma) {
  const Result<TablePosition> position = table_position(h0, sigma);
  if (!position) {
    return position.error();
  }
  SectionTableColumn column;
  column.form = position->form;
  set_spline(*position, column);
  return column;
}

SectionCoefficients section_coefficients(const SectionTableColumn& column, double xi) {
  QS_CHECK(xi >= 0.0 && std::isfinite(xi));
  return coefficients_of(column.form, smooth_quantities(column, kappa_in_table(column.form, xi)), xi);
}

double kappa_in_table(const TabulatedForm& form, double xi) {
  return std::min(2.0 * xi / form.breadth, data::kGreatestKappa);
}

SectionCoefficients coefficients_of(const TabulatedForm& form, SectionQuantities smooth, double xi) {
  constexpr double kLeastXiOfHeave = 1e-12;
  SectionQuantities& v = smooth;
  const double kappa = 2.0 * xi / form.breadth;
  const double inside = kappa_in_table(form, xi);
  const double for_log = std::max(inside, 2.0 * kLeastXiOfHeave / form.breadth);
  v[kHeaveMass] -= form.breadth * form.breadth / kPi * std::log(for_log / (1.0 + for_log));
  if (kappa > inside) {
    // The added masses approach their limits as 1/kappa; the scaled amplitudes keep their last values.
    const double rest = inside / kappa;
    v[kHeaveMass] = form.heave_at_infinity + (v[kHeaveMass] - form.heave_at_infinity) * rest;
    const LewisAddedMass& lateral = form.lateral_at_infinity;
    v[kSwayMass] = lateral.a22 + (v[kSwayMass] - lateral.a22) * rest;
    v[kCouplingMass] = lateral.a24 + (v[kCouplingMass] - lateral.a24) * rest;
    v[kRollMass] = lateral.a44 + (v[kRollMass] - lateral.a44) * rest;
  }
  const AmplitudeDecay decay = amplitude_decay(form.bluntness, kappa);
  const double h3 = v[kHeaveAmplitude] * decay.heave;
  const double h2 = v[kSwayAmplitude] * decay.sway;
  const double h4 = v[kRollAmplitude] * decay.roll;

  const double root = std::sqrt(xi);  // omega sqrt(B/2g)
  const double by_area = 1.0 / form.area;
  const double by_moment = by_area / form.breadth;
  const double by_inertia = by_moment / form.breadth;
  return {.a22 = v[kSwayMass] * by_area,
          .b22 = root * h2 * h2 * by_area,
          .a33 = v[kHeaveMass] * by_area,
          .b33 = root * h3 * h3 * by_area,
          .a44 = v[kRollMass] * by_inertia,
          .b44 = root * h4 * h4 * by_inertia,
          .a24 = v[kCouplingMass] * by_moment,
          .b24 = root * h2 * h4 * by_moment};
}

bool section_table_is_intact() {
  const std::size_t sections = (data::kLogH0Below.size() + data::kLogH0Above.size()) * data::kFullness.size();
  if (data::kFrequency.size() != kNumTabulatedFrequencies ||
      data::kCoefficients.size() != sections * kNumTabulatedFrequencies * kNumSectionQuantities) {
    return false;
  }
  Fnv1a64 hash;
  hash.add(data::kVersion);
  for (const std::span<const double> nodes :
       {data::kLogH0Below, data::kLogH0Above, data::kFullness, data::kFrequency}) {
    for (const double node : nodes) {
      hash.add(node);
    }
  }
  for (const float coefficient : data::kCoefficients) {
    hash.add(std::bit_cast<std::uint32_t>(coefficient));
  }
  return hash.value() == data::kChecksum;
}

std::uint32_t section_table_version() {
  return data::kVersion;
}
std::uint64_t section_table_checksum() {
  return data::kChecksum;
}

std::size_t section_table_numbers() {
  return data::kLogH0Below.size() + data::kLogH0Above.size() + data::kFullness.size() +
         data::kFrequency.size() + data::kCoefficients.size();
}

std::size_t section_table_bytes() {
  return (section_table_numbers() - data::kCoefficients.size()) * sizeof(double) +
         data::kCoefficients.size_bytes();
}

}  // namespace quickstrip
