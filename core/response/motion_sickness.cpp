#include "core/response/motion_sickness.hpp"

#include <cmath>
#include <limits>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

constexpr double kSecondsPerMinute = 60.0;
constexpr double kMeanOfRms = 0.79788456080286536;  // sqrt(2/pi): mean |x| of a Gaussian x
constexpr double kSqrtHalf = 0.70710678118654752;

double phi(double x) {
  return 0.5 * std::erfc(-x * kSqrtHalf);
}

/// Slope of log phi.
double log_phi_slope(double x) {
  constexpr double kDensityAtZero = 0.39894228040143268;  // 1/sqrt(2 pi)
  return kDensityAtZero * std::exp(-0.5 * x * x) / phi(x);
}

/// The incidence as phi(x), times phi(slope x + offset) if the time counts; x grows with log10 a.
struct Incidence {
  double x = 0.0;
  double x_per_decade = 1.0;
  bool has_time = false;
  double slope = 0.0;
  double offset = 0.0;

  [[nodiscard]] double second(double at) const { return slope * at + offset; }
  [[nodiscard]] double share(double at) const { return phi(at) * (has_time ? phi(second(at)) : 1.0); }
  [[nodiscard]] double log_slope(double at) const {
    return log_phi_slope(at) + (has_time ? slope * log_phi_slope(second(at)) : 0.0);
  }
};

/// Moving, so that logarithms are finite.
Incidence incidence(const VerticalShaking& shaking, double exposure) {
  const double log_a = std::log10(kMeanOfRms * shaking.rms_acceleration / kStandardGravity);
  if (exposure > 0.0) {  // McCauley et al. (1976)
    constexpr double kSigmaA = 0.47;
    constexpr double kMuT = 1.46;
    constexpr double kSigmaT = 0.76;
    constexpr double kRho = -0.75;
    const double log_f = std::log10(shaking.frequency / kTwoPi);
    const double mu_a = 0.87 + 4.36 * log_f + 2.73 * log_f * log_f;
    const double rest = std::sqrt(1.0 - kRho * kRho);
    const double z_t = (std::log10(exposure / kSecondsPerMinute) - kMuT) / kSigmaT;
    return {(log_a - mu_a) / kSigmaA, 1.0 / kSigmaA, true, -kRho / rest, z_t / rest};
  }
  constexpr double kSigma = 0.4;  // O'Hanlon and McCauley (1974)
  const double log_omega = std::log10(shaking.frequency);
  const double mu = -0.819 + 2.32 * log_omega * log_omega;
  return {(log_a - mu) / kSigma, 1.0 / kSigma};
}

bool moves(const VerticalShaking& shaking) {
  return shaking.rms_acceleration > 0.0 && shaking.frequency > 0.0;
}

/// x at which the share is `limit`. The logarithm of the share is concave in x: after one step Newton comes
/// up to the root from below. The start is steep, so that the first step is short.
double reached_at(const Incidence& model, double limit) {
  constexpr int kMostSteps = 60;
  constexpr double kEnough = 1e-13;
  double x = -3.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double step = (std::log(limit) - std::log(model.share(x))) / model.log_slope(x);
    x += step;
    if (!(std::fabs(step) > kEnough)) {
      break;
    }
  }
  return x;
}

}  // namespace

double motion_sickness(const VerticalShaking& shaking, double exposure) {
  if (!moves(shaking)) {
    return 0.0;
  }
  const Incidence model = incidence(shaking, exposure);
  return model.share(model.x);
}

double motion_sickness_margin(const VerticalShaking& shaking, double exposure, double limit) {
  if (!moves(shaking)) {
    return std::numeric_limits<double>::infinity();
  }
  const Incidence model = incidence(shaking, exposure);
  return std::pow(10.0, (reached_at(model, limit) - model.x) / model.x_per_decade);
}

Channel motion_sickness_channel(const Channel& acceleration, double gravity) {
  return {.quantity = Quantity::kMotionSickness,
          .place = acceleration.place,
          .role = acceleration.role,
          .position = acceleration.position,
          .form = linear_form(Quantity::kVelocityZ, acceleration.position, gravity),
          .is_rate = true};
}

VerticalShaking vertical_shaking(double m0, double m2) {
  return {std::sqrt(m2), m0 > 0.0 ? std::sqrt(m2 / m0) : 0.0};
}

}  // namespace quickstrip
