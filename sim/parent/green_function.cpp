#include "sim/parent/green_function.hpp"

#include <array>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// Within this parabola about the negative real axis the power series, which loses exp(8) of its digits at
// most; outside it the continued fraction, which needs 16 steps at most.
constexpr double kSeriesParabola = 8.0;
// Beyond it the asymptotic series reaches rounding before its smallest term is met.
constexpr double kAsymptoticRadius = 40.0;
constexpr std::size_t kMaxTerms = 200;

struct Reciprocals {
  std::array<double, kMaxTerms + 1> value{};
  constexpr Reciprocals() {
    for (std::size_t n = 1; n < value.size(); ++n) {
      value[n] = 1.0 / static_cast<double>(n);
    }
  }
};
constexpr Reciprocals kReciprocals;

// sum over n >= 1 of (-t)^n / (n n!)  ([AbramowitzStegun1964] 5.1.11)
Complex power_sum(Complex t) {
  Complex term = 1.0;
  Complex sum = 0.0;
  for (std::size_t n = 1; n <= kMaxTerms; ++n) {
    const double by = kReciprocals.value[n];
    term *= -t * by;
    const Complex addend = term * by;
    sum += addend;
    if (std::norm(addend) < 1e-33 * std::norm(sum)) {
      break;
    }
  }
  return sum;
}

// e^t E1(t) by the even part of its continued fraction (5.1.22), numerator and denominator by recurrence:
// no division on the way. Its error is about exp(-4 sqrt(n) Re sqrt(t)).
Complex continued_fraction(Complex t, double parabola) {
  const int num = 2 + static_cast<int>(112.0 / parabola);
  Complex before_top = 0.0;
  Complex top = 1.0;
  Complex before_bottom = 1.0;
  Complex bottom = t + 1.0;
  for (int n = 1; n <= num; ++n) {
    const double square = static_cast<double>(n) * n;
    const Complex step = t + (2.0 * n + 1.0);
    const Complex next_top = step * top - square * before_top;
    const Complex next_bottom = step * bottom - square * before_bottom;
    before_top = top;
    before_bottom = bottom;
    top = next_top;
    bottom = next_bottom;
  }
  return top / bottom;
}

// e^t E1(t) ~ sum (-1)^n n! / t^(n+1)  (5.1.51)
Complex asymptotic_series(Complex t) {
  const Complex inverse = 1.0 / t;
  Complex term = inverse;
  Complex sum = term;
  for (int n = 1; n <= static_cast<int>(kAsymptoticRadius); ++n) {
    term *= -static_cast<double>(n) * inverse;
    sum += term;
    if (std::norm(term) < 1e-33 * std::norm(sum)) {
      break;
    }
  }
  return sum;
}

}  // namespace

Complex wave_integral(Complex w, double wave_number, Complex log_minus, Complex wave) {
  const Complex t = wave_number * w;
  const double radius = std::sqrt(std::norm(t));
  const double parabola = radius + t.real();
  if (parabola < kSeriesParabola && radius < kAsymptoticRadius) {
    // E1(t) + i pi = -gamma - ln(-t) - sum: one branch on both sides of the negative axis.
    return wave * (-kEulerGamma - std::log(wave_number) - log_minus - power_sum(t));
  }
  const Complex standing(0.0, t.imag() < 0.0 ? -kPi : kPi);
  return (parabola < kSeriesParabola ? asymptotic_series(t) : continued_fraction(t, parabola)) +
         standing * wave;
}

PointOfChain::PointOfChain(Complex point, const std::vector<Complex>& nodes, int own) : point_(point) {
  for (const Complex node : nodes) {
    const Complex image = point + std::conj(node);
    ends_.push_back({image, std::log(-image)});
  }
  for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
    const Complex step = nodes[j + 1] - nodes[j];
    const Complex direction = step / std::abs(step);
    directions_.push_back(direction);
    const Complex u1 = point - nodes[j];
    const Complex u2 = point - nodes[j + 1];
    const Complex log1 = std::log(u1);
    const Complex turn = std::log(u2 / u1);  // a straight panel is seen under less than pi
    const Complex rise = u2 * (log1 + turn) - u2 - (u1 * log1 - u1);
    const End& e1 = ends_[j];
    const End& e2 = ends_[j + 1];
    const Complex image_rise = e2.image * e2.log_minus - e2.image - (e1.image * e1.log_minus - e1.image);
    const double angle = static_cast<int>(j) == own ? 0.0 : turn.imag();
    fixed_.push_back({-(std::conj(direction) * rise).real() - (direction * image_rise).real(),
                      -angle - (e2.log_minus - e1.log_minus).imag()});
  }
}

void PointOfChain::influence(double wave_number, const std::vector<Complex>& waves,
                             std::vector<PanelInfluence>& out) const {
  out.resize(fixed_.size());
  const Complex here = std::polar(std::exp(wave_number * point_.real()), wave_number * point_.imag());
  const auto at = [&](std::size_t k) {
    return wave_integral(ends_[k].image, wave_number, ends_[k].log_minus, here * std::conj(waves[k]));
  };
  Complex f1 = at(0);
  for (std::size_t j = 0; j < fixed_.size(); ++j) {
    const Complex f2 = at(j + 1);
    const Complex integral = (f2 - f1 + ends_[j + 1].log_minus - ends_[j].log_minus) / wave_number;
    out[j].potential = fixed_[j].potential - 2.0 * (directions_[j] * integral).real();
    out[j].normal = fixed_[j].normal - 2.0 * (f2 - f1).imag();
    f1 = f2;
  }
}

}  // namespace quickstrip
