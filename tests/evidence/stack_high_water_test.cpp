// The stack that core and the session really use: threads on painted stacks, measured after the call. Never
// above the bound from the compiler's call graph (stack_bound.cpp prints it); and libm's functions stay below
// the allowance that the bound gives them.
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>

#include "msgs/convert/sea_message.hpp"
#include "tests/evidence/call_graph.hpp"
#include "tests/session/session_fixture.hpp"

namespace quickstrip::evidence {
namespace {

constexpr std::size_t kStackBytes = 1U << 20U;
constexpr unsigned char kPaint = 0xA5;
constexpr long kLibmAllowance = 2048;  // stack_bound.cpp's

void* call(void* work) {
  (*static_cast<const std::function<void()>*>(work))();
  return nullptr;
}

/// Bytes below the top of a fresh painted stack that `work` has written, thread start included.
long touched(const std::function<void()>& work) {
  void* const stack = mmap(nullptr, kStackBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  std::memset(stack, kPaint, kStackBytes);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack, kStackBytes);
  pthread_t thread{};
  EXPECT_EQ(pthread_create(&thread, &attributes, call, const_cast<std::function<void()>*>(&work)), 0);
  pthread_join(thread, nullptr);
  const auto* const bytes = static_cast<const unsigned char*>(stack);
  std::size_t lowest = 0;
  while (lowest < kStackBytes && bytes[lowest] == kPaint) {
    ++lowest;
  }
  munmap(stack, kStackBytes);
  return static_cast<long>(kStackBytes - lowest);
}

/// Without what a thread that does nothing touches.
long high_water(const std::function<void()>& work) {
  static const long kNothing = touched([] {});
  return touched(work) - kNothing;
}

TEST(StackHighWater, SeesABlockOfKnownSize) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the thread sanitizer's start of a thread takes more than the block";
#endif
  const long seen = high_water([] {
    std::array<unsigned char, 20'000> block{};
    block.fill(1);
    asm volatile("" : : "g"(block.data()) : "memory");
  });
  EXPECT_GE(seen, 20'000 - 1'024);  // the empty thread had a little of it: 300, sanitized 1,000 bytes
  EXPECT_LE(seen, 22'000);
}

struct Work {
  std::unique_ptr<Advisor> advisor = std::make_unique<Advisor>();
  std::unique_ptr<Hull> hull = std::make_unique<Hull>(test::s175());
  Criteria criteria = *nordforsk_merchant(*hull);
  SeaState sea;
  DirectionalSpectrum spectrum;
  OwnShip ship{.heading = {radians(30.0)}, .speed = 8.0};
  Loading loading = hull->loading;
  CellResponse asked;

  Work() {
    for (int i = 0; i < 3; ++i) {
      QS_CHECK(sea.systems.push_back({.hs = 6.0 - i, .period = 12.0 - 2.0 * i, .from = {0.5 * i}}));
    }
    const auto message = std::make_unique<wave_spectrum_t>(test::spectrum(test::kStart, 0.5, 2));
    QS_CHECK(to_directional_spectrum(*message, spectrum).ok());
  }
  StepInputs inputs(bool is_measured) {
    StepInputs in;
    in.sea_state = is_measured ? nullptr : &sea;
    in.spectrum = is_measured ? &spectrum : nullptr;
    in.own_ship = &ship;
    in.loading = &loading;
    in.ensemble_members = 4;
    return in;
  }
};

/// The bound of an entry from the call graph of this build; -1 where there is none (sanitizers, clang).
long bound_of([[maybe_unused]] const std::string& entry) {
#ifdef QUICKSTRIP_CALL_GRAPH
  static const CallGraph kGraph = [] {
    CallGraph graph;
    EXPECT_GT(graph.read_all(QUICKSTRIP_CALL_GRAPH), 10U);
    return graph;
  }();
  const auto symbols = kGraph.find("quickstrip::Advisor::" + entry);
  return symbols.size() == 1 ? kGraph.deepest_path(symbols.front(), kLibmAllowance).bytes : -1;
#else
  return -1;
#endif
}

void expect_within_bound(const char* entry, long measured) {
  const long bound = bound_of(entry);
  std::printf("%-10s measured %6ld bytes, bound %6ld\n", entry, measured, bound);
  EXPECT_GT(measured, 500) << entry << ": nothing was measured";
  if (bound >= 0) {
    EXPECT_LE(measured, bound) << entry;
  }
}

TEST(StackHighWater, OfCoreIsWithinTheBoundOfTheCallGraph) {
  const auto work = std::make_unique<Work>();
  Advisor& advisor = *work->advisor;
  expect_within_bound("configure", high_water([&] {
                        QS_CHECK(advisor.configure(*work->hull, work->criteria, StripMethod{}).ok());
                      }));
  const StepInputs state = work->inputs(false);
  const StepInputs measured = work->inputs(true);
  expect_within_bound("step", high_water([&] {
                        static_cast<void>(advisor.step(state));
                        const StepOutput& output = advisor.step(measured);
                        QS_CHECK(output.advice.no_advice == NoAdvice::kNone);
                      }));
  expect_within_bound("respond_at",
                      high_water([&] { QS_CHECK(advisor.respond_at({1.0}, 6.0, work->asked).ok()); }));
  work->loading.kg -= 0.3;
  static_cast<void>(advisor.step(state));
  ASSERT_TRUE(advisor.is_rebuild_due());
  expect_within_bound("rebuild", high_water([&] { QS_CHECK(advisor.rebuild().ok()); }));
}

TEST(StackHighWater, OfTheSessionsCycleIsPrinted) {
  const auto bridge = test::bridge_at_sea();
  const long cycle = high_water([&] { static_cast<void>(bridge->cycle(test::kStart)); });
  std::printf("a session's cycle: %ld bytes\n", cycle);
  EXPECT_EQ(bridge->session.advice().no_advice, 0);
  EXPECT_LE(cycle, 128 * 1024);
}

TEST(StackHighWater, OfLibmIsWithinItsAllowance) {
  using Unary = double (*)(double);
  constexpr std::array<Unary, 22> kFunctions{
      std::sin,  std::cos,  std::tan,   std::asin, std::acos,   std::atan,  std::sinh, std::cosh,
      std::tanh, std::exp,  std::expm1, std::log,  std::log1p,  std::log10, std::sqrt, std::cbrt,
      std::erf,  std::erfc, std::floor, std::rint, std::lgamma, std::tgamma};
  long most = 0;
  for (const Unary function : kFunctions) {
    for (const double x : {0.3, -7.0, 1e5, 1e22, 1e300, 5e-324}) {
      volatile double result = 0.0;
      most = std::max(most, high_water([&] { result = function(x); }));
    }
  }
  using Binary = double (*)(double, double);
  constexpr std::array<Binary, 5> kOfTwo{std::pow, std::atan2, std::hypot, std::fmod, std::remainder};
  for (const Binary function : kOfTwo) {
    for (const double x : {0.3, 1e22, 5e-324}) {
      volatile double result = 0.0;
      most = std::max(most, high_water([&] { result = function(x, 0.7 * x); }));
    }
  }
  std::printf("libm: %ld bytes at most\n", most);
  EXPECT_LE(most, kLibmAllowance);
}

}  // namespace
}  // namespace quickstrip::evidence
