// A section by the method of choice.
#include "sim/parent/true_section.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "core/hull/lewis_section.hpp"
#include "sim/parent/frank.hpp"
#include "sim/parent/mapped_flow.hpp"
#include "tests/parent/frank_sections.hpp"

namespace quickstrip {
namespace {

TEST(TrueSection, LewisIsTheFormThatTheProgramOnBoardUses) {
  // A bulb too thin for the tabulated range: replaced there, replaced here.
  for (const SectionContour& contour :
       {test::semicircle(3.0, 100), SectionContour{{{0.0, -9.0}, {1.5, -7.0}, {0.3, -2.0}, {0.2, 0.0}}}}) {
    const double draught = contour.draught();
    const LewisSection form =
        *hydrodynamic_lewis_section(2.0 * contour.half_breadth(), draught, area(contour));
    const TrueSection section(contour, SectionMethod::kLewis);
    EXPECT_EQ(section.method(), SectionMethod::kLewis);
    EXPECT_EQ(section.flow(0.1).a22, lewis_flow(form, 0.1).a22);
    EXPECT_EQ(section.flow(0.1).h3, lewis_flow(form, 0.1).h3);
  }
}

TEST(TrueSection, FrankIsUsedForEveryContourWhenAskedFor) {
  const SectionContour contour = test::rectangle(1.0, 1.0);
  const TrueSection section(contour, SectionMethod::kFrank);
  EXPECT_EQ(section.method(), SectionMethod::kFrank);
  EXPECT_EQ(section.flow(0.7).a44, FrankSection(contour).flow(0.7).a44);
}

TEST(TrueSection, CopiesInSeveralThreadsGiveTheSame) {
  for (const SectionMethod method :
       {SectionMethod::kLewis, SectionMethod::kCloseFit, SectionMethod::kFrank}) {
    const TrueSection section(test::semicircle(2.0, 60), method);
    const double expected = section.flow(0.4).a33;
    std::vector<double> found(4);
    std::vector<std::thread> threads;
    for (double& a33 : found) {
      threads.emplace_back([&a33, copy = section] { a33 = copy.flow(0.4).a33; });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (const double a33 : found) {
      EXPECT_EQ(a33, expected) << name_of(method);
    }
  }
}

TEST(TrueSection, MethodsHaveTheNamesOfTheCommandLine) {
  EXPECT_STREQ(name_of(SectionMethod::kLewis), "lewis");
  EXPECT_STREQ(name_of(SectionMethod::kCloseFit), "close-fit");
  EXPECT_STREQ(name_of(SectionMethod::kFrank), "frank");
}

}  // namespace
}  // namespace quickstrip
