#include "core/response/heading_convolution.hpp"

#include <algorithm>

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;
// Of the largest variance on any heading: below it lies the rounding of the transforms.
constexpr double kRounding = 1e-13;

/// One wave number of transformed integrals, by band.
using BandRow = std::array<double, kBandWidth>;

void read_row(const SweepColumns& columns, std::size_t first_block, std::size_t column, std::size_t count,
              std::size_t k, BandRow& out) {
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t c = column + b;
    out[b] = columns.block[first_block + c / kTransformBlock][k][c % kTransformBlock];
  }
}

// Of the bands of one system: four partial sums, then what fills no group of four.
double band_dot(const BandRow& row, const BandRow& factor, std::size_t first, std::size_t count) {
  std::array<double, kTransformBlock> sums{};
  const std::size_t whole = count / kTransformBlock * kTransformBlock;
  for (std::size_t b = 0; b < whole; b += kTransformBlock) {
    for (std::size_t j = 0; j < kTransformBlock; ++j) {
      sums[j] += row[b + j] * factor[first + b + j];
    }
  }
  for (std::size_t b = whole; b < count; ++b) {
    sums[0] += row[b] * factor[first + b];
  }
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

/// Variances below the rounding of the largest are none; a NaN stays one.
void drop_rounding(ByHeading& values) {
  const double largest = std::max(0.0, *std::max_element(values.begin(), values.end()));
  for (double& value : values) {
    value = value < kRounding * largest ? 0.0 : value;
  }
}

// add_product() of a system that is one band, as every parametric one is.
void add_band_product(const SystemEnergy& part, const SweepColumns& columns, const ColumnPlace& from,
                      std::size_t to, HeadingColumns& out) {
  const auto block_of = [&](std::size_t first, std::size_t column) -> const ColumnBlock& {
    return columns.block[first + column / kTransformBlock];
  };
  const std::size_t even_column = from.even + part.first;
  const std::size_t odd_column = from.odd + part.first;
  const ColumnBlock& even = block_of(0, even_column);
  const ColumnBlock& odd = from.has_sides ? block_of(columns.first_odd(), odd_column) : even;
  const double side = from.has_sides ? 1.0 : 0.0;
  ColumnBlock& cosine = out.cosine[to / kTransformBlock];
  ColumnBlock& sine = out.sine[to / kTransformBlock];
  const std::size_t lane = to % kTransformBlock;
  for (std::size_t k = 0; k <= kHalf; ++k) {
    const double re = part.cosine[k][part.first];
    const double im = part.sine[k][part.first];
    const double c = even[k][even_column % kTransformBlock];
    const double s = side * odd[k][odd_column % kTransformBlock];
    cosine[k][lane] += c * re - s * im;
    sine[k][lane] += c * im + s * re;
  }
}

}  // namespace

void transform_columns(SweepColumns& columns) {
  for (std::size_t i = 0; i < columns.num_even; ++i) {
    cosine_transform(columns.block[i], kTransformBlock, columns.block[i]);
  }
  for (std::size_t i = columns.first_odd(); i < kSweepBlocks; ++i) {
    sine_transform(columns.block[i], kTransformBlock, columns.block[i]);
  }
}

// (C - i S) of the response times (c - i s) of the factors.
void add_product(const SystemEnergy& part, const SweepColumns& columns, const ColumnPlace& from,
                 std::size_t to, HeadingColumns& out) {
  if (part.count == 1) {
    add_band_product(part, columns, from, to, out);
    return;
  }
  const std::size_t block = to / kTransformBlock;
  const std::size_t lane = to % kTransformBlock;
  BandRow even;
  BandRow odd;
  for (std::size_t k = 0; k <= kHalf; ++k) {
    read_row(columns, 0, from.even + part.first, part.count, k, even);
    double re = band_dot(even, part.cosine[k], part.first, part.count);
    double im = band_dot(even, part.sine[k], part.first, part.count);  // minus the imaginary part
    if (from.has_sides) {
      read_row(columns, columns.first_odd(), from.odd + part.first, part.count, k, odd);
      re -= band_dot(odd, part.sine[k], part.first, part.count);
      im += band_dot(odd, part.cosine[k], part.first, part.count);
    }
    out.cosine[block][k][lane] += re;
    out.sine[block][k][lane] += im;
  }
}

void clear(std::size_t count, HeadingColumns& out) {
  for (std::size_t i = 0; i < blocks_of(count); ++i) {
    out.cosine[i] = {};
    out.sine[i] = {};
  }
}

void turn_back(std::size_t count, HeadingColumns& columns) {
  for (std::size_t i = 0; i < blocks_of(count); ++i) {
    cosine_transform(columns.cosine[i], kTransformBlock, columns.cosine[i]);
    sine_transform(columns.sine[i], kTransformBlock, columns.sine[i]);
  }
}

void read_headings(const HeadingColumns& columns, std::size_t column, double scale, ByHeading& out) {
  const double by_count = scale / static_cast<double>(kNumDirections);
  const ColumnBlock& even = columns.cosine[column / kTransformBlock];
  const ColumnBlock& odd = columns.sine[column / kTransformBlock];
  const std::size_t lane = column % kTransformBlock;
  for (std::size_t n = 0; n < kNumDirections; ++n) {
    const std::size_t m = n <= kHalf ? n : kNumDirections - n;
    const double sided = n <= kHalf ? odd[m][lane] : -odd[m][lane];
    out[(n + kHalf) % kNumDirections] = by_count * (even[m][lane] + sided);
  }
}

void read_moment(const HeadingColumns& columns, std::size_t column, ByHeading& out) {
  read_headings(columns, column, 1.0, out);
  drop_rounding(out);
}

}  // namespace quickstrip
