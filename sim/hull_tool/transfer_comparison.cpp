#include "sim/hull_tool/transfer_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/response/point_motion.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip::hull_tool {
namespace {

std::vector<MotionTransfer> own_motions(const LoadedHull& hull, const std::vector<TransferValue>& values) {
  std::vector<MotionTransfer> out;
  for (const TransferValue& value : values) {
    const EncounterAngle mu{wrap_pi(radians(value.mu_deg))};
    out.push_back(motion_transfer(hull, value.omega, mu, from_knots(value.speed_kn)));
  }
  return out;
}

double amplitude_of(const LoadedHull& hull, const TransferValue& value, const MotionTransfer& transfer,
                    ComparisonPoint point) {
  if (point == ComparisonPoint::kGravity || value.motion > 2) {
    return std::abs(transfer.motion[value.motion]);
  }
  const PointMotion moved = point_displacement(transfer, {0.0, 0.0, -hull.g_height});
  return std::abs(value.motion == 0 ? moved.x : value.motion == 1 ? moved.y : moved.z);
}

bool is_in_window(const LoadedHull& hull, const TransferValue& value, const ComparisonWindow& window) {
  const EncounterAngle mu{wrap_pi(radians(value.mu_deg))};
  const double encounter = encounter_frequency(value.omega, wave_number(value.omega, hull.gravity),
                                               from_knots(value.speed_kn), mu);
  return value.omega > window.omega_from && value.omega < window.omega_to &&
         encounter > window.encounter_from;
}

CurveDeviation& curve_of(std::vector<CurveDeviation>& curves, const TransferValue& value) {
  const auto same = [&](const CurveDeviation& c) {
    return c.speed_kn == value.speed_kn && c.mu_deg == value.mu_deg && c.motion == value.motion;
  };
  const auto found = std::find_if(curves.begin(), curves.end(), same);
  if (found != curves.end()) {
    return *found;
  }
  curves.push_back({.speed_kn = value.speed_kn, .mu_deg = value.mu_deg, .motion = value.motion});
  return curves.back();
}

void set_scales(std::vector<CurveDeviation>& curves) {
  for (CurveDeviation& curve : curves) {
    double largest = 0.0;
    for (const CurveDeviation& other : curves) {
      if (other.speed_kn == curve.speed_kn && other.motion == curve.motion) {
        largest = std::max(largest, other.peak);
      }
    }
    curve.scale = std::max(curve.peak, 0.25 * largest);
  }
}

}  // namespace

std::vector<CurveDeviation> compare_transfer(const LoadedHull& hull, const std::vector<TransferValue>& values,
                                             const ComparisonWindow& window, ComparisonPoint point,
                                             const MotionSolver& solve) {
  std::vector<TransferValue> counted;
  std::copy_if(values.begin(), values.end(), std::back_inserter(counted),
               [&](const TransferValue& v) { return is_in_window(hull, v, window); });
  std::vector<CurveDeviation> curves;
  for (const TransferValue& value : counted) {
    CurveDeviation& curve = curve_of(curves, value);
    curve.peak = std::max(curve.peak, value.amplitude);
  }
  set_scales(curves);
  std::erase_if(curves, [](const CurveDeviation& c) { return !(c.scale > 0.0); });
  const std::vector<MotionTransfer> motions = solve ? solve(counted) : own_motions(hull, counted);
  for (std::size_t n = 0; n < counted.size(); ++n) {
    const TransferValue& value = counted[n];
    const auto at = std::find_if(curves.begin(), curves.end(), [&](const CurveDeviation& c) {
      return c.speed_kn == value.speed_kn && c.mu_deg == value.mu_deg && c.motion == value.motion;
    });
    if (at == curves.end()) {
      continue;
    }
    const double percent =
        100.0 * (amplitude_of(hull, value, motions[n], point) - value.amplitude) / at->scale;
    at->rms_percent += percent * percent;
    ++at->num_frequencies;
    if (std::fabs(percent) >= std::fabs(at->worst_percent)) {
      at->worst_percent = percent;
      at->worst_omega = value.omega;
    }
  }
  for (CurveDeviation& curve : curves) {
    curve.rms_percent = std::sqrt(curve.rms_percent / static_cast<double>(curve.num_frequencies));
  }
  return curves;
}

}  // namespace quickstrip::hull_tool
