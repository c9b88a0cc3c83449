#include "sim/parent/mapping_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/constants.hpp"
#include "sim/section_table/linear_solve.hpp"

namespace quickstrip {
namespace {

constexpr int kNumSamples = 240;   // along the contour
constexpr int kMostSteps = 40;     // of Gauss and Newton; ten are usual
constexpr int kGrid = 240;         // of theta, among which the nearest point is looked for
constexpr int kWindow = 24;        // ... this far from where it was
constexpr double kSettled = 1e-7;  // relative change of the sum of squares

double frequency(std::size_t k) {
  return k == 0 ? 1.0 : 2.0 * static_cast<double>(k) - 1.0;
}

// Point, first and second derivative by theta.
struct CurvePoint {
  Offset point;
  Offset slope;
  Offset bend;
};
CurvePoint curve_point(const MappingFit& fit, double theta) {
  const std::complex<double> turn = std::polar(1.0, theta);
  const std::complex<double> twice = turn * turn;
  std::complex<double> harmonic = turn;  // of Z, then of Z^{-(2n-1)}
  double cosine = fit.powers[0] * turn.real();
  double sine = fit.powers[0] * turn.imag();
  CurvePoint at{{sine, -cosine}, {cosine, sine}, {-sine, cosine}};
  for (std::size_t n = 1; n <= fit.num_coefficients; ++n) {
    const double f = frequency(n);
    cosine = fit.powers[n] * harmonic.real();
    sine = fit.powers[n] * harmonic.imag();
    at.point.y -= sine;
    at.point.z -= cosine;
    at.slope.y -= f * cosine;
    at.slope.z += f * sine;
    at.bend.y += f * f * sine;
    at.bend.z += f * f * cosine;
    harmonic *= twice;
  }
  return at;
}

double squared_distance(const Offset& p, const Offset& q) {
  return (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
}

// Newton on (w - p) . dw/dtheta = 0 near `theta`.
double nearest_angle(const MappingFit& fit, const Offset& p, double theta) {
  constexpr double kStep = 0.5 * kPi / kGrid;
  double angle = theta;
  for (int n = 0; n < 6; ++n) {
    const CurvePoint at = curve_point(fit, angle);
    const double dy = at.point.y - p.y;
    const double dz = at.point.z - p.z;
    const double gradient = dy * at.slope.y + dz * at.slope.z;
    const double speed2 = at.slope.y * at.slope.y + at.slope.z * at.slope.z;
    const double curvature = speed2 + dy * at.bend.y + dz * at.bend.z;
    const double step = -gradient / std::max(curvature, 0.2 * speed2);
    angle = std::clamp(angle + std::clamp(step, -kStep, kStep), 0.0, 0.5 * kPi);
    if (std::abs(step) < 1e-10) {
      break;
    }
  }
  return angle;
}

}  // namespace

MappingFitter::MappingFitter(const SectionContour& contour) {
  const std::vector<Offset>& points = contour.points;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::sqrt(squared_distance(points[i], points[i - 1]));
  }
  samples_.push_back({points.front(), 0.0, 0.0});
  double along = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double side = std::sqrt(squared_distance(points[i], points[i - 1]));
    const int pieces = std::max(1, static_cast<int>(std::lround(kNumSamples * side / length)));
    const double weight = side / length / pieces;
    for (int j = 1; j <= pieces; ++j) {
      const double t = static_cast<double>(j) / pieces;
      samples_.back().weight += 0.5 * weight;
      samples_.push_back({{points[i - 1].y + t * (points[i].y - points[i - 1].y),
                           points[i - 1].z + t * (points[i].z - points[i - 1].z)},
                          0.5 * weight,
                          0.5 * kPi * (along + t * side) / length});
    }
    along += side;
  }
  // The ellipse of this breadth and draught.
  fit_.powers[0] = 0.5 * (contour.half_breadth() + contour.draught());
  fit_.powers[1] = 0.5 * (contour.draught() - contour.half_breadth());
}

