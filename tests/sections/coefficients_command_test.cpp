#include "sim/hull_tool/coefficients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>

#include "msgs/cli/run_tool.hpp"
#include "tests/sections/golden_sections.hpp"

namespace quickstrip::hull_tool {
namespace {

std::array<double, 11> first_row(const std::string& csv) {
  std::stringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::stringstream cells(line);
  std::array<double, 11> row{};
  for (double& value : row) {
    std::string cell;
    std::getline(cells, cell, ',');
    value = std::stod(cell);
  }
  return row;
}

TEST(CoefficientsCommand, PrintsTheContractsColumnsInTheContractsNormalisation) {
  const test::GoldenSection golden = test::golden_sections().front();
  for (const auto source : {CoefficientSource::kTable, CoefficientSource::kDirect}) {
    const std::string csv = coefficients_csv({{golden.h0}, {golden.sigma}, {golden.xi}, source});
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "h0,sigma,xi,a22,b22,a33,b33,a44,b44,a24,b24");
    const std::array<double, 11> row = first_row(csv);
    for (std::size_t k = 0; k < golden.values.size(); ++k) {
      EXPECT_NEAR(row[3 + k], golden.values[k], 5e-3 * golden.values[k]);  // the table's interpolation
    }
  }
}

TEST(CoefficientsCommand, NamesTheBoundsOfSigma) {
  const CoefficientOptions options{{1.0}, {1.3}, {0.5}, CoefficientSource::kTable};
  try {
    coefficients_csv(options);
    FAIL() << "no Lewis form has sigma 1.3 at H0 1";
  } catch (const InputError& error) {
    EXPECT_NE(error.line.find("0.2945 ... 1.1781"), std::string::npos) << error.line;
  }
}

}  // namespace
}  // namespace quickstrip::hull_tool
