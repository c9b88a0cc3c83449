#include "core/strip/wave_at_speeds.hpp"

#include <cmath>

namespace quickstrip {
namespace {

// Sums against the slope of the half-breadth, of the wave's elevation: |e| = 1.
SquareSums elevation_sums(const LoadedHull& hull, const AlongHull& elevation) {
  std::array<ComplexSectionValues, 2> weighted;
  std::array<ComplexSectionValues, 2> slope;
  weigh_velocity(hull, elevation, weighted, slope);
  SquareSums out;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out.plain += hull.half_breadth[i] * pair_of(slope[0][i]);
    out.by_x += hull.half_breadth[i] * pair_of(slope[1][i]);
  }
  for (int n = 0; n < 3; ++n) {
    out.moments[static_cast<std::size_t>(n)] = integral_of_slope(hull, hull.half_breadth, n);
  }
  out.square = out.moments[0];
  return out;
}

double moment(const LengthStencil& s,
              std::array<std::array<double, 3>, kNumStripQuantities> LengthIntegrals::*kind, StripQuantity q,
              std::size_t n) {
  return s.weight[0] * (s.at[0]->*kind)[q][n] + s.weight[1] * (s.at[1]->*kind)[q][n] +
         s.weight[2] * (s.at[2]->*kind)[q][n];
}

// As radiated_energy_resistance() has it, published power.
double radiated_energy(const WaveSums& sums, const LengthStencil& integrals, double k_cos_mu,
                       const MotionTransfer& motion, double speed) {
  const Complex i_omega_e(0.0, motion.encounter_frequency);
  const Complex a = i_omega_e * motion.motion[2] + speed * motion.motion[4];
  const Complex b = -i_omega_e * motion.motion[4];
  SquareSums damped{sums.b33[kHeaveQ][1], sums.b33[kHeaveV0], sums.b33[kHeaveV1], {}};
  SquareSums swept{sums.a33[kHeaveQ][0], sums.a33[kHeaveS0], sums.a33[kHeaveS1], {}};
  for (std::size_t n = 0; n < 3; ++n) {
    damped.moments[n] = moment(integrals, &LengthIntegrals::plain, kB33, n);
    swept.moments[n] = moment(integrals, &LengthIntegrals::slope, kA33, n);
  }
  return -k_cos_mu / (2.0 * motion.encounter_frequency) * (damped.of(a, b) - speed * swept.of(a, b));
}

double resistance_of(const LoadedHull& hull, const WaveWork& work, const WaveSums& sums,
                     const LengthStencil& integrals, const SolvedSpeed& solved, double speed) {
  const double cos_mu = work.cos_mu;
  if (!(cos_mu < -kCosineOfBeam)) {
    const double behind = integrated_pressure_resistance(
        hull, work.elevation.of(solved.transfer.motion[2], -solved.transfer.motion[4]), solved.transfer);
    return cos_mu > kCosineOfBeam ? behind : 0.5 * behind;
  }
  if (radiated_power_of(hull.method.variant) != RadiatedPower::kPublished) {
    return added_resistance(hull, work.resistance, solved.transfer, speed);
  }
  return radiated_energy(sums, integrals, work.met.k_cos_mu, solved.transfer, speed);
}

}  // namespace

double SquareSums::of(Complex a, Complex b) const {
  const auto real_of_product = [](Complex p, Pair q) { return p.real() * q[0] + p.imag() * q[1]; };
  const double ab = a.real() * b.real() + a.imag() * b.imag();
  return square - 2.0 * (real_of_product(a, plain) + real_of_product(b, by_x)) +
         (std::norm(a) * moments[0] + 2.0 * ab * moments[1] + std::norm(b) * moments[2]);
}

template <auto SumUp>
WaveSumsStencil NodeSums::stencil(const LoadedHull& hull, const WaveColumns& columns,
                                  const NodeStencil& nodes) {
  WaveSumsStencil out;
  out.weight = nodes.weight;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t node = nodes.first + k;
    const std::size_t place = node % kPlaces;
    if (held_[place] != node) {
      SectionHydrodynamics room;
      SumUp(hull, columns, node_hydrodynamics(hull, node, room), sums_[place]);
      held_[place] = static_cast<std::uint8_t>(node);
    }
    out.at[k] = &sums_[place];
  }
  return out;
}

