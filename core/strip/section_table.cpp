#include "core/strip/section_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/strip/section_table_data.hpp"

namespace quickstrip {
namespace {

namespace data = section_table_data;

// Rounding at the bounds is not a fault: sections are clipped to them.
constexpr double kBoundTolerance = 1e-9;

LagrangeStencil log_h0_stencil(double log_h0) {
  // Not across H0 = 1, where the bounds of a3 have a fold.
  std::size_t fold = 0;
  while (fold + 1 < data::kLogH0.size() && data::kLogH0[fold] < 0.0) {
    ++fold;
  }
  if (log_h0 <= 0.0) {
    return lagrange_stencil(data::kLogH0.first(fold + 1), log_h0);
  }
  LagrangeStencil stencil = lagrange_stencil(data::kLogH0.subspan(fold), log_h0);
  stencil.first += fold;
  return stencil;
}

// The frequency nodes in the coordinate of the interpolation, once per call for the three that are used.
LagrangeStencil frequency_stencil(double kappa) {
  const std::span<const double> nodes = data::kKappa;
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), kappa);
  const std::size_t upper =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, nodes.size() - 1);
  const std::size_t first = std::min(upper < 2 ? 0 : upper - 2, nodes.size() - 4);
  std::array<double, 4> near{};
  for (std::size_t i = 0; i < near.size(); ++i) {
    near[i] = frequency_coordinate(nodes[first + i]);
  }
  LagrangeStencil stencil = lagrange_stencil(near, frequency_coordinate(kappa));
  stencil.first += first;
  return stencil;
}

SectionQuantities interpolate(const SectionTableColumn& column, const LagrangeStencil& frequency) {
  SectionQuantities sum{};
  const std::size_t num_kappa = data::kKappa.size();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t section = (column.h0.first + i) * data::kFullness.size() + column.fullness.first + j;
      const std::size_t start = (section * num_kappa + frequency.first) * kNumSectionQuantities;
      const std::span<const float> values = data::kValues.subspan(start, 3 * kNumSectionQuantities);
      const double weight = column.h0.weight[i] * column.fullness.weight[j];
      for (std::size_t k = 0; k < 3; ++k) {
        const double factor = weight * frequency.weight[k];
        for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
          sum[q] += factor * static_cast<double>(values[k * kNumSectionQuantities + q]);
        }
      }
    }
  }
  return sum;
}

class Fnv1a64 {
 public:
  template <typename T>
  void add(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      hash_ = (hash_ ^ ((value >> (8 * i)) & 0xffU)) * 0x100000001b3U;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace

Result<SectionTableColumn> section_table_column(double h0, double sigma) {
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
  const double p = fullness(breadth_draught_parameter(h0), section->a3);
  if (!(p <= 1.0 + kBoundTolerance)) {
    return Error::kOutOfRange;
  }
  SectionTableColumn column;
  column.h0 = log_h0_stencil(std::log(h0));
  column.fullness = lagrange_stencil(data::kFullness, p);
  column.scales = section_scales(section->a1, section->a3);
  column.lateral_at_infinity = lateral_added_mass_at_infinity(section->a1, section->a3);
  column.kappa_per_xi = 2.0 / column.scales.breadth;
  return column;
}

SectionCoefficients section_coefficients(const SectionTableColumn& column, double xi) {
  QS_CHECK(xi >= 0.0 && std::isfinite(xi));
  constexpr double kLeastXiOfHeave = 1e-12;
  const SectionScales& scales = column.scales;
  const double kappa = xi * column.kappa_per_xi;
  const double top = data::kKappa.back();
  const double inside = std::min(kappa, top);
  const SectionQuantities v = interpolate(column, frequency_stencil(inside));

  const double for_log = std::max(inside, kLeastXiOfHeave * column.kappa_per_xi);
  double a33 = v[kHeaveMass] * scales.heave_mass_at_infinity -
               scales.breadth * scales.breadth / kPi * std::log(for_log / (1.0 + for_log));
  double a22 = v[kSwayMass] * scales.sway_mass_at_zero;
  double a24 = v[kCouplingMass] * scales.coupling;
  double a44 = v[kRollMass];
  if (kappa > top) {
    // The added masses approach their limits as 1/kappa; the scaled amplitudes keep their last values.
    const double rest = top / kappa;
    a33 = scales.heave_mass_at_infinity + (a33 - scales.heave_mass_at_infinity) * rest;
    a22 = column.lateral_at_infinity.a22 + (a22 - column.lateral_at_infinity.a22) * rest;
    a24 = column.lateral_at_infinity.a24 + (a24 - column.lateral_at_infinity.a24) * rest;
    a44 = column.lateral_at_infinity.a44 + (a44 - column.lateral_at_infinity.a44) * rest;
  }
  const double decay = 1.0 / (1.0 + kappa);
  const double h3 = v[kHeaveAmplitude] * scales.breadth * decay * decay;
  const double h2 = v[kSwayAmplitude] * scales.sway_radiation * kappa * decay * decay;
  const double h4 = v[kRollAmplitude] * kappa * decay * decay * decay;

  const double root = std::sqrt(xi);  // omega sqrt(B/2g)
  const double by_area = 1.0 / scales.area;
  const double by_moment = by_area / scales.breadth;
  const double by_inertia = by_moment / scales.breadth;
  return {.a22 = a22 * by_area,
          .b22 = root * h2 * h2 * by_area,
          .a33 = a33 * by_area,
          .b33 = root * h3 * h3 * by_area,
          .a44 = a44 * by_inertia,
          .b44 = root * h4 * h4 * by_inertia,
          .a24 = a24 * by_moment,
          .b24 = root * h2 * h4 * by_moment};
}

bool section_table_is_intact() {
  Fnv1a64 hash;
  hash.add(data::kVersion);
  for (const std::span<const double> nodes : {data::kLogH0, data::kFullness, data::kKappa}) {
    for (const double node : nodes) {
      hash.add(std::bit_cast<std::uint64_t>(node));
    }
  }
  for (const float value : data::kValues) {
    hash.add(std::bit_cast<std::uint32_t>(value));
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
  return data::kLogH0.size() + data::kFullness.size() + data::kKappa.size() + data::kValues.size();
}

std::size_t section_table_bytes() {
  return (data::kLogH0.size() + data::kFullness.size() + data::kKappa.size()) * sizeof(double) +
         data::kValues.size_bytes();
}

}  // namespace quickstrip
