// Numbers that are kept for long, not worked with: in double precision where there is memory, in single where
// there is little (capacity.hpp, kHoldsSinglePrecision). Single rounds a value by 6e-8 of itself when it is
// put away; every sum and product is still one of doubles.
#pragma once

#include <complex>
#include <type_traits>

#include "core/base/capacity.hpp"

namespace quickstrip {

/// Reads as the double that it stands for.
class Single {
 public:
  constexpr Single() = default;
  constexpr Single(double value) : value_(static_cast<float>(value)) {}      // NOLINT: meant to be implicit
  constexpr operator double() const { return static_cast<double>(value_); }  // NOLINT: the same

 private:
  float value_ = 0.0F;
};

class SingleComplex {
 public:
  constexpr SingleComplex() = default;
  constexpr SingleComplex(const std::complex<double>& z) : re_(z.real()), im_(z.imag()) {}  // NOLINT
  constexpr operator std::complex<double>() const { return {re_, im_}; }                    // NOLINT

 private:
  Single re_;
  Single im_;
};

// What overload resolution does not find by itself.
constexpr double operator*(double a, Single b) {
  return a * static_cast<double>(b);
}
constexpr std::complex<double> operator*(const std::complex<double>& a, Single b) {
  return a * static_cast<double>(b);
}
constexpr std::complex<double> operator*(const std::complex<double>& a, SingleComplex b) {
  return a * static_cast<std::complex<double>>(b);
}
constexpr std::complex<double> operator*(double a, SingleComplex b) {
  return a * static_cast<std::complex<double>>(b);
}

using Held = std::conditional_t<kHoldsSinglePrecision, Single, double>;
using HeldComplex = std::conditional_t<kHoldsSinglePrecision, SingleComplex, std::complex<double>>;

}  // namespace quickstrip
