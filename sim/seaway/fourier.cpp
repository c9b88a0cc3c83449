#include "sim/seaway/fourier.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"

namespace quickstrip::seaway {
namespace {

bool is_power_of_two(std::size_t n) {
  return n != 0 && (n & (n - 1)) == 0;
}

}  // namespace

Fourier::Fourier(std::size_t num_samples)
    : num_samples_(num_samples),
      cosine_(num_samples / 2),
      sine_(num_samples / 2),
      re_(num_samples),
      im_(num_samples),
      re_next_(num_samples),
      im_next_(num_samples) {
  QS_CHECK(num_samples >= 4 && is_power_of_two(num_samples));
  for (std::size_t p = 0; p < num_samples / 2; ++p) {
    const double angle = kTwoPi * static_cast<double>(p) / static_cast<double>(num_samples);
    cosine_[p] = std::cos(angle);
    sine_[p] = std::sin(angle);
  }
}

void Fourier::transform() {
  std::size_t stride = 1;
  for (std::size_t half = num_samples_ / 2; half > 0; half /= 2, stride *= 2) {
    for (std::size_t p = 0; p < half; ++p) {
      const double c = cosine_[p * stride];
      const double s = sine_[p * stride];
      const double* const a_re = re_.data() + stride * p;
      const double* const a_im = im_.data() + stride * p;
      const double* const b_re = a_re + stride * half;
      const double* const b_im = a_im + stride * half;
      double* const sum_re = re_next_.data() + 2 * stride * p;
      double* const sum_im = im_next_.data() + 2 * stride * p;
      double* const turned_re = sum_re + stride;
      double* const turned_im = sum_im + stride;
      for (std::size_t q = 0; q < stride; ++q) {
        const double d_re = a_re[q] - b_re[q];
        const double d_im = a_im[q] - b_im[q];
        sum_re[q] = a_re[q] + b_re[q];
        sum_im[q] = a_im[q] + b_im[q];
        turned_re[q] = d_re * c - d_im * s;
        turned_im[q] = d_re * s + d_im * c;
      }
    }
    re_.swap(re_next_);
    im_.swap(im_next_);
  }
}

void Fourier::series(std::span<const Complex> first, std::span<const Complex> second, std::span<double> x,
                     std::span<double> y) {
  const std::size_t n = num_samples_;
  QS_CHECK(first.size() <= n / 2 && second.size() <= n / 2);
  QS_CHECK(x.size() == n && (y.empty() || y.size() == n));
  std::fill(re_.begin(), re_.end(), 0.0);
  std::fill(im_.begin(), im_.end(), 0.0);
  // A real series has conj(X) at -n: x in the real part, y in the imaginary part.
  for (std::size_t k = 0; k < first.size(); ++k) {
    const std::size_t mirror = k == 0 ? 0 : n - k;
    re_[k] += 0.5 * first[k].real();
    im_[k] += 0.5 * first[k].imag();
    re_[mirror] += 0.5 * first[k].real();
    im_[mirror] -= 0.5 * first[k].imag();
  }
  for (std::size_t k = 0; k < second.size(); ++k) {
    const std::size_t mirror = k == 0 ? 0 : n - k;
    re_[k] -= 0.5 * second[k].imag();
    im_[k] += 0.5 * second[k].real();
    re_[mirror] += 0.5 * second[k].imag();
    im_[mirror] += 0.5 * second[k].real();
  }
  transform();
  std::copy(re_.begin(), re_.end(), x.begin());
  if (!y.empty()) {
    std::copy(im_.begin(), im_.end(), y.begin());
  }
}

void Fourier::amplitudes(std::span<const double> x, std::span<Complex> out) {
  const std::size_t n = num_samples_;
  QS_CHECK(x.size() == n && out.size() <= n / 2);
  std::copy(x.begin(), x.end(), re_.begin());
  std::fill(im_.begin(), im_.end(), 0.0);
  transform();  // conj of the forward transform of a real series
  const double scale = 2.0 / static_cast<double>(n);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = (k == 0 ? 0.5 : 1.0) * scale * Complex(re_[k], -im_[k]);
  }
}

}  // namespace quickstrip::seaway
