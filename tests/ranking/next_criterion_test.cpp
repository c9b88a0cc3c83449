// The criterion after the governing one, in every cell of a swept grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/advice/scene.hpp"
#include "tests/support/sea_on_nodes.hpp"

namespace quickstrip {
namespace {

/// Closed forms of verdict.hpp, from the value that the cell keeps.
double margin_of(const Criterion& criterion, double value) {
  return criterion.statistic == Statistic::kProbability
             ? std::sqrt(std::log(value) / std::log(criterion.limit))
             : criterion.limit / value;
}

TEST(NextCriterion, IsTheSecondInTheOrderInWhichTheGoverningOneIsTheFirst) {
  const auto scene = std::make_unique<synthetic::Scene>();
  SeaState sea;
  ASSERT_TRUE(sea.systems.push_back({.hs = 5.0, .period = 10.0, .from = {0.4}, .spreading = radians(25.0)}));
  const auto omega = std::span(scene->transfer.omega).first(scene->transfer.num_frequencies);
  ASSERT_TRUE(place_on_grid(sea, omega, scene->sea).ok());
  scene->sweep();
  std::size_t judged = 0;
  for (std::size_t v = 0; v < scene->grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < scene->grid.num_headings; ++h) {
      const Cell& cell = scene->grid.cells[v][h];
      const auto before = [&](std::size_t a, std::size_t b) {
        const Criterion& ca = scene->criteria[a];
        const Criterion& cb = scene->criteria[b];
        const auto va = static_cast<double>(cell.values[a]);
        const auto vb = static_cast<double>(cell.values[b]);
        const bool caution_a = va > ca.caution_fraction * ca.limit;
        const bool caution_b = vb > cb.caution_fraction * cb.limit;
        return caution_a != caution_b ? caution_a : margin_of(ca, va) < margin_of(cb, vb);
      };
      std::vector<std::size_t> order;
      for (std::size_t i = 0; i < scene->criteria.size(); ++i) {
        if (scene->criteria[i].is_watched() && cell.values[i] > 1e-30F) {  // of less a float knows no margin
          order.push_back(i);
        }
      }
      std::sort(order.begin(), order.end(), before);
      if (order.size() < 2 || cell.governing == kNoCriterion) {
        continue;
      }
      ++judged;
      ASSERT_EQ(cell.governing, order[0]) << v << " " << h;
      ASSERT_EQ(cell.next, order[1]) << v << " " << h;
      const double margin = margin_of(scene->criteria[order[1]], static_cast<double>(cell.values[order[1]]));
      // Rounded down to its step; values are floats.
      ASSERT_NEAR(static_cast<double>(next_margin(cell)), std::min(margin, 99.0), 0.0021 + 1e-5 * margin);
    }
  }
  EXPECT_GT(judged, 100u);
  EXPECT_EQ(next_margin(Cell{}), kNotComputed);
}

}  // namespace
}  // namespace quickstrip
