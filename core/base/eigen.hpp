// The one door through which Eigen enters core: no allocation, and Eigen's own assertions always on.
// With -DNDEBUG alone Eigen 3.4 allocates despite EIGEN_NO_MALLOC, hence the mapping of eigen_assert.
#pragma once

#include "core/base/check.hpp"

#define EIGEN_NO_MALLOC
#define eigen_assert(claim) QS_CHECK(claim)
#include <Eigen/Core>
#include <Eigen/LU>
