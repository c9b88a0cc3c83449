#include <cmath>

#include "sim/hull_tool/hull_scale.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::test {

Hull scaled(const Hull& hull, double scale) {
  Hull out = hull;
  hull_tool::scale_by_froude(out, scale);
  out.loading.viscosity *= std::pow(scale, 1.5);
  return out;
}

}  // namespace quickstrip::test
