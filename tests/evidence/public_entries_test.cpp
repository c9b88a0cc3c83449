// No heap in any public entry of core that the session or the firmware calls. The list is checked against the
// headers: an entry added there and not here fails.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <regex>
#include <set>

#include "core/advice/comparison.hpp"
#include "core/strip/section_table.hpp"
#include "msgs/convert/sea_message.hpp"
#include "tests/arch/source_tree.hpp"
#include "tests/session/session_fixture.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::evidence {
namespace {

using test::HeapGuard;

class PublicEntries : public testing::Test {
 protected:
  PublicEntries() {
    QS_CHECK(sea_.systems.push_back({.hs = 4.0, .period = 11.0, .from = {1.0}}));
    inputs_.sea_state = &sea_;
    inputs_.own_ship = &ship_;
    inputs_.loading = &loading_;
    inputs_.ensemble_members = kEnsembleMembers;
    inputs_.uncertainty.gm = 0.05;
    inputs_.uncertainty.height_part[0] = 0.1;
    inputs_.motion = &motion_;
    motion_.window = 600.0;
    motion_.roll_rms = 0.05;
    motion_.roll_period = 18.0;
    QS_CHECK(to_directional_spectrum(test::spectrum(test::kStart, 0.5, 2), spectrum_).ok());
  }
  void expect_none(const char* entry, const std::function<void()>& work) {
    const HeapGuard guard;
    work();
    EXPECT_EQ(guard.allocations(), 0U) << entry;
    called_.insert(entry);
  }
  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>(test::coarse_s175());
  std::unique_ptr<Advisor> advisor_ = std::make_unique<Advisor>();
  std::unique_ptr<CellResponse> asked_ = std::make_unique<CellResponse>();
  Criteria criteria_ = *nordforsk_merchant(*hull_);
  SeaState sea_;
  DirectionalSpectrum spectrum_;
  OwnShip ship_{.heading = {0.4}, .speed = 7.0};
  Loading loading_ = hull_->loading;
  MeasuredMotion motion_;
  StepInputs inputs_;
  std::set<std::string> called_;
};

/// Functions of a class between its first "public:" and "private:".
std::set<std::string> public_functions(const std::string& header, const std::string& name) {
  const std::string code = arch::code_of(arch::source_file(header).text);
  const std::size_t begin = code.find("public:", code.find("class " + name + " {"));
  const std::string open = code.substr(begin, code.find("private:", begin) - begin);
  static const std::regex kFunction(R"(\b([a-z_]+)\(([^;{()]|\{\})*\)\s*(const)?\s*[;{])");
  std::set<std::string> names;
  for (std::sregex_iterator i(open.begin(), open.end(), kFunction), end; i != end; ++i) {
    names.insert((*i)[1]);
  }
  return names;
}

TEST_F(PublicEntries, OfTheAdvisorTakeNoHeap) {
  Advisor& advisor = *advisor_;
  Status status;
  expect_none("configure", [&] { status = advisor.configure(*hull_, criteria_, StripMethod{}); });
  ASSERT_TRUE(status.ok());
  expect_none("step", [&] {
    static_cast<void>(advisor.step(inputs_));  // a sea state, the whole ensemble
    inputs_.sea_state = nullptr;
    inputs_.spectrum = &spectrum_;
    QS_CHECK(advisor.step(inputs_).advice.no_advice == NoAdvice::kNone);
    inputs_.own_ship = nullptr;  // no advice
    static_cast<void>(advisor.step(inputs_));
    inputs_.own_ship = &ship_;
    static_cast<void>(advisor.step(inputs_));
  });
  expect_none("respond_at", [&] { status = advisor.respond_at({2.0}, 5.0, *asked_); });
  EXPECT_TRUE(status.ok());
  loading_.kg -= 0.2;
  static_cast<void>(advisor.step(inputs_));
  expect_none("is_rebuild_due", [&] { QS_CHECK(advisor.is_rebuild_due()); });
  expect_none("rebuild", [&] { status = advisor.rebuild(); });
  EXPECT_TRUE(status.ok());
  loading_.kg = 1e6;  // refused, which must not take any either
  static_cast<void>(advisor.step(inputs_));
  expect_none("rebuild", [&] { status = advisor.rebuild(); });
  EXPECT_FALSE(status.ok());
  expect_none("criteria", [&] { QS_CHECK(!advisor.criteria().empty()); });
  expect_none("loading_summary", [&] { static_cast<void>(advisor.loading_summary()); });
  expect_none("hull_quality", [&] { static_cast<void>(advisor.hull_quality()); });
  expect_none("transfer_functions", [&] { static_cast<void>(advisor.transfer_functions()); });
  expect_none("zone_ship", [&] { static_cast<void>(advisor.zone_ship()); });
  expect_none("zones", [&] { static_cast<void>(advisor.zones()); });
  EXPECT_EQ(called_, public_functions("core/advisor.hpp", "Advisor"));
}

TEST_F(PublicEntries, OfTheComparisonTakeNoHeap) {
  ASSERT_TRUE(advisor_->configure(*hull_, criteria_, StripMethod{}).ok());
  const StepOutput& output = advisor_->step(inputs_);
  const auto predicted = std::make_unique<PredictedMotion>();
  const auto comparison = std::make_unique<Comparison>();
  expect_none("forget", [&] { predicted->forget(); });
  expect_none("note", [&] { predicted->note(1000.0, output.present); });
  expect_none("compare", [&] { predicted->compare(motion_, *hull_, 1000.0, 0.1, *comparison); });
  EXPECT_EQ(called_, public_functions("core/advice/comparison.hpp", "PredictedMotion"));
}

TEST_F(PublicEntries, OfFreeFunctionsTakeNoHeap) {
  expect_none("nordforsk_merchant", [&] { QS_CHECK(nordforsk_merchant(*hull_).ok()); });
  expect_none("check_criteria", [&] { QS_CHECK(check_criteria(criteria_, *hull_).ok()); });
  expect_none("section_table_checksum", [&] { QS_CHECK(section_table_checksum() != 0); });
  expect_none("message", [&] { QS_CHECK(message(Error::kNotFinite) != nullptr); });
}

TEST(PublicEntriesReader, SeesAnEntryThatIsAdded) {
  const auto names = public_functions("core/advisor.hpp", "Advisor");
  EXPECT_TRUE(names.contains("configure"));
  EXPECT_TRUE(names.contains("zones"));
  EXPECT_FALSE(names.contains("solve_speeds")) << "private";
}

}  // namespace
}  // namespace quickstrip::evidence
