#include "tests/bench/loading_work.hpp"

#include <bitset>
#include <cmath>

#include "core/strip/equations_of_motion.hpp"

namespace quickstrip::bench {
namespace {

// A point of a contour in a wave: sine and cosine 38, exponential 30, sums 14.
constexpr double kPerPoint = 82.0;
// A section in a wave: phase 38, pressure 25, loads and velocities 110.
constexpr double kPerSection = 173.0;
// Complex sums over the sections at a node, of a33, b33, a22, b22, a24, b24: four flops a section each.
constexpr double kSumsOfNode = 17.0;
constexpr double kLateralSumsOfNode = 9.0;
// A solution: sums between nodes 170, integrals 135, loads 90, assembly 150, vertical set 190, lateral set
// 270, added resistance 80, logarithm and weights 45.
constexpr double kPerSolution = 1130.0;
// A point of the peak: loads 100 (Lagrange through six, or sums between nodes), integrals 90, assembly 90,
// lateral set 270, logarithm and weights 45.
constexpr double kPerPeakPoint = 595.0;

double contour_points(const LoadedHull& hull) {
  double out = 0.0;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out += static_cast<double>(hull.wave_contour[i].count) + 1.0;  // and the waterline
  }
  return out;
}

// Nodes that the speeds of one wave need.
double nodes_of(const LoadedHull& hull, const TransferFunctions& transfer, std::size_t m, std::size_t f) {
  std::bitset<kNumEncounterNodes> needed;
  for (std::size_t v = 0; v < transfer.num_speeds; ++v) {
    const double met = met_wave(hull, transfer.omega[f], solved_angle(m)).at(transfer.speeds[v]).floored;
    const NodeStencil nodes = node_stencil(hull, met);
    for (std::size_t k = 0; k < 3 && nodes.is_inside; ++k) {
      needed.set(nodes.first + k);
    }
  }
  return static_cast<double>(needed.count());
}

}  // namespace

LoadingWork loading_work(const LoadedHull& hull, const TransferFunctions& transfer) {
  LoadingWork out;
  const auto sections = static_cast<double>(hull.num_sections);
  const auto frequencies = static_cast<double>(transfer.num_frequencies);
  constexpr double kDirections = kNumSolvedDirections;
  constexpr double kMirrored = kNumSolvedDirections / 2 + 1;
  const double points = contour_points(hull);
  out.contours =
      kMirrored * frequencies * points * kPerPoint + kDirections * frequencies * sections * kPerSection;
  double nodes = 0.0;
  double peak_points = 0.0;
  for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
    for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
      nodes += nodes_of(hull, transfer, m, f);
    }
    for (std::size_t v = 0; v < transfer.num_speeds; ++v) {
      peak_points += static_cast<double>(transfer.peak[v][m].num_points);
    }
  }
  out.sums = nodes * kSumsOfNode * 4.0 * sections;
  out.solutions = kDirections * frequencies * static_cast<double>(transfer.num_speeds) * kPerSolution;
  out.peaks = peak_points * kPerPeakPoint;
  // Contours once a wave, six coefficients a node, what is stored once.
  out.bytes =
      kMirrored * frequencies * points * 3.0 * sizeof(double) + nodes * 6.0 * sections * sizeof(double) +
      static_cast<double>(sizeof(transfer.row) + sizeof(transfer.peak) + sizeof(transfer.added_resistance));
  return out;
}

}  // namespace quickstrip::bench
