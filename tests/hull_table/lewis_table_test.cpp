// A table compiled of Lewis forms against core's section table of the same forms.
#include <cmath>

#include "tests/hull_table/compiled.hpp"

namespace quickstrip::test {
namespace {

TEST(LewisTable, GivesTheCoefficientsOfTheSectionTable) {
  const auto hull = thinned_s175(3);
  const Compiled compiled(*hull, HullSections::kLewis, own_loadings(*hull));
  const auto by_table = loaded(*hull, hull->loading, &compiled.view);
  const auto by_forms = loaded(*hull, hull->loading, nullptr);
  ASSERT_NE(by_table->table, nullptr);
  constexpr double kSectionTable = 9e-3;  // its stated accuracy, of the greatest value; worst here: a24
  double worst = 0.0;
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    double greatest = 0.0;
    double difference = 0.0;
    for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
      // Whole-ship integrals: what strip theory takes.
      const double a = by_table->node_integrals[n].plain[q][0];
      const double b = by_forms->node_integrals[n].plain[q][0];
      greatest = std::max(greatest, std::fabs(b));
      difference = std::max(difference, std::fabs(a - b));
    }
    EXPECT_LT(difference, kSectionTable * greatest) << "quantity " << q;
    worst = std::max(worst, difference / greatest);
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_GT(worst, 0.0) << "two tables cannot agree to the last bit";
}

TEST(LewisTable, IsTheSameWordsEachTime) {
  const auto hull = thinned_s175(8);
  const Compiled once(*hull, HullSections::kLewis, own_loadings(*hull));
  const Compiled again(*hull, HullSections::kLewis, own_loadings(*hull));
  EXPECT_EQ(once.table.words, again.table.words);
}

}  // namespace
}  // namespace quickstrip::test
