// Transfer functions, seas and hulls made by hand: what the response and advice rooms are tested with, so
// that the expected answer is a closed form and not strip theory's.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <initializer_list>

#include "core/base/constants.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/sea/energy_grid.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip::synthetic {

using MotionModel = std::function<MotionTransfer(double speed, double mu, double omega)>;

/// Wave frequencies 0.2 ... 1.8 rad/s, speeds 0, step, 2 step ... [m/s]; low encounter: |omega_e| < 0.1
/// rad/s.
inline void fill(TransferFunctions& out, std::size_t num_speeds, double speed_step,
                 std::size_t num_frequencies, const MotionModel& model) {
  out.num_speeds = num_speeds;
  out.num_frequencies = num_frequencies;
  out.gravity = kStandardGravity;
  for (std::size_t f = 0; f < num_frequencies; ++f) {
    out.omega[f] = 0.2 + 1.6 * static_cast<double>(f) / static_cast<double>(num_frequencies - 1);
    out.wave_number[f] = out.omega[f] * out.omega[f] / kStandardGravity;
    out.encounter_floor[f] = 0.1;
  }
  for (std::size_t v = 0; v < num_speeds; ++v) {
    out.speeds[v] = speed_step * static_cast<double>(v);
    for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
      const double mu = kPi * static_cast<double>(m) / static_cast<double>(kNumSolvedDirections - 1);
      for (std::size_t f = 0; f < num_frequencies; ++f) {
        store_motions(model(out.speeds[v], mu, out.omega[f]).motion, f, out.row[v][m]);
      }
    }
  }
}

/// A small ship, roughly: everything goes to the wave's own motion in long waves and dies out in short ones;
/// roll has a resonance at 0.6 rad/s. Phases as of a raft (NOTATION.md).
inline MotionTransfer shiplike(double speed, double mu, double omega) {
  using namespace std::complex_literals;
  const double k = omega * omega / kStandardGravity;
  const double omega_e = omega - k * speed * std::cos(mu);
  const double smooth = std::exp(-std::pow(k * 20.0, 2));
  const double tuning = omega_e * omega_e / (0.6 * 0.6);
  const std::complex<double> resonance = 1.0 / (1.0 - tuning + 0.2i * std::sqrt(tuning));
  MotionTransfer transfer;
  transfer.motion[0] = -1i * std::cos(mu) * smooth;
  transfer.motion[1] = -1i * std::sin(mu) * smooth;
  transfer.motion[2] = smooth;
  transfer.motion[3] = -1i * k * std::sin(mu) * resonance;
  transfer.motion[4] = 1i * k * std::cos(mu) * smooth;
  transfer.motion[5] = 0.2 * k * std::sin(2.0 * mu) * smooth;
  return transfer;
}

/// A system that is one band: node energies times a factor by direction. Systems in increasing order.
inline SystemEnergy& append_system(SeaEnergy& sea, const TransferFunctions& transfer) {
  sea.num_frequencies = transfer.num_frequencies;
  add_band(sea);
  SystemEnergy& part = sea.part[sea.num_systems];
  part.first = sea.num_systems++;
  part.count = 1;
  part.factor[part.first].fill(0.0);
  return part;
}

/// Bounds and transforms after bands and factors are set.
inline void close(SeaEnergy& sea, double hs) {
  complete(1.0, 1.0, sea);
  sea.hs = hs;
}

/// Bretschneider of hs and tp coming from direction index `from`, spread over neighbours by cos^2 of half
/// width `half_width` nodes (0: one direction), as the next wave system.
inline void add_system(SeaEnergy& sea, const TransferFunctions& transfer, double hs, double tp,
                       std::size_t from, std::size_t half_width) {
  SystemEnergy& part = append_system(sea, transfer);
  const double omega_p = kTwoPi / tp;
  double sum = 0.0;
  EnergyBand& band = sea.band[part.first];
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    const double ratio = omega_p / transfer.omega[f];
    band.node[f] = std::pow(ratio, 5) * std::exp(-1.25 * std::pow(ratio, 4));
    sum += band.node[f];
  }
  for (double& energy : band.node) {
    energy *= hs * hs / 16.0 / sum;
  }
  const auto reach = static_cast<std::ptrdiff_t>(half_width);
  double whole = 0.0;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::ptrdiff_t j = -reach; j <= reach; ++j) {
      const auto d =
          static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from + kNumDirections) + j) % kNumDirections;
      const double spread = std::pow(std::cos(0.5 * kPi * static_cast<double>(j) / double(reach + 1)), 2);
      if (pass == 0) {
        whole += spread;
      } else {
        part.factor[part.first][d] = spread / whole;
      }
    }
  }
  close(sea, std::hypot(sea.hs, hs));
}

/// Waves of the given energies [m2] from one direction, as the next wave system.
struct Wave {
  std::size_t f = 0;
  double energy = 0.0;
};
inline void add_waves(SeaEnergy& sea, const TransferFunctions& transfer, std::size_t from,
                      std::initializer_list<Wave> waves) {
  SystemEnergy& part = append_system(sea, transfer);
  for (const Wave& wave : waves) {
    sea.band[part.first].node[wave.f] = wave.energy;
  }
  part.factor[part.first][from] = 1.0;
  close(sea, sea.hs);
}

/// All wave heights times `factor`.
inline void scale_heights(SeaEnergy& sea, double factor) {
  for (EnergyBand& band : sea.band) {
    for (double& energy : band.node) {
      energy *= factor * factor;
    }
  }
  close(sea, sea.hs * factor);
}

/// A box of 100 x 16 m, flat keel at z = 0, deck at 10 m; bridge aft on the port side, slamming station at
/// 90 m, freeboard at the bow.
inline void fill_box(Hull& hull) {
  hull = Hull{};
  hull.lpp = 100.0;
  hull.breadth = 16.0;
  for (const double x : {0.0, 25.0, 50.0, 75.0, 100.0}) {
    Station station;
    station.x = x;
    for (const Offset& offset : {Offset{0.0, 0.0}, Offset{8.0, 0.0}, Offset{8.0, 10.0}}) {
      static_cast<void>(station.offsets.push_back(offset));
    }
    static_cast<void>(hull.stations.push_back(station));
  }
  hull.loading.draught_aft = 5.0;
  hull.loading.draught_fwd = 4.0;
  hull.loading.kg = 6.0;
  static_cast<void>(hull.points.push_back({Name("bridge"), PointRole::kBridge, 20.0, 3.0, 20.0}));
  static_cast<void>(hull.points.push_back({Name("fp"), PointRole::kForwardPerpendicular, 100.0, 0.0, 10.0}));
  static_cast<void>(hull.slamming.push_back({Name("bow"), 90.0, std::nullopt}));
  static_cast<void>(hull.freeboard.push_back({Name("bow"), 100.0, 10.0}));
  hull.min_steerage_speed = 1.5;
  hull.grid = {.speed_from = 0.0, .speed_to = 8.0, .speed_step = 1.0, .heading_step = kPi / 36.0};
}

inline Hydrostatics box_hydrostatics() {
  Hydrostatics hydrostatics;
  hydrostatics.lcb = 48.0;
  hydrostatics.kg = 6.0;
  return hydrostatics;
}

}  // namespace quickstrip::synthetic
