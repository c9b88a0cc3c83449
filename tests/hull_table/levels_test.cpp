// Between the levels: coefficients, loads and motions interpolated there against a table compiled at the very
// draughts. Figures are printed for the record.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/strip/equations_of_motion.hpp"
#include "core/strip/wave_loads.hpp"
#include "tests/hull_table/compiled.hpp"

namespace quickstrip::test {
namespace {

constexpr std::array<const char*, kNumStripQuantities> kQuantityNames = {"a22", "b22", "a24", "b24",
                                                                         "a33", "b33", "a44", "b44"};

constexpr StripMethod by_table() {
  StripMethod method;
  method.loads = DiffractionLoads::kBoundaryValue;
  return method;
}

/// Greatest difference of the whole ship's integrals, per quantity, over the frequencies 0.5 ... 15
/// sqrt(g/L), as a part of the quantity's greatest value among them.
std::array<double, kNumStripQuantities> of_integrals(const LoadedHull& a, const LoadedHull& b) {
  std::array<double, kNumStripQuantities> out{};
  const double unit = std::log(std::sqrt(b.gravity / b.lpp));
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    double greatest = 0.0;
    double difference = 0.0;
    for (std::size_t n = 0; n < kNumEncounterNodes; ++n) {
      const double omega_hat = std::exp(b.log_omega[n] - unit);
      if (omega_hat < 0.5 || omega_hat > 15.0) {
        continue;
      }
      const double wanted = b.node_integrals[n].plain[q][0];
      greatest = std::max(greatest, std::fabs(wanted));
      difference = std::max(difference, std::fabs(a.node_integrals[n].plain[q][0] - wanted));
    }
    out[q] = difference / greatest;
  }
  return out;
}

struct Worst {
  std::array<double, 6> load{};
  std::array<double, 6> motion{};
};

/// The same of loads and motions: every 30 degrees, 0 and 20 kn, waves of 0.25 ... 3 L; parts of the greatest
/// at that speed.
Worst of_motions(const LoadedHull& a, const LoadedHull& b) {
  Worst out;
  Worst greatest;
  for (const double speed : {0.0, 10.3}) {
    for (int m = 0; m <= 6; ++m) {
      const EncounterAngle mu{radians(30.0 * m)};
      for (double length = 0.25; length < 3.0; length *= 1.15) {
        const double omega = std::sqrt(kTwoPi * b.gravity / (length * b.lpp));
        WaveField field;
        std::array<Complex, 6> load_a{};
        std::array<Complex, 6> load_b{};
        wave_field(a, omega, mu, field);
        const MotionTransfer at_a = motion_transfer(a, field, speed, load_a);
        wave_field(b, omega, mu, field);
        const MotionTransfer at_b = motion_transfer(b, field, speed, load_b);
        for (std::size_t i = 0; i < 6; ++i) {
          greatest.load[i] = std::max(greatest.load[i], std::abs(load_b[i]));
          greatest.motion[i] = std::max(greatest.motion[i], std::abs(at_b.motion[i]));
          out.load[i] = std::max(out.load[i], std::abs(load_a[i] - load_b[i]));
          out.motion[i] = std::max(out.motion[i], std::abs(at_a.motion[i] - at_b.motion[i]));
        }
      }
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    out.load[i] /= greatest.load[i];
    out.motion[i] /= greatest.motion[i];
  }
  return out;
}

/// Interpolated and direct, in per cent.
double worst_between(const char* what, const LoadedHull& interpolated, const LoadedHull& direct) {
  double worst = 0.0;
  const auto print = [&worst](const char* name, double part) {
    std::printf(" %s %.2f", name, 100.0 * part);
    worst = std::max(worst, part);
  };
  std::printf("%s [%%]:", what);
  const auto integrals = of_integrals(interpolated, direct);
  for (std::size_t q = 0; q < kNumStripQuantities; ++q) {
    print(kQuantityNames[q], integrals[q]);
  }
  const Worst dynamics = of_motions(interpolated, direct);
  for (std::size_t i = 0; i < 6; ++i) {
    print(("X" + std::to_string(i + 1)).c_str(), dynamics.load[i]);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    print(("x" + std::to_string(i + 1)).c_str(), dynamics.motion[i]);
  }
  std::printf("\n");
  return worst;
}

Loading floating(const Hull& hull, double aft, double fwd) {
  Loading loading = hull.loading;
  loading.draught_aft = aft;
  loading.draught_fwd = fwd;
  return loading;
}

// The figure: 0.5 %.
constexpr double kBetweenLevels = 5e-3;

TEST(Levels, HalfAMetreApartTheTableIsWithinHalfAPerCentOfADirectBuild) {
  const auto hull = thinned_s175(3);
  const Compiled table(*hull, HullSections::kCloseFit, {{8.75, 9.25, 9.75, 10.25}, {}});
  const Compiled own(*hull, HullSections::kCloseFit, {{9.5}, {}});
  const Loading loading = floating(*hull, 9.5, 9.5);
  const auto interpolated = loaded(*hull, loading, &table.view, by_table());
  const auto direct = loaded(*hull, loading, &own.view, by_table());
  ASSERT_NE(interpolated->table, nullptr);
  ASSERT_NE(direct->table, nullptr);
  EXPECT_LT(worst_between("half way between levels 0.5 m apart", *interpolated, *direct), kBetweenLevels);
}

// The direct build has a level at each station's own waterline.
TEST(Levels, ATrimmedShipIsWithinHalfAPerCentOfADirectBuildAtEachStationsWaterline) {
  const auto hull = thinned_s175(3);
  const Loading loading = floating(*hull, 9.8, 9.2);
  CompiledLoadings waterlines;
  for (const Station& station : hull->stations) {
    waterlines.draughts.push_back(waterline_height(*hull, loading, station.x));
  }
  const Compiled table(*hull, HullSections::kLewis, {{9.1, 9.5, 9.9}, {0.6}});
  const Compiled own(*hull, HullSections::kLewis, waterlines);
  const auto interpolated = loaded(*hull, loading, &table.view, by_table());
  const auto direct = loaded(*hull, loading, &own.view, by_table());
  ASSERT_NE(interpolated->table, nullptr);
  ASSERT_NE(direct->table, nullptr);
  EXPECT_LT(worst_between("trim of 0.6 m on levels 0.4 m apart", *interpolated, *direct), kBetweenLevels);
}

TEST(Levels, AreTheDraughtsAndWhatTrimAddsAtTheEnds) {
  const auto hull = thinned_s175(3);  // stations from 1.66 m aft of the perpendicular to 175 m
  EXPECT_EQ(table_levels(*hull, {{10.0, 9.0, 9.5, 9.0}, {}}), (std::vector<double>{9.0, 9.5, 10.0}));
  const std::vector<double> trimmed = table_levels(*hull, {{9.0, 9.5}, {-0.4, 1.4}});
  ASSERT_EQ(trimmed.size(), 6u);
  EXPECT_NEAR(trimmed.front(), 9.0 - 0.7, 1e-12);  // draught forward at 9.0 m, down by the stern
  EXPECT_NEAR(trimmed.back(), 9.5 + 1.4 * (0.5 + 1.6625 / 175.0), 1e-12);
  EXPECT_NEAR(trimmed[1], 9.0 - 0.35, 1e-12);  // no farther apart than the draughts
  EXPECT_NEAR(trimmed[2], 9.0, 1e-12);
}

}  // namespace
}  // namespace quickstrip::test