void MappingFitter::project(const MappingFit& fit, std::vector<Sample>& samples) const {
  std::array<Offset, kGrid + 1> curve;
  for (std::size_t j = 0; j < curve.size(); ++j) {
    curve[j] = curve_point(fit, 0.5 * kPi * static_cast<double>(j) / kGrid).point;
  }
  for (Sample& sample : samples) {
    const int last = static_cast<int>(std::lround(sample.theta / (0.5 * kPi) * kGrid));
    int nearest = last;
    double least = INFINITY;
    for (int j = std::max(0, last - kWindow); j <= std::min(kGrid, last + kWindow); ++j) {
      const double distance = squared_distance(curve[static_cast<std::size_t>(j)], sample.point);
      if (distance < least) {
        least = distance;
        nearest = j;
      }
    }
    sample.theta = nearest_angle(fit, sample.point, 0.5 * kPi * nearest / kGrid);
  }
}

// Least squares of the distances along the normals, linear in the powers; breadth and draught stay.
MappingFit MappingFitter::step(const MappingFit& fit, double damping) const {
  const std::size_t n = fit.num_coefficients + 1;
  const std::size_t size = n + 2;
  std::vector<double> matrix(size * size, 0.0);
  std::vector<double> change(size, 0.0);
  std::array<double, kMaxMappingCoefficients + 1> row{};
  for (const Sample& sample : samples_) {
    const CurvePoint at = curve_point(fit, sample.theta);
    const double speed = std::hypot(at.slope.y, at.slope.z);
    const double ny = at.slope.z / speed;
    const double nz = -at.slope.y / speed;
    const double error = ny * (sample.point.y - at.point.y) + nz * (sample.point.z - at.point.z);
    const std::complex<double> turn = std::polar(1.0, sample.theta);
    std::complex<double> harmonic = turn;
    for (std::size_t k = 0; k < n; ++k) {
      row[k] = (k == 0 ? ny : -ny) * harmonic.imag() - nz * harmonic.real();
      harmonic *= k == 0 ? 1.0 : turn * turn;
      change[k] += sample.weight * error * row[k];
      for (std::size_t j = 0; j <= k; ++j) {
        matrix[k * size + j] += sample.weight * row[j] * row[k];
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      matrix[j * size + k] = matrix[k * size + j];
    }
    matrix[k * size + k] += damping * frequency(k);
    matrix[n * size + k] = matrix[k * size + n] = k % 2 == 0 ? 1.0 : -1.0;  // breadth
    matrix[(n + 1) * size + k] = matrix[k * size + n + 1] = 1.0;            // draught
  }
  solve_in_place(matrix, change, size, 1);
  MappingFit next = fit;
  for (std::size_t k = 0; k < n; ++k) {
    next.powers[k] += change[k];
  }
  return next;
}

MappingFit MappingFitter::next() {
  fit_.num_coefficients += 1;
  const auto measure = [](MappingFit& fit, const std::vector<Sample>& samples) {
    double squares = 0.0;
    fit.largest_error = 0.0;
    for (const Sample& sample : samples) {
      const double distance2 = squared_distance(curve_point(fit, sample.theta).point, sample.point);
      squares += sample.weight * distance2;
      fit.largest_error = std::max(fit.largest_error, std::sqrt(distance2));
    }
    fit.rms_error = std::sqrt(squares);
  };
  project(fit_, samples_);
  measure(fit_, samples_);
  if (fit_.num_coefficients == 1) {
    return fit_;  // breadth and draught alone
  }
  double damping = 1e-4;
  for (int step_number = 0; step_number < kMostSteps && damping < 1e4; ++step_number) {
    MappingFit tried = step(fit_, damping);
    std::vector<Sample> samples = samples_;
    project(tried, samples);
    measure(tried, samples);
    if (!(tried.rms_error < fit_.rms_error)) {
      damping *= 10.0;
      continue;
    }
    const double gain = 1.0 - tried.rms_error / fit_.rms_error;
    fit_ = tried;
    samples_ = std::move(samples);
    damping = std::max(0.1 * damping, 1e-9);
    if (gain < kSettled) {
      break;
    }
  }
  return fit_;
}

}  // namespace quickstrip
