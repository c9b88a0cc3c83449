// From relative directions to headings: the second step of heading_moments.hpp. The columns of
// heading_integrals.hpp, transformed over direction, times what each wave system takes of a band, and back.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/capacity.hpp"
#include "core/base/direction_transform.hpp"
#include "core/response/heading_integrals.hpp"
#include "core/sea/sea_energy.hpp"

namespace quickstrip {

using ByHeading = std::array<double, kNumDirections>;

/// Columns of one channel on the way back: of each level of roll damping the first moment by system, then
/// every other moment of all systems together.
inline constexpr std::size_t kMaxHeadingColumns = kRollDampingLevels * (kMaxWaveSystems + 2);
struct HeadingColumns {
  using Blocks = std::array<ColumnBlock, (kMaxHeadingColumns + kTransformBlock - 1) / kTransformBlock>;
  Blocks cosine{};  // by wave number; after turning back by direction, even and odd
  Blocks sine{};
};

/// All columns over direction, in place.
void transform_columns(SweepColumns& columns);

/// Factors of a system times transformed integrals from columns `even` and, of a channel with sides, `odd`,
/// added to a column; both are counted from their first block.
struct ColumnPlace {
  std::size_t even = 0;
  std::size_t odd = 0;
  bool has_sides = false;
};
void add_product(const SystemEnergy& part, const SweepColumns& columns, const ColumnPlace& from,
                 std::size_t to, HeadingColumns& out);

/// Sets `count` columns to nothing.
void clear(std::size_t count, HeadingColumns& out);

/// Back to direction, `count` columns.
void turn_back(std::size_t count, HeadingColumns& columns);

/// A column times `scale`, by heading: waves from d meet a ship heading for h at m = h + half a turn - d.
void read_headings(const HeadingColumns& columns, std::size_t column, double scale, ByHeading& out);

/// A column of variances, what is no more than rounding taken away.
void read_moment(const HeadingColumns& columns, std::size_t column, ByHeading& out);

}  // namespace quickstrip
