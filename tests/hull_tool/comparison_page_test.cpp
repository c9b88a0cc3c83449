// The page of comparisons says what the program says: its table of peaks, the columns of Lewis forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "msgs/files/hull_file.hpp"
#include "sim/hull_tool/tank_figures.hpp"

namespace quickstrip::hull_tool {
namespace {

const std::string kSource = QUICKSTRIP_SOURCE_DIR;

/// Cells of the lines between <!-- table NAME --> and <!-- end -->, heading and rule left out.
std::vector<std::vector<std::string>> table_of_page(const std::string& name) {
  std::ifstream page(kSource + "/sim/validation/COMPARISON.md");
  std::vector<std::vector<std::string>> rows;
  std::string line;
  bool inside = false;
  while (std::getline(page, line)) {
    if (line.starts_with("<!-- ")) {
      inside = line == "<!-- table " + name + " -->";
    } else if (inside) {
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, '|');) {
        const std::size_t from = cell.find_first_not_of(' ');
        cells.push_back(from == std::string::npos ? ""
                                                  : cell.substr(from, cell.find_last_not_of(' ') - from + 1));
      }
      rows.push_back(cells);
    }
  }
  rows.erase(rows.begin(), rows.begin() + std::min<std::ptrdiff_t>(2, std::ssize(rows)));
  return rows;
}

struct Model {
  std::string hull;
  std::string figures;
  std::string name;
};

Model model_of(const std::string& ship) {
  if (ship == "KCS") {
    return {"kcs", "sim/validation/data/kcs_tokyo2015.csv", "case2.10"};
  }
  if (ship == "DTMB 5512") {
    return {"dtmb5512", "sim/validation/data/dtmb5512_irvine2008.csv", "dtmb5512"};
  }
  const std::string numeral = ship.substr(ship.find(' ') + 1);
  std::string lower = numeral;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return static_cast<char>(c + 32); });
  return {"wigley_" + lower, "tests/golden/wigley_tank.csv", numeral};
}

std::vector<TankCurve> curves_of(const Model& model, StripVariant variant) {
  const auto hull = std::make_unique<Hull>();
  const auto loaded = std::make_unique<LoadedHull>();
  StripMethod method;
  method.variant = variant;
  EXPECT_TRUE(read_hull_file(kSource + "/sim/hulls/" + model.hull + ".hull.toml", *hull).ok());
  EXPECT_TRUE(load(*hull, hull->loading, method, *loaded));
  auto figures = read_tank_file(kSource + "/" + model.figures, model.name);
  std::erase_if(figures, [](const TankFigure& f) {
    return f.quantity < TankQuantity::kHeave || f.quantity == TankQuantity::kAddedResistance;
  });
  std::vector<double> computed;
  for (const TankFigure& figure : figures) {
    computed.push_back(computed_figure(*loaded, figure));
  }
  return tank_curves(figures, computed);
}

TEST(ComparisonPage, TellsThePeaksThatTheProgramFinds) {
  const auto rows = table_of_page("peaks");
  ASSERT_GE(rows.size(), 12U);
  for (const auto& row :
       rows) {  // | ship | Fn | heave or pitch | figures | largest | ordinary | modified | ...
    ASSERT_GE(row.size(), 8U);
    const bool heave = row[3] == "heave";
    for (const StripVariant variant : {StripVariant::kOrdinary, StripVariant::kModified}) {
      bool found = false;
      for (const TankCurve& curve : curves_of(model_of(row[1]), variant)) {
        const bool same_quantity =
            heave ? curve.quantity == TankQuantity::kHeave
                  : curve.quantity == TankQuantity::kPitch || curve.quantity == TankQuantity::kPitchSlope;
        if (same_quantity && std::fabs(curve.fn - std::stod(row[2])) < 0.005) {
          found = true;
          EXPECT_EQ(curve.num_figures, std::stoi(row[4])) << row[1];
          // One decimal is printed.
          EXPECT_NEAR(curve.peak_miss_percent, std::stod(row[variant == StripVariant::kOrdinary ? 6 : 7]),
                      0.06)
              << row[1] << " " << row[3] << ": sim/validation/comparison --page";
        }
      }
      EXPECT_TRUE(found) << row[1] << " " << row[3];
    }
  }
}

}  // namespace
}  // namespace quickstrip::hull_tool
