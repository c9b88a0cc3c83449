#include "core/response/damped_motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

// What the ship answers to a roll moment at a list of frequencies of encounter, in single precision as the
// motions are; set for as many frequencies as there are.
template <std::size_t N>
struct Answers {
  using Values = std::array<float, N>;
  Values met;   // |omega_e| as the equations saw it; 0 where damping does not matter
  Values side;  // -1 where omega_e is negative: equations, and so their roots, are conjugates there
  std::array<Values, kNumRollAnswers> answer;

  void set(const RollUpdateTable& table, std::size_t i, double omega_e, double floor) {
    const double met_here = std::max(std::fabs(omega_e), floor);
    const bool matters = is_tabulated(table, met_here);
    const RollAnswers here = matters ? roll_answers(table, met_here) : RollAnswers{};
    met[i] = matters ? static_cast<float>(met_here) : 0.0F;
    side[i] = omega_e < 0.0 ? -1.0F : 1.0F;
    for (std::size_t a = 0; a < kNumRollAnswers; ++a) {
      answer[a][i] = here[a];
    }
  }
};

// Sway, roll and yaw, real and imaginary parts.
template <std::size_t N>
using Lateral = std::array<std::array<float, N>, 3>;

// One addition: roll + less, less = -roll z / (D + z), z = more stiffness + i r, r = omega_e more damping;
// sway and yaw follow it. No branches: the compiler makes vectors of it.
template <std::size_t N>
void damp(const Answers<N>& at, std::size_t n, const RollAddition& more,
          const std::array<std::span<const float, N>, 3>& re,
          const std::array<std::span<const float, N>, 3>& im, Lateral<N>& out_re, Lateral<N>& out_im) {
  const auto added = static_cast<float>(more.damping);
  const auto stiffer = static_cast<float>(more.stiffness);
  for (std::size_t i = 0; i < n; ++i) {
    const float r = at.met[i] * added;
    const float s = at.met[i] > 0.0F ? stiffer : 0.0F;
    const float a = at.answer[kImpedanceRe][i] + s;
    const float b = at.answer[kImpedanceIm][i] + r;
    const float factor = -1.0F / std::max(a * a + b * b, std::numeric_limits<float>::min());
    const float p = factor * (s * a + r * b);
    const float q = factor * (r * a - s * b);
    const float roll_im = at.side[i] * im[1][i];
    const float less_re = re[1][i] * p - roll_im * q;
    const float less_im = re[1][i] * q + roll_im * p;
    const float s_re = at.answer[kSwayRe][i];
    const float s_im = at.answer[kSwayIm][i];
    const float y_re = at.answer[kYawRe][i];
    const float y_im = at.answer[kYawIm][i];
    out_re[0][i] = re[0][i] + s_re * less_re - s_im * less_im;
    out_im[0][i] = im[0][i] + at.side[i] * (s_re * less_im + s_im * less_re);
    out_re[1][i] = re[1][i] + less_re;
    out_im[1][i] = im[1][i] + at.side[i] * less_im;
    out_re[2][i] = re[2][i] + y_re * less_re - y_im * less_im;
    out_im[2][i] = im[2][i] + at.side[i] * (y_re * less_im + y_im * less_re);
  }
}

}  // namespace

void damp_motions(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                  const Encounters& encounters, std::span<const RollAddition> additions,
                  std::span<LateralMotions> out) {
  QS_CHECK(additions.size() <= out.size());
  const RollUpdate& update = transfer.roll_update[speed];
  const MotionRow& row = transfer.row[speed][solved_m];
  const RollPeak& peak = transfer.peak[speed][solved_m];
  Answers<kMaxFrequencies> at_nodes;
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    at_nodes.set(update.table, f, encounters.frequency[f], transfer.encounter_floor[f]);
  }
  Answers<kMaxPeakPoints> at_points;
  for (std::size_t p = 0; p < peak.num_points; ++p) {
    at_points.set(update.table, p, encounters.at_points[p], 0.0);  // points keep off the floor
  }
  for (std::size_t i = 0; i < additions.size(); ++i) {
    damp<kMaxFrequencies>(at_nodes, transfer.num_frequencies, additions[i], {row.re[1], row.re[3], row.re[5]},
                          {row.im[1], row.im[3], row.im[5]}, out[i].re, out[i].im);
    damp<kMaxPeakPoints>(at_points, peak.num_points, additions[i], {peak.re[0], peak.re[1], peak.re[2]},
                         {peak.im[0], peak.im[1], peak.im[2]}, out[i].point_re, out[i].point_im);
  }
}

}  // namespace quickstrip
