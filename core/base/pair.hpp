// Two doubles side by side, which one instruction works on where the machine has such, and two where not: the
// same bits everywhere, for each lane is ordinary arithmetic. Holds a complex number, or one real quantity of
// two waves or two speeds. GCC's and clang's vector extension; no intrinsics.
#pragma once

#include <complex>

namespace quickstrip {

using Pair = double __attribute__((vector_size(16)));

inline Pair pair_of(double first, double second) {
  return Pair{first, second};
}
inline Pair both(double value) {
  return Pair{value, value};
}
inline Pair pair_of(const std::complex<double>& z) {
  return Pair{z.real(), z.imag()};
}
inline std::complex<double> complex_of(Pair z) {
  return {z[0], z[1]};
}

/// i z of a complex number.
inline Pair times_i(Pair z) {
  return Pair{-z[1], z[0]};
}

/// Two complex numbers, of two waves or two speeds.
struct ComplexPair {
  Pair re{};
  Pair im{};
};

inline ComplexPair operator+(const ComplexPair& a, const ComplexPair& b) {
  return {a.re + b.re, a.im + b.im};
}
inline ComplexPair operator-(const ComplexPair& a, const ComplexPair& b) {
  return {a.re - b.re, a.im - b.im};
}
inline ComplexPair operator-(const ComplexPair& a) {
  return {-a.re, -a.im};
}
inline ComplexPair operator*(const ComplexPair& a, const ComplexPair& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline ComplexPair operator*(Pair a, const ComplexPair& b) {
  return {a * b.re, a * b.im};
}
inline ComplexPair inverse(const ComplexPair& a) {
  const Pair by_square = 1.0 / (a.re * a.re + a.im * a.im);
  return {a.re * by_square, -a.im * by_square};
}
inline std::complex<double> lane(const ComplexPair& a, int which) {
  return {a.re[which], a.im[which]};
}

}  // namespace quickstrip
