#include "core/advice/ensemble.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kStrata = 16;
constexpr std::size_t kNumQuantities = 3 * kMaxWaveSystems + 2;
constexpr double kLeastFactor = 0.2;
constexpr double kSoftest = -0.9;  // of c44: a member floats upright

// Standard normal quantiles at (i + 1/2) / 16, i = 8 ... 15, and the standard deviation of the sixteen.
constexpr std::array<double, kStrata / 2> kUpperQuantiles{0.0784124, 0.2372021, 0.4022501, 0.5791322,
                                                          0.7764218, 1.0099902, 1.3180109, 1.8627319};
constexpr double kDeviation = 0.9610850;

using Order = std::array<std::uint8_t, kStrata>;

/// Fisher-Yates with a linear congruential generator (Knuth's MMIX constants): one fixed order a quantity.
constexpr std::array<Order, kNumQuantities> make_orders() {
  std::array<Order, kNumQuantities> orders{};
  std::uint64_t state = 1992;
  for (Order& order : orders) {
    for (std::size_t i = 0; i < kStrata; ++i) {
      order[i] = static_cast<std::uint8_t>(i);
    }
    for (std::size_t i = kStrata - 1; i > 0; --i) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      const auto j = static_cast<std::size_t>((state >> 33U) % (i + 1));
      const std::uint8_t kept = order[i];
      order[i] = order[j];
      order[j] = kept;
    }
  }
  return orders;
}

constexpr std::array<Order, kNumQuantities> kOrders = make_orders();

/// Standard normal, of the quantity numbered `quantity`.
double draw(std::size_t k, std::size_t quantity) {
  const std::size_t stratum = kOrders[quantity][k % kStrata];
  constexpr std::size_t kHalf = kStrata / 2;
  return (stratum < kHalf ? -kUpperQuantiles[kHalf - 1 - stratum] : kUpperQuantiles[stratum - kHalf]) /
         kDeviation;
}

double factor(double drawn, double part) {
  return std::max(kLeastFactor, 1.0 + part * drawn);
}

}  // namespace

double height_deviation(const Uncertainty& uncertainty, std::span<const WaveSystem> systems) {
  double energy = 0.0;
  double square = 0.0;
  for (std::size_t s = 0; s < systems.size(); ++s) {
    const double of_system = systems[s].hs * systems[s].hs;
    const double deviation = of_system * uncertainty.height_part[s];  // half that of the energy
    energy += of_system;
    square += deviation * deviation;
  }
  return energy > 0.0 ? std::sqrt(square) / energy : 0.0;
}

EnsembleMember draw_member(std::size_t k, const Uncertainty& uncertainty, double gm) {
  QS_CHECK(gm > 0.0);
  EnsembleMember member;
  std::size_t quantity = 0;
  for (std::size_t s = 0; s < kMaxWaveSystems; ++s) {
    member.height_factor[s] = factor(draw(k, quantity++), uncertainty.height_part[s]);
    member.period_factor[s] = factor(draw(k, quantity++), uncertainty.period_part[s]);
    member.turned[s] = uncertainty.direction[s] * draw(k, quantity++);
  }
  member.roll.stiffness_part = std::max(kSoftest, draw(k, quantity++) * uncertainty.gm / gm);
  member.roll.damping_factor = factor(draw(k, quantity), uncertainty.roll_damping_part);
  return member;
}

void shift_sea(const EnsembleMember& member, const SeaState& sea, SeaState& out) {
  out = sea;
  for (std::size_t s = 0; s < out.systems.size(); ++s) {
    out.systems[s].hs *= member.height_factor[s];
    out.systems[s].period *= member.period_factor[s];
    out.systems[s].from.radians = wrap_two_pi(out.systems[s].from.radians + member.turned[s]);
  }
}

void shift_sea(const EnsembleMember& member, const DirectionalSpectrum& sea, DirectionalSpectrum& out) {
  out.frequencies = sea.frequencies;
  out.directions = sea.directions;
  for (double& omega : out.frequencies) {
    omega /= member.period_factor[0];
  }
  for (double& direction : out.directions) {
    direction += member.turned[0];
  }
  // As much energy a band, times the height factor squared, on a band narrower by the period factor.
  const double scale = member.height_factor[0] * member.height_factor[0] * member.period_factor[0];
  for (std::size_t f = 0; f < sea.frequencies.size(); ++f) {
    for (std::size_t d = 0; d < sea.directions.size(); ++d) {
      out.density[f][d] = scale * sea.density[f][d];
    }
  }
}

}  // namespace quickstrip
