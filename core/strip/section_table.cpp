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

// Four nodes or more. x in the second of the three intervals of the four nearest nodes, except at the ends.
ParabolicBlend blend(std::span<const double> nodes, double x) {
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), x);
  const std::size_t right =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, nodes.size() - 1);
  ParabolicBlend result;
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

ParabolicBlend log_h0_blend(double log_h0) {
  // Not across H0 = 1, where the bounds of a3 have a fold.
  std::size_t fold = 0;
  while (fold + 1 < data::kLogH0.size() && data::kLogH0[fold] < 0.0) {
    ++fold;
  }
  if (log_h0 <= 0.0) {
    return blend(data::kLogH0.first(fold + 1), log_h0);
  }
  ParabolicBlend result = blend(data::kLogH0.subspan(fold), log_h0);
  result.first += fold;
  return result;
}

// Only the four nodes that are used are taken to the coordinate of the interpolation.
ParabolicBlend frequency_blend(double kappa) {
  const std::span<const double> nodes = data::kKappa;
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), kappa);
  const std::size_t right =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, nodes.size() - 1);
  const std::size_t first = std::min(right < 2 ? 0 : right - 2, nodes.size() - 4);
  std::array<double, 4> near{};
  for (std::size_t i = 0; i < near.size(); ++i) {
    near[i] = frequency_coordinate(nodes[first + i]);
  }
  ParabolicBlend result = blend(near, frequency_coordinate(kappa));
  result.first += first;
  return result;
}

SectionQuantities interpolate(const SectionTableColumn& column, const ParabolicBlend& frequency,
                              double kappa) {
  SectionQuantities total{};
  const std::size_t num_kappa = data::kKappa.size();
  for (std::size_t j = 0; j < 4; ++j) {
    SectionQuantities sum{};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t section = (column.h0.first + i) * data::kFullness.size() + column.fullness.first + j;
      const std::size_t start = (section * num_kappa + frequency.first) * kNumSectionQuantities;
      const std::span<const float> values = data::kValues.subspan(start, 4 * kNumSectionQuantities);
      for (std::size_t k = 0; k < 4; ++k) {
        const double factor = column.h0.weight[i] * frequency.weight[k];
        for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
          sum[q] += factor * static_cast<double>(values[k * kNumSectionQuantities + q]);
        }
      }
    }
    const AmplitudeDecay decay = amplitude_decay(column.bluntness[j], kappa);
    sum[kHeaveAmplitude] *= decay.heave;
    sum[kSwayAmplitude] *= decay.sway;
    sum[kRollAmplitude] *= decay.roll;
    for (std::size_t q = 0; q < kNumSectionQuantities; ++q) {
      total[q] += column.fullness.weight[j] * column.scales[j][q] * sum[q];
    }
  }
  return total;
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
  const double q = breadth_draught_parameter(h0);
  const double p = fullness(q, section->a3);
  if (!(p <= 1.0 + kBoundTolerance)) {
    return Error::kOutOfRange;
  }
  SectionTableColumn column;
  column.h0 = log_h0_blend(std::log(h0));
  column.fullness = blend(data::kFullness, p);
  for (std::size_t j = 0; j < 4; ++j) {
    const double a3 = a3_of_fullness(q, data::kFullness[column.fullness.first + j]);
    column.scales[j] = quantity_scales(q * (1.0 + a3), a3);
    column.bluntness[j] = waterline_bluntness(q * (1.0 + a3), a3);
  }
  column.lateral_at_infinity = lateral_added_mass_at_infinity(section->a1, section->a3);
  column.heave_at_infinity = heave_added_mass_at_infinity(section->a1, section->a3);
  column.breadth = breadth_in_scale(section->a1, section->a3);
  column.area = area_in_scale(section->a1, section->a3);
  return column;
}

SectionCoefficients section_coefficients(const SectionTableColumn& column, double xi) {
  QS_CHECK(xi >= 0.0 && std::isfinite(xi));
  constexpr double kLeastXiOfHeave = 1e-12;
  const double kappa_per_xi = 2.0 / column.breadth;
  const double kappa = xi * kappa_per_xi;
  const double top = data::kKappa.back();
  const double inside = std::min(kappa, top);
  SectionQuantities v = interpolate(column, frequency_blend(inside), kappa);

  const double for_log = std::max(inside, kLeastXiOfHeave * kappa_per_xi);
  v[kHeaveMass] -= column.breadth * column.breadth / kPi * std::log(for_log / (1.0 + for_log));
  if (kappa > top) {
    // The added masses approach their limits as 1/kappa; the scaled amplitudes keep their last values.
    const double rest = top / kappa;
    v[kHeaveMass] = column.heave_at_infinity + (v[kHeaveMass] - column.heave_at_infinity) * rest;
    const LewisAddedMass& lateral = column.lateral_at_infinity;
    v[kSwayMass] = lateral.a22 + (v[kSwayMass] - lateral.a22) * rest;
    v[kCouplingMass] = lateral.a24 + (v[kCouplingMass] - lateral.a24) * rest;
    v[kRollMass] = lateral.a44 + (v[kRollMass] - lateral.a44) * rest;
  }
  const double h3 = v[kHeaveAmplitude];
  const double h2 = v[kSwayAmplitude];
  const double h4 = v[kRollAmplitude];

  const double root = std::sqrt(xi);  // omega sqrt(B/2g)
  const double by_area = 1.0 / column.area;
  const double by_moment = by_area / column.breadth;
  const double by_inertia = by_moment / column.breadth;
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
