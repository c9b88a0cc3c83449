#include "sim/section_table/accuracy.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "core/base/check.hpp"
#include "core/strip/section_table.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {
namespace {

using Values = std::array<double, kNumCoefficients>;
constexpr std::array<const char*, kNumCoefficients> kNames = {"a22", "b22", "a33", "b33",
                                                              "a44", "b44", "a24", "b24"};
constexpr double kLeastXi = 0.001;
constexpr double kGreatestXi = 40.0;
constexpr double kFloor = 0.01;

// Uniform on 0 ... 1 with the same bits everywhere, which std::uniform_real_distribution does not promise.
class Uniform {
 public:
  explicit Uniform(std::uint32_t seed) : engine_(seed) {}
  double operator()() { return (static_cast<double>(engine_()) + 0.5) / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

double log_uniform(Uniform& uniform, double from, double to) {
  return from * std::pow(to / from, uniform());
}

// The largest magnitude of each coefficient over frequency, from the table.
Values largest(const SectionTableColumn& column) {
  Values most{};
  for (double xi = kLeastXi; xi <= kGreatestXi; xi *= 1.25) {
    const Values v = as_array(section_coefficients(column, xi));
    for (std::size_t k = 0; k < v.size(); ++k) {
      most[k] = std::max(most[k], std::abs(v[k]));
    }
  }
  return most;
}

Values scales_of(const Values& exact, const Values& most) {
  Values scale{};
  for (std::size_t k = 0; k < scale.size(); ++k) {
    scale[k] = std::max(std::abs(exact[k]), kFloor * most[k]);
  }
  // 44 and 24 (added mass, damping) against the mean of 22 and 44.
  const double mass_mean = std::sqrt(scale[0] * scale[4]);
  const double damping_mean = std::sqrt(scale[1] * scale[5]);
  scale[4] = std::max(scale[4], mass_mean);
  scale[5] = std::max(scale[5], damping_mean);
  scale[6] = mass_mean;
  scale[7] = damping_mean;
  return scale;
}

SectionSolution refined(const LewisSection& section, double kappa) {
  const SectionSolution first = solve_lewis_form_adaptive(section.a1, section.a3, kappa);
  const int more = std::min(first.num_multipoles * 3 / 2, kMaxMultipoles);
  SectionSolution second = solve_lewis_form(section.a1, section.a3, kappa, more);
  second.converged = first.converged;
  return second;
}

}  // namespace

Values as_array(const SectionCoefficients& c) {
  return {c.a22, c.b22, c.a33, c.b33, c.a44, c.b44, c.a24, c.b24};
}

const char* coefficient_name(std::size_t k) {
  return kNames.at(k);
}

AccuracyStudy measure_accuracy(SectionRegion region, int num_points, std::uint32_t seed) {
  constexpr double kWidening = 1.05;
  AccuracyStudy study;
  Values worst{};
  Uniform uniform(seed);
  for (int i = 0; i < num_points; ++i) {
    const double h0 = log_uniform(uniform, kMinTabulatedH0, kMaxTabulatedH0);
    const double divide = std::min(kWidening * conventional_limit(h0), upper_limit(h0));
    const double low = region == SectionRegion::kPractical ? reentrant_limit(h0) : divide;
    const double high = region == SectionRegion::kPractical ? divide : upper_limit(h0);
    const double sigma = low + (high - low) * uniform();
    const double xi = log_uniform(uniform, kLeastXi, kGreatestXi);
    const Result<LewisSection> section = lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma);
    const Result<SectionTableColumn> column = section_table_column(h0, sigma);
    QS_CHECK(section.ok() && column.ok());
    const SectionSolution solution = refined(*section, kappa_of_xi(*section, xi));
    study.not_converged += solution.converged ? 0 : 1;
    const Values exact = as_array(normalised(*section, xi, solution));
    const Values table = as_array(section_coefficients(*column, xi));
    const Values scale = scales_of(exact, largest(*column));
    for (std::size_t k = 0; k < kNumCoefficients; ++k) {
      const double error = std::abs(table[k] - exact[k]) / scale[k];
      study.errors[k].push_back(error);
      if (error > worst[k]) {
        worst[k] = error;
        study.worst_h0[k] = h0;
        study.worst_sigma[k] = sigma;
        study.worst_xi[k] = xi;
      }
    }
  }
  for (std::vector<double>& errors : study.errors) {
    std::sort(errors.begin(), errors.end());
  }
  return study;
}

double quantile(const std::vector<double>& sorted, double share) {
  QS_CHECK(!sorted.empty());
  const double position = share * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(position))];
}

void print_accuracy(const AccuracyStudy& study, const char* title, std::ostream& out) {
  fmt::print(out, "{}: {} points, {} not converged; error in %\n", title, study.errors[0].size(),
             study.not_converged);
  fmt::print(out, "      median    90 %    99 %   worst   at H0   sigma        xi\n");
  for (std::size_t k = 0; k < kNumCoefficients; ++k) {
    const std::vector<double>& e = study.errors[k];
    fmt::print(out, "{} {:8.4f}{:8.4f}{:8.4f}{:8.3f}{:8.3f}{:8.3f} {:9.4g}\n", kNames[k],
               100.0 * quantile(e, 0.5), 100.0 * quantile(e, 0.9), 100.0 * quantile(e, 0.99),
               100.0 * quantile(e, 1.0), study.worst_h0[k], study.worst_sigma[k], study.worst_xi[k]);
  }
}

}  // namespace quickstrip
