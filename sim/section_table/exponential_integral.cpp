#include "sim/section_table/exponential_integral.hpp"

#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// Beyond it the asymptotic series reaches rounding before its smallest term (about the |t|-th) is met.
constexpr double kAsymptoticRadius = 40.0;
// The power series loses about exp(|t| + Re t) in cancellation: this bound costs two digits at most. Inside
// it lies the negative real axis, near which the continued fraction does not converge.
constexpr double kSeriesParabola = 4.0;
constexpr int kMaxTerms = 500;

// [AbramowitzStegun1964] 5.1.11: E1(t) = -gamma - ln t - sum (-t)^n / (n n!)
Complex power_series(Complex t) {
  Complex term = 1.0;
  Complex sum = 0.0;
  for (int n = 1; n <= kMaxTerms; ++n) {
    term *= -t / static_cast<double>(n);
    const Complex addend = term / static_cast<double>(n);
    sum += addend;
    if (std::norm(addend) < 1e-34 * std::norm(sum)) {
      break;
    }
  }
  // +0.0 turns a negative zero into the limit from above.
  const Complex above(t.real(), t.imag() + 0.0);
  return std::exp(t) * (-kEulerGamma - std::log(above) - sum);
}

// [AbramowitzStegun1964] 5.1.51: e^t E1(t) ~ sum (-1)^n n! / t^(n+1)
Complex asymptotic_series(Complex t) {
  Complex term = 1.0 / t;
  Complex sum = term;
  for (int n = 1; n <= static_cast<int>(kAsymptoticRadius); ++n) {
    term *= -static_cast<double>(n) / t;
    sum += term;
    if (std::norm(term) < 1e-34 * std::norm(sum)) {
      break;
    }
  }
  return sum;
}

// [AbramowitzStegun1964] 5.1.22 in its even part, by the modified Lentz method:
// e^t E1(t) = 1/(t+1 - 1/(t+3 - 4/(t+5 - 9/(t+7 - ...
Complex continued_fraction(Complex t) {
  constexpr double kTiny = 1e-300;
  Complex b = t + 1.0;
  Complex c = 1.0 / kTiny;
  Complex d = 1.0 / b;
  Complex h = d;
  for (int n = 1; n <= kMaxTerms; ++n) {
    const double a = -static_cast<double>(n) * n;
    b += 2.0;
    d = 1.0 / (a * d + b);
    c = b + a / c;
    const Complex factor = c * d;
    h *= factor;
    if (std::norm(factor - 1.0) < 1e-32) {
      break;
    }
  }
  return h;
}

}  // namespace

Complex scaled_exponential_integral(Complex t) {
  const double radius = std::abs(t);
  if (radius > kAsymptoticRadius) {
    return asymptotic_series(t);
  }
  return radius + t.real() < kSeriesParabola ? power_series(t) : continued_fraction(t);
}

}  // namespace quickstrip
