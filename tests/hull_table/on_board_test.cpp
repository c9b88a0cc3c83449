// The advisor and its session with a compiled table: advice by it, the flagged fallback outside it, and how
// the messages tell a run with it from one without.
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "sim/replay/advice_difference.hpp"
#include "tests/hull_table/compiled.hpp"
#include "tests/session/session_fixture.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::test {
namespace {

constexpr StripMethod by_table() {
  StripMethod method;
  method.loads = DiffractionLoads::kBoundaryValue;
  return method;
}

// Nine stations, five speeds, twelve headings; made once.
struct Ship {
  Ship() : hull(coarse()), table(*hull, HullSections::kLewis, {{9.0, 9.5}, {}}) {}
  static std::unique_ptr<Hull> coarse() {
    auto out = thinned_s175(3);
    out->grid = coarse_s175().grid;
    return out;
  }
  std::unique_ptr<Hull> hull;
  Compiled table;
};

const Ship& ship_with_table() {
  static const Ship ship;
  return ship;
}

std::unique_ptr<Advisor> advisor_of(const Ship& ship, const HullTable* table, const StripMethod& method) {
  auto out = std::make_unique<Advisor>();
  const Status status = out->configure(*ship.hull, *nordforsk_merchant(*ship.hull), method, {}, table);
  EXPECT_TRUE(status.ok()) << (status.ok() ? "" : message(status.error()));
  return out;
}

class Sea {
 public:
  Sea() {
    EXPECT_TRUE(sea_.systems.push_back(
        {.hs = 4.0, .period = 11.0, .from = {radians(30.0)}, .spreading = radians(30.0)}));
  }
  [[nodiscard]] StepInputs inputs(const Loading* loading = nullptr) const {
    StepInputs out;
    out.sea_state = &sea_;
    out.own_ship = &own_;
    out.loading = loading;
    return out;
  }

