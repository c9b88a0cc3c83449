#include "core/strip/hydrodynamic_coefficients.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "core/strip/section_table.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

struct Case {
  std::unique_ptr<LoadedHull> hull = std::make_unique<LoadedHull>();
  SectionHydrodynamics section{};
  explicit Case(StripVariant variant, double omega_e, const Hull& ship = test::wigley_hull(1, 21)) {
    StripMethod method;
    method.variant = variant;
    method.surge = SurgeTerms::kInertiaOnly;
    EXPECT_TRUE(load(ship, ship.loading, method, *hull).ok());
    section_hydrodynamics(*hull, omega_e, section);
  }
};

// The closed-stern form of Salvesen, Tuck and Faltinsen, their equations 7-14, signs for pitch bow down
// (formulas §4.3).
TEST(HydrodynamicCoefficients, ModifiedMethodWithClosedEndsIsThatOfSalvesenTuckFaltinsen) {
  const double we = 4.0, v = 1.5;
  const Case c(StripVariant::kModified, we);
  const HydrodynamicCoefficients h = hydrodynamic_coefficients(*c.hull, we, v);
  const double a33 = integral(*c.hull, c.section[kA33], 0), b33 = integral(*c.hull, c.section[kB33], 0);
  const double xa = integral(*c.hull, c.section[kA33], 1), xb = integral(*c.hull, c.section[kB33], 1);
  const double xxa = integral(*c.hull, c.section[kA33], 2), xxb = integral(*c.hull, c.section[kB33], 2);
  const double w2 = we * we;
  EXPECT_NEAR(h.a[2][2], a33, 1e-9 * a33);
  EXPECT_NEAR(h.b[2][2], b33, 1e-9 * b33);
  EXPECT_NEAR(h.a[2][4], -xa - v / w2 * b33, 1e-9 * a33);
  EXPECT_NEAR(h.a[4][2], -xa + v / w2 * b33, 1e-9 * a33);
  EXPECT_NEAR(h.b[2][4], -xb + v * a33, 1e-9 * b33);
  EXPECT_NEAR(h.b[4][2], -xb - v * a33, 1e-9 * b33);
  // x^2 terms: the trapezoidal rule on 21 stations integrates the slope of x^2 to 2e-3.
  EXPECT_NEAR(h.a[4][4], xxa + v * v / w2 * a33, 1e-3 * xxa);
  EXPECT_NEAR(h.b[4][4], xxb + v * v / w2 * b33, 1e-3 * xxb);
}

// Closed ends, ordinary method (formulas §4.2).
TEST(HydrodynamicCoefficients, OrdinaryMethodWithClosedEndsIsTheTextbookForm) {
  const double we = 4.0, v = 1.5;
  const Case c(StripVariant::kOrdinary, we);
  const HydrodynamicCoefficients h = hydrodynamic_coefficients(*c.hull, we, v);
  const double a33 = integral(*c.hull, c.section[kA33], 0), b33 = integral(*c.hull, c.section[kB33], 0);
  const double xa = integral(*c.hull, c.section[kA33], 1), xb = integral(*c.hull, c.section[kB33], 1);
  const double xxa = integral(*c.hull, c.section[kA33], 2);
  EXPECT_NEAR(h.b[2][2], b33, 1e-9 * b33);
  EXPECT_NEAR(h.a[2][4], -xa - v / (we * we) * b33, 1e-9 * a33);
  EXPECT_NEAR(h.a[4][2], -xa, 1e-9 * a33);
  EXPECT_NEAR(h.b[2][4], -xb + v * a33, 1e-9 * b33);
  EXPECT_NEAR(h.b[4][2], -xb - v * a33, 1e-9 * b33);
  EXPECT_NEAR(h.a[4][4], xxa + v / (we * we) * (xb + v * a33), 1e-9 * xxa);
}

