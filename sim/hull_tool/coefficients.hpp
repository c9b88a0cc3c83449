// The listing of section coefficients, for the command and its test.
#pragma once

#include <string>
#include <vector>

namespace quickstrip::hull_tool {

enum class CoefficientSource { kTable, kDirect };

struct CoefficientOptions {
  std::vector<double> h0;
  std::vector<double> sigma;
  std::vector<double> xi;
  CoefficientSource source = CoefficientSource::kTable;
};

/// h0,sigma,xi,a22,b22,a33,b33,a44,b44,a24,b24: the normalised values of section_coefficients.hpp.
/// InputError where there is no such section.
std::string coefficients_csv(const CoefficientOptions& options);

}  // namespace quickstrip::hull_tool