 private:
  SeaState sea_;
  OwnShip own_{.heading = {radians(20.0)}, .speed = from_knots(12.0)};
};

/// Steps until the loading is in force.
const StepOutput& at_loading(Advisor& advisor, const Sea& sea, const Loading& loading) {
  EXPECT_EQ(advisor.step(sea.inputs(&loading)).advice.no_advice, NoAdvice::kLoadingChanged);
  EXPECT_TRUE(advisor.rebuild().ok());
  return advisor.step(sea.inputs(&loading));
}

TEST(OnBoard, ATableOfTheHullGivesAdviceWithoutAFlag) {
  const auto advisor = advisor_of(ship_with_table(), &ship_with_table().table.view, by_table());
  const Sea sea;
  const StepOutput& output = advisor->step(sea.inputs());
  EXPECT_EQ(output.advice.no_advice, NoAdvice::kNone);
  EXPECT_EQ(output.quality & kQualityOutsideHullTable, 0u);
  EXPECT_TRUE(advisor->loading_summary().has_table);
}

TEST(OnBoard, OutsideTheLevelsLewisFormsStandInAndTheAdviceSaysSo) {
  const auto advisor = advisor_of(ship_with_table(), &ship_with_table().table.view, by_table());
  const auto lewis = advisor_of(ship_with_table(), nullptr, {});
  const Sea sea;
  Loading light = ship_with_table().hull->loading;
  light.draught_aft = 8.0;
  light.draught_fwd = 8.0;
  const StepOutput& output = at_loading(*advisor, sea, light);
  const StepOutput& wanted = at_loading(*lewis, sea, light);
  ASSERT_EQ(output.advice.no_advice, NoAdvice::kNone);
  EXPECT_NE(output.quality & kQualityOutsideHullTable, 0u);
  EXPECT_NE(output.grid.cells[2][3].quality & kQualityOutsideHullTable, 0u);
  EXPECT_EQ(wanted.quality & kQualityOutsideHullTable, 0u);
  for (std::size_t s = 0; s < wanted.grid.num_speeds; ++s) {
    for (std::size_t h = 0; h < wanted.grid.num_headings; ++h) {
      ASSERT_EQ(output.grid.cells[s][h].rms_roll, wanted.grid.cells[s][h].rms_roll) << s << " " << h;
      ASSERT_EQ(output.grid.cells[s][h].margin, wanted.grid.cells[s][h].margin) << s << " " << h;
    }
  }
  // And back inside: without a flag again.
  const StepOutput& again = at_loading(*advisor, sea, ship_with_table().hull->loading);
  EXPECT_EQ(again.quality & kQualityOutsideHullTable, 0u);
}

TEST(OnBoard, ATrimThatBringsAStationOutOfTheLevelsIsOutside) {
  const auto advisor = advisor_of(ship_with_table(), &ship_with_table().table.view, by_table());
  const Sea sea;
  Loading trimmed = ship_with_table().hull->loading;
  trimmed.draught_aft = 9.5;
  trimmed.draught_fwd = 9.1;
  EXPECT_EQ(at_loading(*advisor, sea, trimmed).quality & kQualityOutsideHullTable, 0u)
      << "the foremost station, at 175 m, floats at 9.1 m; the aftermost, aft of the perpendicular, at 9.504";
  trimmed.draught_fwd = 8.8;
  EXPECT_NE(at_loading(*advisor, sea, trimmed).quality & kQualityOutsideHullTable, 0u);
}

TEST(OnBoard, StepsAndRebuildsTouchNoHeap) {
  const auto advisor = advisor_of(ship_with_table(), &ship_with_table().table.view, by_table());
  const Sea sea;
  Loading loading = ship_with_table().hull->loading;
  loading.draught_aft = 9.2;
  loading.draught_fwd = 9.2;
  const StepInputs inputs = sea.inputs(&loading);
  const HeapGuard guard;
  advisor->step(inputs);
  EXPECT_TRUE(advisor->rebuild().ok());
  advisor->step(inputs);
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(OnBoard, BoundaryValuesWithoutATableAreRefused) {
  const auto advisor = std::make_unique<Advisor>();
  const Hull& hull = *ship_with_table().hull;
  const Status status = advisor->configure(hull, *nordforsk_merchant(hull), by_table());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error(), Error::kHullTableNeeded);
}

TEST(OnBoard, TheTableOfAnotherHullIsRefused) {
  const auto other = thinned_s175(4);
  const auto advisor = std::make_unique<Advisor>();
  const Status status =
      advisor->configure(*other, *nordforsk_merchant(*other), by_table(), {}, &ship_with_table().table.view);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error(), Error::kHullTableOtherHull);
}

struct Cycled {
  explicit Cycled(const HullTable* table) {
    const Hull& hull = *ship_with_table().hull;
    SessionOptions options;
    options.table = table;
    EXPECT_TRUE(session->configure(hull, *nordforsk_merchant(hull), options).ok());
    EXPECT_TRUE(session->accept(swell(kStart, 3.0, 100.0), kStart).ok());
    EXPECT_TRUE(session->accept(ship(kStart, 10.0, 12.0), kStart).ok());
    session->cycle(kStart, *outbox);
  }
  std::unique_ptr<Session> session = std::make_unique<Session>();
  std::unique_ptr<LastBytes> outbox = std::make_unique<LastBytes>();
};

// What a replay with another table finds first.
TEST(OnBoard, AdviceAndHealthTellTheTableFromNone) {
  const Cycled with(&ship_with_table().table.view);
  const Cycled without(nullptr);
  EXPECT_NE(with.session->advice().hull_digest, without.session->advice().hull_digest);
  const auto health = with.outbox->decoded<health_t>(OutChannel::kHealth);
  EXPECT_EQ(health.hull_digest, with.session->advice().hull_digest);
  EXPECT_NE(health.table_checksum, without.outbox->decoded<health_t>(OutChannel::kHealth).table_checksum);
  const std::string said = difference(with.session->advice(), without.session->advice());
  EXPECT_NE(said.find("hull table"), std::string::npos) << said;
}

}  // namespace
}  // namespace quickstrip::test
