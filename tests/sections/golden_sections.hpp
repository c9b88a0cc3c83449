// Reader of tests/golden/lewis_reference.csv: coefficients of Lewis sections by a boundary-element solution.
#pragma once

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace quickstrip::test {

struct GoldenSection {
  double h0 = 0.0;
  double sigma = 0.0;
  double a1 = 0.0;
  double a3 = 0.0;
  double xi = 0.0;
  std::array<double, 8> values{};  // a22 b22 a33 b33 a44 b44 a24 b24
};

inline std::vector<GoldenSection> golden_sections() {
  std::ifstream file(QUICKSTRIP_SOURCE_DIR "/tests/golden/lewis_reference.csv");
  std::vector<GoldenSection> rows;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'H') {
      continue;
    }
    std::stringstream cells(line);
    std::string cell;
    std::vector<double> v;
    for (int i = 0; std::getline(cells, cell, ','); ++i) {
      v.push_back(i == 2 ? 0.0 : std::stod(cell));
    }
    GoldenSection row{v.at(0), v.at(1), v.at(3), v.at(4), v.at(5), {}};
    for (std::size_t k = 0; k < 8; ++k) {
      row.values[k] = v.at(6 + k);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace quickstrip::test
