#include "firmware/session/self_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/angles.hpp"
#include "core/strip/section_table.hpp"

namespace quickstrip {
namespace {

constexpr bool kIsHost = kNumDirections == capacity::Host::kNumDirections;
constexpr double kTolerance = 1e-3;

struct KnownCell {
  std::size_t speed;
  std::size_t heading;
  double roll;          // RMS [rad]
  double acceleration;  // vertical at the bow, RMS [m/s2]
};

// At rest and at 6 m/s, seas from both bows and quarters, by either profile of capacities: that of fewer
// directions and frequencies comes out to 4 % of the other in roll, 0.2 % in acceleration.
using KnownCells = std::array<KnownCell, 4>;
constexpr KnownCells kKnown = kIsHost ? KnownCells{{
                                            {0, 1, 0.00643174164, 0.715176344},
                                            {0, 3, 0.00513807172, 0.780193686},
                                            {1, 4, 0.0173994023, 0.507816851},
                                            {1, 9, 0.00914559327, 0.921530664},
                                        }}
                                      : KnownCells{{
                                            {0, 1, 0.00643547345, 0.715521336},
                                            {0, 3, 0.00514285965, 0.781801164},
                                            {1, 4, 0.0167321712, 0.508065045},
                                            {1, 9, 0.00890288875, 0.923178554},
                                        }};

/// Every capacity is far above what the barge needs.
template <typename Vector, typename Item>
void put(Vector& to, const Item& item) {
  static_cast<void>(to.push_back(item));
}

Criteria known_criteria() {
  Criteria criteria;
  put(criteria, Criterion{.name = Name("roll"), .quantity = Quantity::kRoll, .limit = radians(6.0)});
  put(criteria,
      Criterion{.name = Name("bow"), .quantity = Quantity::kVerticalAcceleration, .place = 0, .limit = 2.0});
  return criteria;
}

double difference(float computed, double known) {
  return std::abs(static_cast<double>(computed) / known - 1.0);
}

}  // namespace

const char* message(SelfTestItem failed) {
  switch (failed) {
    case SelfTestItem::kNone:
      return "passed";
    case SelfTestItem::kSectionTable:
      return "the section table in memory is damaged";
    case SelfTestItem::kHullTable:
      return "the hull table in memory is damaged";
    case SelfTestItem::kFloatingPoint:
      return "the processor does not compute as IEEE 754";
    case SelfTestItem::kKnownAnswer:
      return "a ship whose answer is known came out otherwise";
  }
  return "unknown item";
}

bool computes_as_ieee754() {
  // volatile: by the processor, now, not by the compiler, then.
  volatile double one = 1.0;
  volatile double half_ulp = std::numeric_limits<double>::epsilon() / 2.0;
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double nan = std::numeric_limits<double>::quiet_NaN();
  volatile float smallest_single = std::numeric_limits<float>::min();
  const bool to_nearest =
      one + half_ulp == 1.0 && -one - half_ulp == -1.0 && one + 3.0 * half_ulp == 1.0 + 4.0 * half_ulp;
  const bool keeps_subnormals = smallest / 4.0 > 0.0 && smallest_single / 4.0F > 0.0F;
  const bool tells_nan = !(nan == nan) && !(nan < 1.0);  // NOLINT(misc-redundant-expression)
  return to_nearest && keeps_subnormals && tells_nan;
}

// 100 m long, 18 m broad, 6 m deep in the water: parabolic ends, sides that flare from the keel to the bilge.
void make_known_ship(Hull& out) {
  constexpr double kLength = 100.0;
  constexpr int kStations = 11;
  std::construct_at(&out);  // no copy of it on a small stack
  out.name = Name("barge of the self-test");
  out.lpp = kLength;
  out.breadth = 18.0;
  for (int s = 0; s < kStations; ++s) {
    const double x = kLength * s / (kStations - 1);
    const double from_midship = 2.0 * x / kLength - 1.0;
    const double half = 0.5 * out.breadth * (1.0 - 0.8 * from_midship * from_midship);
    Station station;
    station.x = x;
    for (const Offset offset : {Offset{0.0, 0.0}, Offset{0.7 * half, 0.2}, Offset{0.95 * half, 2.0},
                                Offset{half, 4.0}, Offset{half, 10.0}}) {
      put(station.offsets, offset);
    }
    put(out.stations, station);
  }
  out.loading.draught_aft = 6.0;
  out.loading.draught_fwd = 6.0;
  out.loading.kg = 6.5;
  out.loading.free_surface_correction = 0.0;
  out.loading.roll_gyradius = 6.3;
  out.loading.pitch_gyradius = 25.0;
  out.loading.yaw_gyradius = 25.0;
  put(out.points,
      PointOfInterest{.name = Name("bow"), .role = PointRole::kForwardPerpendicular, .x = 100.0, .z = 10.0});
  out.grid = {.speed_from = 0.0, .speed_to = 6.0, .speed_step = 6.0, .heading_step = radians(30.0)};
}

double known_answer_error(Advisor& advisor, Hull& barge) {
  constexpr double kWrong = 1e9;
  make_known_ship(barge);
  if (!advisor.configure(barge, known_criteria(), {})) {
    return kWrong;
  }
  SeaState sea;
  put(sea.systems, WaveSystem{.hs = 3.0,
                              .period = 9.0,
                              .from = {0.0},
                              .spreading = radians(25.0),
                              .shape = SpectrumShape::kJonswap});
  const OwnShip ship{.heading = {radians(30.0)}, .speed = 6.0};
  const StepInputs inputs{.sea_state = &sea, .own_ship = &ship};
  const StepOutput& output = advisor.step(inputs);
  if (output.advice.no_advice != NoAdvice::kNone) {
    return kWrong;
  }
  double largest = 0.0;
  for (const KnownCell& known : kKnown) {
    const Cell& cell = output.grid.cells[known.speed][known.heading];
    for (const double error :
         {difference(cell.values[0], known.roll), difference(cell.values[1], known.acceleration)}) {
      if (!(error <= largest)) {  // NaN too
        largest = error;
      }
    }
  }
  return largest <= kWrong ? largest : kWrong;
}

SelfTestItem run_self_test(Advisor& advisor, Hull& barge, const HullTable* table) {
  if (!section_table_is_intact()) {
    return SelfTestItem::kSectionTable;
  }
  if (table != nullptr && !table->is_intact()) {
    return SelfTestItem::kHullTable;
  }
  if (!computes_as_ieee754()) {
    return SelfTestItem::kFloatingPoint;
  }
  return known_answer_error(advisor, barge) <= kTolerance ? SelfTestItem::kNone : SelfTestItem::kKnownAnswer;
}

}  // namespace quickstrip
