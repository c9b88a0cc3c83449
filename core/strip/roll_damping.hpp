// Roll damping beyond potential theory. For now a ratio of critical damping; Ikeda's components follow.
#pragma once

namespace quickstrip {

struct LoadedHull;

/// omega_n [rad/s] of undamped roll: (I_xx + a44(omega_n)) omega_n^2 = c44. Fixed 40 bisections on
/// 0.02 ... 20 times the value without a44: |error| < 1e-10 of it.
double roll_natural_frequency(const LoadedHull& hull);

/// b44 [N m s] = 2 ratio c44 / omega_n, with the natural frequency already in `hull` (contract §2, method
/// "ratio").
double ratio_roll_damping(const LoadedHull& hull, double ratio);

}  // namespace quickstrip
