#include "core/response/damped_motions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;
using Lateral = std::array<Complex, 3>;  // sway, roll, yaw
constexpr std::size_t kMoreLevels = kRollDampingLevels - 1;

// At every level beyond the first. `met`: |omega_e| as the equations saw it. Equations at a negative
// frequency are the conjugates of those at a positive one, and so are their roots.
std::array<Lateral, kMoreLevels> damp(const RollUpdate& update, double omega_e, double met, Lateral motion) {
  const RollChange change = roll_change(update.table, met);
  const bool is_conjugate = omega_e < 0.0;
  const auto turned = [is_conjugate](const Complex& z) { return is_conjugate ? std::conj(z) : z; };
  std::array<Lateral, kMoreLevels> out;
  out.fill(motion);
  if (change.is_negligible) {
    return out;
  }
  for (Complex& one : motion) {
    one = turned(one);
  }
  for (std::size_t l = 0; l < kMoreLevels; ++l) {
    const Complex resistance(0.0, met * (update.levels.added[l + 1] - update.levels.added[0]));
    const Complex less_roll = -motion[1] * resistance / (change.impedance + resistance);
    out[l] = {turned(motion[0] + change.sway_per_roll * less_roll), turned(motion[1] + less_roll),
              turned(motion[2] + change.yaw_per_roll * less_roll)};
  }
  return out;
}

template <typename Values>
Lateral read(const Values& re, const Values& im, std::size_t first, std::size_t stride, std::size_t i) {
  Lateral out;
  for (std::size_t j = 0; j < out.size(); ++j) {
    const std::size_t mode = first + stride * j;
    out[j] = {static_cast<double>(re[mode][i]), static_cast<double>(im[mode][i])};
  }
  return out;
}

template <typename Values>
void write(const Lateral& motion, std::size_t i, Values& re, Values& im) {
  for (std::size_t j = 0; j < motion.size(); ++j) {
    re[j][i] = static_cast<float>(motion[j].real());
    im[j][i] = static_cast<float>(motion[j].imag());
  }
}

}  // namespace

void damp_motions(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                  const Encounters& encounters, std::span<LateralMotions, kMoreLevels> out) {
  const RollUpdate& update = transfer.roll_update[speed];
  QS_CHECK(update.levels.count == kRollDampingLevels);
  const MotionRow& row = transfer.row[speed][solved_m];
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    const double omega_e = encounters.frequency[f];
    const double met = std::max(std::fabs(omega_e), transfer.encounter_floor[f]);
    const auto damped = damp(update, omega_e, met, read(row.re, row.im, 1, 2, f));
    for (std::size_t l = 0; l < kMoreLevels; ++l) {
      write(damped[l], f, out[l].re, out[l].im);
    }
  }
  const RollPeak& peak = transfer.peak[speed][solved_m];
  PointValues omega_e{};
  list_point_encounters(transfer, speed, solved_m, omega_e);
  for (std::size_t p = 0; p < peak.num_points; ++p) {
    const auto damped = damp(update, omega_e[p], std::fabs(omega_e[p]), read(peak.re, peak.im, 0, 1, p));
    for (std::size_t l = 0; l < kMoreLevels; ++l) {
      write(damped[l], p, out[l].point_re, out[l].point_im);
    }
  }
}

}  // namespace quickstrip
