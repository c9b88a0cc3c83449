// The ship that a board is built for: generated from a hull file and a limits file (generate.cpp), so that
// its numbers lie in flash; and the words of her compiled hull table, in flash and read in place.
#pragma once

#include <cstdint>
#include <span>

#include "core/advice/criteria.hpp"
#include "core/base/check.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip::ship {

/// Into memory that begins as a default-constructed one. More than the profile of capacities takes is our own
/// error: QS_CHECK.
void fill(Hull& hull);
void fill(Criteria& criteria);
Name profile();                                // of the criteria
std::span<const std::uint32_t> table_words();  // of the hull table

/// For the generated source.
template <typename T, std::size_t N>
void add(StaticVector<T, N>& to, const T& value) {
  QS_CHECK(to.push_back(value));
}

struct StationForm {
  double x = 0.0;
  double breadth = 0.0;
  double draught = 0.0;
  double area = 0.0;
};
void add_station(Hull& hull, const StationForm& form, std::span<const double[2]> offsets);

}  // namespace quickstrip::ship
