#include "sim/section_table/accuracy.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <random>

#include "core/base/check.hpp"
#include "core/strip/section_table.hpp"
#include "sim/section_table/lagrange_table.hpp"
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
  const LagrangeTable lagrange_table;
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
    const Result<LagrangeColumn> lagrange_column = lagrange_table.column(h0, sigma);
    QS_CHECK(section.ok() && column.ok() && lagrange_column.ok());
    const SectionSolution solution = refined(*section, kappa_of_xi(*section, xi));
    study.not_converged += solution.converged ? 0 : 1;
    const Values exact = as_array(normalised(*section, xi, solution));
    const Values spline = as_array(section_coefficients(*column, xi));
    const Values lagrange = as_array(section_coefficients(*lagrange_column, xi));
    const Values scale = scales_of(exact, largest(*column));
    for (std::size_t k = 0; k < kNumCoefficients; ++k) {
      const double error = std::abs(spline[k] - exact[k]) / scale[k];
      study.spline[k].push_back(error);
      study.lagrange[k].push_back(std::abs(lagrange[k] - exact[k]) / scale[k]);
      if (error > worst[k]) {
        worst[k] = error;
        study.worst_h0[k] = h0;
        study.worst_sigma[k] = sigma;
        study.worst_xi[k] = xi;
      }
    }
  }
  for (std::size_t k = 0; k < kNumCoefficients; ++k) {
    std::sort(study.spline[k].begin(), study.spline[k].end());
    std::sort(study.lagrange[k].begin(), study.lagrange[k].end());
  }
  return study;
}

double quantile(const std::vector<double>& sorted, double share) {
  QS_CHECK(!sorted.empty());
  const double position = share * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(position))];
}

void print_accuracy(const AccuracyStudy& study, const char* title, std::ostream& out) {
  fmt::print(out, "{}: {} points, {} not converged; error in %\n", title, study.spline[0].size(),
             study.not_converged);
  fmt::print(out,
             "                  cubic spline             second-degree Lagrange     the spline's worst at\n");
  fmt::print(
      out,
      "      median    90 %    99 %   worst  median    90 %    99 %   worst      H0   sigma        xi\n");
  for (std::size_t k = 0; k < kNumCoefficients; ++k) {
    fmt::print(out, "{} ", kNames[k]);
    for (const std::vector<double>& e : {study.spline[k], study.lagrange[k]}) {
      fmt::print(out, "{:8.4f}{:8.4f}{:8.4f}{:8.3f}", 100.0 * quantile(e, 0.5), 100.0 * quantile(e, 0.9),
                 100.0 * quantile(e, 0.99), 100.0 * quantile(e, 1.0));
    }
    fmt::print(out, "{:8.3f}{:8.3f} {:9.4g}\n", study.worst_h0[k], study.worst_sigma[k], study.worst_xi[k]);
  }
}

namespace {

// Of one call, which gets the number of the call; the least of several rounds.
template <typename Call>
double nanoseconds(const Call& call) {
  constexpr int kRounds = 10;
  constexpr int kCalls = 20'000;
  double least = 1e9;
  double sum = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kCalls; ++i) {
      sum += call(static_cast<double>(i) / kCalls);
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count() / kCalls);
  }
  QS_CHECK(std::isfinite(sum));  // and so it has to be computed
  return least;
}

}  // namespace

void print_times(std::ostream& out) {
  const LagrangeTable lagrange;
  const auto h0 = [](double share) { return 0.5 + 3.0 * share; };
  constexpr double kSigma = 0.9;
  const double spline_column =
      nanoseconds([&](double share) { return section_table_column(h0(share), kSigma)->form.area; });
  const double lagrange_column =
      nanoseconds([&](double share) { return lagrange.column(h0(share), kSigma)->form.area; });
  const SectionTableColumn by_spline = *section_table_column(h0(0.0), kSigma);
  const LagrangeColumn by_lagrange = *lagrange.column(h0(0.0), kSigma);
  const double spline =
      nanoseconds([&](double share) { return section_coefficients(by_spline, 0.1 + 5.0 * share).b33; });
  const double lagrange_one =
      nanoseconds([&](double share) { return section_coefficients(by_lagrange, 0.1 + 5.0 * share).b33; });
  fmt::print(out, "a section's column: spline {:.0f} ns, Lagrange {:.0f} ns; ", spline_column,
             lagrange_column);
  fmt::print(out, "its coefficients at a frequency: spline {:.0f} ns, Lagrange {:.0f} ns\n", spline,
             lagrange_one);
}

}  // namespace quickstrip
