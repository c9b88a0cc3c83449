// Numbers that are none, without end, denormal, zero or huge in every field that goes into a step, a loading
// or a hull: no trap, no heap, and what comes out is no advice or finite (tests/support/step_promises.hpp).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "msgs/convert/sea_message.hpp"
#include "tests/session/session_fixture.hpp"
#include "tests/support/heap_guard.hpp"
#include "tests/support/step_promises.hpp"

namespace quickstrip::evidence {
namespace {

constexpr std::array kBad{std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::denorm_min(),
                          -std::numeric_limits<double>::denorm_min(),
                          1e-310,
                          0.0,
                          -0.0,
                          -1.0,
                          1e-9,
                          1e9,
                          std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::lowest()};

struct AllInputs {
  SeaState sea;
  DirectionalSpectrum spectrum;
  OwnShip ship{.heading = {0.4}, .speed = 7.0, .water_depth = 100.0};
  Loading loading;
  MeasuredMotion motion;
  StepInputs step;

  explicit AllInputs(const Hull& hull) : loading(hull.loading) {
    QS_CHECK(sea.systems.push_back({.hs = 4.0, .period = 11.0, .from = {1.0}, .spreading = 0.3}));
    QS_CHECK(sea.systems.push_back(
        {.hs = 1.0, .period = 7.0, .from = {2.0}, .shape = SpectrumShape::kJonswap, .peakedness = 3.3}));
    QS_CHECK(to_directional_spectrum(test::spectrum(test::kStart, 0.5, 2), spectrum).ok());
    motion.window = 600.0;
    motion.roll_rms = 0.05;
    motion.roll_period = 18.0;
    motion.pitch_rms = 0.02;
    motion.pitch_period = 9.0;
    step.own_ship = &ship;
    step.loading = &loading;
    step.motion = &motion;
    step.time = 1000.0;
    step.ensemble_members = 2;
    step.uncertainty.gm = 0.05;
    step.uncertainty.height_part[0] = 0.1;
  }
};

struct Field {
  const char* name;
  std::function<void(AllInputs&, double)> set;
};

/// The last thing tried: told when a check of core's own stops the process.
struct Tried {
  std::size_t field = 0;
  double value = 0.0;
};
Tried g_tried;

void tell_trap(const char* claim, const char* file, int line) {
  std::fprintf(stderr, "field %zu = %g: %s:%d: %s\n", g_tried.field, g_tried.value, file, line, claim);
}

class BadNumbers : public testing::Test {
 protected:
  BadNumbers() {
    set_check_handler(tell_trap);
    hull_->grid.heading_step = radians(60.0);
    QS_CHECK(advisor_->configure(*hull_, criteria_, StripMethod{}).ok());
  }
  void expect_kept(AllInputs& inputs, bool is_spectrum, const std::string& what) {
    inputs.step.sea_state = is_spectrum ? nullptr : &inputs.sea;
    inputs.step.spectrum = is_spectrum ? &inputs.spectrum : nullptr;
    const test::HeapGuard guard;
    const StepOutput* output = &advisor_->step(inputs.step);
    std::string_view broken = test::broken_promise(*output, criteria_);
    if (advisor_->is_rebuild_due()) {
      static_cast<void>(advisor_->rebuild());
      output = &advisor_->step(inputs.step);
      broken = broken.empty() ? test::broken_promise(*output, criteria_) : broken;
    }
    const std::size_t allocations = guard.allocations();
    EXPECT_EQ(broken, "") << what;
    EXPECT_EQ(allocations, 0U) << what;
    num_advised_ += output->advice.no_advice == NoAdvice::kNone ? 1 : 0;
    ++num_steps_;
  }
  void try_each(const std::vector<Field>& fields, bool is_spectrum) {
    for (const Field& field : fields) {
      for (const double bad : kBad) {
        AllInputs inputs(*hull_);
        g_tried = {static_cast<std::size_t>(&field - fields.data()), bad};
        field.set(inputs, bad);
        expect_kept(inputs, is_spectrum, field.name + (" = " + std::to_string(bad)));
      }
    }
    AllInputs good(*hull_);
    const int before = num_advised_;
    expect_kept(good, is_spectrum, "good again");
    EXPECT_EQ(num_advised_, before + 1) << "the advisor did not recover";
    std::printf("%d steps, %d with advice\n", num_steps_, num_advised_);
  }
  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>(test::coarse_s175());
  Criteria criteria_ = *nordforsk_merchant(*hull_);
  std::unique_ptr<Advisor> advisor_ = std::make_unique<Advisor>();
  int num_steps_ = 0;
  int num_advised_ = 0;
};

TEST_F(BadNumbers, InTheSeaStateAreRefusedOrHarmless) {
  try_each({{"hs", [](AllInputs& in, double x) { in.sea.systems[0].hs = x; }},
            {"period", [](AllInputs& in, double x) { in.sea.systems[0].period = x; }},
            {"from", [](AllInputs& in, double x) { in.sea.systems[0].from.radians = x; }},
            {"spreading", [](AllInputs& in, double x) { in.sea.systems[0].spreading = x; }},
            {"peakedness", [](AllInputs& in, double x) { in.sea.systems[1].peakedness = x; }},
            {"second hs", [](AllInputs& in, double x) { in.sea.systems[1].hs = x; }}},
           false);
}

TEST_F(BadNumbers, InTheSpectrumAreRefusedOrHarmless) {
  try_each({{"first frequency", [](AllInputs& in, double x) { in.spectrum.frequencies[0] = x; }},
            {"last frequency", [](AllInputs& in, double x) { in.spectrum.frequencies[7] = x; }},
            {"direction", [](AllInputs& in, double x) { in.spectrum.directions[3] = x; }},
            {"density", [](AllInputs& in, double x) { in.spectrum.density[2][2] = x; }},
            {"all density",
             [](AllInputs& in, double x) {
               for (auto& row : in.spectrum.density) {
                 row.fill(x);
               }
             }}},
           true);
}

TEST_F(BadNumbers, InOwnShipMotionTimeAndUncertaintyAreRefusedOrHarmless) {
  try_each(
      {{"heading", [](AllInputs& in, double x) { in.ship.heading.radians = x; }},
       {"speed", [](AllInputs& in, double x) { in.ship.speed = x; }},
       {"depth", [](AllInputs& in, double x) { in.ship.water_depth = x; }},
       {"time", [](AllInputs& in, double x) { in.step.time = x; }},
       {"roll", [](AllInputs& in, double x) { in.motion.roll_rms = x; }},
       {"roll period", [](AllInputs& in, double x) { in.motion.roll_period = x; }},
       {"pitch", [](AllInputs& in, double x) { in.motion.pitch_rms = x; }},
       {"pitch period", [](AllInputs& in, double x) { in.motion.pitch_period = x; }},
       {"window", [](AllInputs& in, double x) { in.motion.window = x; }},
       {"uncertain height", [](AllInputs& in, double x) { in.step.uncertainty.height_part[0] = x; }},
       {"uncertain period", [](AllInputs& in, double x) { in.step.uncertainty.period_part[0] = x; }},
       {"uncertain direction", [](AllInputs& in, double x) { in.step.uncertainty.direction[0] = x; }},
       {"uncertain GM", [](AllInputs& in, double x) { in.step.uncertainty.gm = x; }},
       {"uncertain damping", [](AllInputs& in, double x) { in.step.uncertainty.roll_damping_part = x; }}},
      false);
}

TEST_F(BadNumbers, InTheLoadingAreRefusedOrHarmless) {
  try_each({{"draught aft", [](AllInputs& in, double x) { in.loading.draught_aft = x; }},
            {"both draughts",
             [](AllInputs& in, double x) { in.loading.draught_aft = in.loading.draught_fwd = x; }},
            {"KG", [](AllInputs& in, double x) { in.loading.kg = x; }},
            {"free surface", [](AllInputs& in, double x) { in.loading.free_surface_correction = x; }},
            {"GM", [](AllInputs& in, double x) { in.loading.gm = x; }},
            {"roll gyradius", [](AllInputs& in, double x) { in.loading.roll_gyradius = x; }},
            {"pitch gyradius", [](AllInputs& in, double x) { in.loading.pitch_gyradius = x; }},
            {"yaw gyradius", [](AllInputs& in, double x) { in.loading.yaw_gyradius = x; }},
            {"roll period", [](AllInputs& in, double x) { in.loading.measured_roll_period = x; }},
            {"density", [](AllInputs& in, double x) { in.loading.water_density = x; }},
            {"viscosity", [](AllInputs& in, double x) { in.loading.viscosity = x; }},
            {"gravity", [](AllInputs& in, double x) { in.loading.gravity = x; }}},
           false);
}

TEST_F(BadNumbers, InTheHullAreRefusedAtTheStartOrHarmless) {
  const std::vector<std::function<void(Hull&, double)>> fields{
      [](Hull& hull, double x) { hull.lpp = x; },
      [](Hull& hull, double x) { hull.breadth = x; },
      [](Hull& hull, double x) { hull.stations[5].x = x; },
      [](Hull& hull, double x) { hull.stations[5].offsets[1].y = x; },
      [](Hull& hull, double x) { hull.stations[5].offsets[2].z = x; },
      [](Hull& hull, double x) { hull.points[0].x = x; },
      [](Hull& hull, double x) { hull.points[0].z = x; },
      [](Hull& hull, double x) { hull.slamming[0].x = x; },
      [](Hull& hull, double x) { hull.freeboard[0].height = x; },
      [](Hull& hull, double x) { hull.roll_damping.ratio = x; },
      [](Hull& hull, double x) { hull.min_steerage_speed = x; },
      [](Hull& hull, double x) { hull.grid.speed_to = x; },
      [](Hull& hull, double x) { hull.grid.speed_step = x; },
      [](Hull& hull, double x) { hull.grid.heading_step = x; }};
  const auto advisor = std::make_unique<Advisor>();
  const auto hull = std::make_unique<Hull>();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    for (const double bad : kBad) {
      *hull = *hull_;
      fields[f](*hull, bad);
      AllInputs inputs(*hull);
      inputs.step.sea_state = &inputs.sea;
      g_tried = {f, bad};
      const test::HeapGuard guard;
      const Status status = advisor->configure(*hull, criteria_, StripMethod{});
      const StepOutput& output = advisor->step(inputs.step);
      const std::string_view broken = test::broken_promise(output, criteria_);
      const std::size_t allocations = guard.allocations();
      EXPECT_EQ(broken, "") << "field " << f << " = " << bad;
      EXPECT_EQ(allocations, 0U) << "field " << f << " = " << bad;
      EXPECT_TRUE(status.ok() || output.advice.no_advice == NoAdvice::kNotConfigured);
    }
  }
}

// Through the messages: whatever a field holds, the session refuses it or its advice stays finite and in
// range.
TEST_F(BadNumbers, InMessagesTheSessionRefusesOrStaysInRange) {
  const auto bridge = test::bridge_at_sea();
  std::int64_t now = test::kStart;
  for (const double bad : kBad) {
    sea_state_t sea = test::swell(now, 3.0, 90.0);
    own_ship_t ship = test::ship(now, 0.0, 15.0);
    for (double* const field :
         {&sea.hs_m[0], &sea.period_s[0], &sea.dir_from_deg[0], &sea.lat_deg, &sea.spreading_deg[0],
          &ship.heading_deg, &ship.speed_through_water_kn, &ship.depth_m, &ship.lon_deg}) {
      const double good = *field;
      *field = bad;
      now += test::kSecond;
      sea.utime = ship.utime = now;
      const test::HeapGuard guard;
      static_cast<void>(bridge->session.accept(sea, now));
      static_cast<void>(bridge->session.accept(ship, now));
      bridge->session.cycle(now, bridge->outbox);
      EXPECT_EQ(guard.allocations(), 0U) << bad;
      EXPECT_EQ(test::broken_promise(*bridge->session.output(), criteria_), "") << bad;
      *field = good;
    }
  }
}

}  // namespace
}  // namespace quickstrip::evidence