void NodeSums::at(const LoadedHull& hull, const WaveColumns& columns, const NodeStencil& nodes,
                  double omega_e, WaveSums& out) {
  if (nodes.is_inside) {
    interpolate(hull, stencil<&sum_up>(hull, columns, nodes), out);
    return;
  }
  SectionHydrodynamics section;
  section_hydrodynamics(hull, omega_e, section);
  sum_up(hull, columns, section, out);
}

void NodeSums::lateral_at(const LoadedHull& hull, const WaveColumns& columns, const NodeStencil& nodes,
                          double omega_e, WaveSums& out) {
  if (nodes.is_inside) {
    interpolate_lateral(hull, stencil<&sum_up_lateral>(hull, columns, nodes), out);
    return;
  }
  SectionHydrodynamics section;
  section_hydrodynamics(hull, omega_e, section);
  sum_up_lateral(hull, columns, section, out);
}

LengthStencil length_stencil(const LoadedHull& hull, const NodeStencil& nodes, double omega_e,
                             LengthIntegrals& outside) {
  if (!nodes.is_inside) {
    length_integrals(hull, omega_e, outside);
    return {{&outside, &outside, &outside}, {1.0, 0.0, 0.0}};
  }
  const LengthIntegrals* const first = &hull.node_integrals[nodes.first];
  return {{first, first + 1, first + 2}, nodes.weight};
}

void set_wave(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
              const SectionDiffraction* diffraction, WaveWork& work) {
  resistance_wave(hull, omega, mu, sections, work.resistance);
  wave_field(hull, omega, mu, work.resistance.elevation, sections, diffraction, work.field);
  arrange(hull, work.field, &work.resistance, work.columns);
  work.met = met_wave(hull, omega, mu);
  work.cos_mu = std::cos(mu.radians);
  work.nodes.forget();
  work.elevation = elevation_sums(hull, work.resistance.elevation);
}

std::array<SolvedSpeed, 2> solve_speeds(const LoadedHull& hull, const ShipTerms& ship,
                                        const std::array<SpeedTerms, 2>& speeds, WaveWork& work) {
  std::array<SolvedSpeed, 2> out;
  MotionPair at{};
  std::array<bool, 2> is_forced_to_zero{};
  for (std::size_t l = 0; l < 2; ++l) {
    const FlooredEncounter met = work.met.at(speeds[l].speed);
    out[l].transfer.encounter_frequency = met.encounter.frequency;
    out[l].transfer.low_encounter = met.encounter.is_low;
    is_forced_to_zero[l] =
        met.encounter.is_low && hull.method.low_encounter == LowEncounterRule::kPaper;  // [Journee1992] §2
    at.omega_e[l] = met.floored;
    at.speed[l] = speeds[l].speed;
  }
  const std::array<NodeStencil, 2> nodes = node_stencils(hull, at.omega_e);
  ThreePair vertical;
  ThreePair lateral;
  for (std::size_t l = 0; l < 2; ++l) {
    const double omega_e = at.omega_e[l];
    at.integrals[l] = length_stencil(hull, nodes[l], omega_e, work.outside[l]);
    work.nodes.at(hull, work.columns, nodes[l], omega_e, work.sums[l]);
    const std::array<Pair, 6> load = loads_of(hull, work.columns, work.sums[l], omega_e, speeds[l].speed);
    for (std::size_t r = 0; r < 3; ++r) {
      vertical[r].re[l] = load[2 * r][0];
      vertical[r].im[l] = load[2 * r][1];
      lateral[r].re[l] = load[2 * r + 1][0];
      lateral[r].im[l] = load[2 * r + 1][1];
      out[l].load[r] = is_forced_to_zero[l] ? Complex{} : complex_of(load[2 * r + 1]);
    }
  }
  vertical = solve_vertical(ship, at, vertical);
  lateral = solve_lateral(ship, at, pair_of(speeds[0].roll_damping, speeds[1].roll_damping), lateral);
  for (std::size_t l = 0; l < 2; ++l) {
    if (!is_forced_to_zero[l]) {
      for (std::size_t r = 0; r < 3; ++r) {
        out[l].transfer.motion[2 * r] = lane(vertical[r], static_cast<int>(l));
        out[l].transfer.motion[2 * r + 1] = lane(lateral[r], static_cast<int>(l));
      }
    }
    out[l].added_resistance =
        resistance_of(hull, work, work.sums[l], at.integrals[l], out[l], speeds[l].speed);
  }
  return out;
}

}  // namespace quickstrip
