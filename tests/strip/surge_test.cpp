#include "core/strip/surge.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

// [Lamb1932] art. 114, table of inertia coefficients k1 of prolate spheroids; three decimals printed, good
// to 1.3 units of the last (a/b = 2: exactly 0.2100, printed 0.209).
TEST(SurgeAddedMass, AgreesWithLambsTableOfProlateSpheroids) {
  EXPECT_NEAR(spheroid_surge_added_mass_factor(1.0, 0.999999), 0.5, 1e-5);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(1.50, 1.0), 0.305, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(2.00, 1.0), 0.209, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(3.99, 1.0), 0.082, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(6.01, 1.0), 0.045, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(9.97, 1.0), 0.021, 1.5e-3);
}

TEST(SurgeAddedMass, TheSeriesNearTheSphereJoinsTheClosedForm) {
  const double below = spheroid_surge_added_mass_factor(1.0, 0.999951);
  const double above = spheroid_surge_added_mass_factor(1.0, 0.999949);
  EXPECT_NEAR(below, above, 2e-6);  // the function itself changes by 6e-7 in between
}

}  // namespace
}  // namespace quickstrip
