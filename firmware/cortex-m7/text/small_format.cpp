#include "firmware/cortex-m7/text/small_format.hpp"

#include <cmath>

namespace quickstrip::small_format {
namespace {

constexpr std::array<std::uint64_t, 4> kPowersOfTen{1, 10, 100, 1000};
constexpr int kMantissaBits = 53;
constexpr double kTwoTo53 = 9007199254740992.0;

/// number / 2^shift, to the nearest, ties to even.
std::uint64_t shift_rounded(std::uint64_t number, int shift) {
  if (shift >= 64) {
    return 0;  // below a half: number < 2^63
  }
  const std::uint64_t whole = number >> shift;
  const std::uint64_t rest = number - (whole << shift);
  const std::uint64_t half = std::uint64_t{1} << (shift - 1);
  const bool is_up = rest > half || (rest == half && whole % 2 == 1);
  return whole + (is_up ? 1 : 0);
}

/// value x 10^decimals as an integer. 0 <= value < 2^53.
std::uint64_t scaled(double value, unsigned decimals) {
  const std::uint64_t power = kPowersOfTen[decimals];
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);  // [0.5, 1), or 0
  if (exponent <= 0) {
    return shift_rounded(static_cast<std::uint64_t>(mantissa * kTwoTo53) * power, kMantissaBits - exponent);
  }
  // Halves count by the last digit, which is even or not with the whole part's when there are no decimals.
  const auto whole = static_cast<std::uint64_t>(value);
  const double fraction = value - static_cast<double>(whole);  // exact, a multiple of 2^-52
  const auto of_fraction = static_cast<std::uint64_t>(fraction * kTwoTo53) * power;
  if (decimals == 0) {
    const bool is_up = fraction > 0.5 || (fraction == 0.5 && whole % 2 == 1);
    return whole + (is_up ? 1 : 0);
  }
  return whole * power + shift_rounded(of_fraction, kMantissaBits);
}

/// At least `least` digits.
void put_digits(Writer& out, std::uint64_t number, unsigned least) {
  std::array<char, 20> digits{};
  std::size_t n = 0;
  do {
    digits[n++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (n < digits.size() && (number != 0 || n < least));
  while (n > 0) {
    out.put(digits[--n]);
  }
}

}  // namespace

void write(Writer& out, const Field& field, double value) {
  unsigned width = field.width;
  if (std::signbit(value)) {
    out.put('-');
    width -= width > 0 ? 1u : 0u;
  }
  const double size = std::fabs(value);
  if (!(size < kTwoTo53)) {
    return out.put(std::isnan(value) ? "nan" : "inf");
  }
  const std::uint64_t power = kPowersOfTen[field.decimals];
  const std::uint64_t number = scaled(size, field.decimals);
  const unsigned behind = field.decimals > 0 ? field.decimals + 1 : 0;
  put_digits(out, number / power, width > behind ? width - behind : 1);
  if (field.decimals > 0) {
    out.put('.');
    put_digits(out, number % power, field.decimals);
  }
}

void write(Writer& out, const Field& /*field*/, std::int64_t value) {
  const bool is_negative = value < 0;
  if (is_negative) {
    out.put('-');
  }
  const auto bits = static_cast<std::uint64_t>(value);
  put_digits(out, is_negative ? std::uint64_t{0} - bits : bits, 1);
}

Field next_field(std::string_view format, std::size_t& at, Writer& out) {
  while (at < format.size()) {
    const char c = format[at++];
    if (c == '{') {
      return parse_field(format, at);
    }
    out.put(c);
  }
  return {};
}

}  // namespace quickstrip::small_format