// Timman and Newman: at zero speed the matrices are symmetric, whatever the method.
TEST(HydrodynamicCoefficients, AreSymmetricAtZeroSpeed) {
  for (const StripVariant variant : {StripVariant::kOrdinary, StripVariant::kModified}) {
    const Case c(variant, 3.0);
    const HydrodynamicCoefficients h = hydrodynamic_coefficients(*c.hull, 3.0, 0.0);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        EXPECT_NEAR(h.a[i][j], h.a[j][i], 1e-12 * (h.a[i][i] + h.a[j][j]));
        EXPECT_NEAR(h.b[i][j], h.b[j][i], 1e-12 * (h.b[i][i] + h.b[j][j]));
      }
    }
  }
}

// Froude: lengths x s, times x sqrt(s): a33 ~ s^3, a55 ~ s^5, b ~ the same over sqrt(s); omega ~ 1/sqrt(s).
TEST(HydrodynamicCoefficients, ScaleByFroudesLaw) {
  const double s = 25.0, we = 4.0, v = 1.2;
  const Hull model = test::wigley_hull(1, 21);
  const Case small(StripVariant::kOrdinary, we, model);
  const Case large(StripVariant::kOrdinary, we / std::sqrt(s), test::scaled(model, s));
  const auto a = hydrodynamic_coefficients(*small.hull, we, v);
  const auto b = hydrodynamic_coefficients(*large.hull, we / std::sqrt(s), v * std::sqrt(s));
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const double power = 3.0 + (i > 2 ? 1.0 : 0.0) + (j > 2 ? 1.0 : 0.0);
      const double scale_a = std::sqrt(std::fabs(a.a[i][i] * a.a[j][j]));
      const double scale_b = std::sqrt(std::fabs(a.b[i][i] * a.b[j][j]));
      EXPECT_NEAR(b.a[i][j] / std::pow(s, power), a.a[i][j], 1e-6 * scale_a) << i << j;
      EXPECT_NEAR(b.b[i][j] / std::pow(s, power - 0.5), a.b[i][j], 1e-6 * scale_b + 1e-12) << i << j;
    }
  }
}

// Moving G by d along z moves sway-roll coupling by d a22 (NOTATION.md: OG up +). Flipping OG changes the
// sign.
TEST(HydrodynamicCoefficients, RaisingGMovesTheSwayRollCouplingByItsLever) {
  Hull low = test::wigley_hull(1, 21);
  Hull high = low;
  high.loading.kg += 0.01;
  high.loading.gm = low.loading.gm = 0.02;
  const Case a(StripVariant::kOrdinary, 3.0, low);
  const Case b(StripVariant::kOrdinary, 3.0, high);
  const auto ha = hydrodynamic_coefficients(*a.hull, 3.0, 0.0);
  const auto hb = hydrodynamic_coefficients(*b.hull, 3.0, 0.0);
  EXPECT_NEAR(hb.a[1][3] - ha.a[1][3], 0.01 * ha.a[1][1], 1e-9 * ha.a[1][1]);
  EXPECT_NEAR(hb.b[1][3] - ha.b[1][3], 0.01 * ha.b[1][1], 1e-9 * ha.b[1][1]);
}

// The interpolated table of the loaded hull against the section table itself, between the nodes.
TEST(LoadedHull, InterpolatesItsTableWithin3PerMille) {
  const Case c(StripVariant::kOrdinary, 3.0);
  SectionHydrodynamics interpolated;
  double worst = 0.0;
  for (double omega = 0.3; omega < 20.0; omega *= 1.037) {
    section_hydrodynamics(*c.hull, omega, interpolated);
    const std::size_t i = c.hull->num_sections / 2;
    const LewisSection& form = c.hull->lewis[i];
    const double xi = omega * omega * form.breadth / (2.0 * c.hull->gravity);
    const SectionCoefficients direct = section_coefficients(*section_table_column(form.h0, form.sigma), xi);
    const double rho_a = c.hull->density * form.area;
    worst = std::max(worst, std::fabs(interpolated[kA33][i] / rho_a - direct.a33) / direct.a33);
    worst =
        std::max(worst, std::fabs(interpolated[kA22][i] / rho_a - direct.a22) / std::max(0.2, direct.a22));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 3e-3);  // 96 nodes in three decades; the section table's own parabolas are not smooth
}

}  // namespace
}  // namespace quickstrip
