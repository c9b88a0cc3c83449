#include "core/strip/empirical_added_resistance.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr double kFullBreadth = 0.99;

struct Range {
  double above;
  double below;
  [[nodiscard]] bool holds(double value) const { return value > above && value < below; }
};
constexpr Range kLength{75.0, 350.0};  // m
constexpr Range kLengthToBreadth{4.0, 9.0};
constexpr Range kBreadthToDraught{2.2, 9.0};
constexpr Range kBlock{0.39, 0.90};
constexpr double kMostFroude = 0.30;
constexpr double kMostTrim = 0.02;  // of lpp

// From one end of the section list inwards: where the waterline first has `wanted`, x from G.
double place_of_breadth(const LoadedHull& hull, double wanted, bool from_fore) {
  const std::size_t n = hull.num_sections;
  const auto index = [&](std::size_t i) { return from_fore ? n - 1 - i : i; };
  if (hull.half_breadth[index(0)] >= wanted) {
    return hull.x[index(0)];
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double before = hull.half_breadth[index(i - 1)];
    const double here = hull.half_breadth[index(i)];
    if (here >= wanted) {
      const double part = (wanted - before) / (here - before);
      return hull.x[index(i - 1)] + part * (hull.x[index(i)] - hull.x[index(i - 1)]);
    }
  }
  return hull.x[index(n - 1)];
}

// Of the waterline above the base line at the perpendiculars.
struct Draughts {
  double aft = 0.0;
  double fore = 0.0;
};

Draughts draughts(const LoadedHull& hull) {
  const ImmersedSection& a = hull.immersed[0];
  const ImmersedSection& b = hull.immersed[hull.immersed.size() - 1];
  const double slope = (b.waterline_z - a.waterline_z) / (b.x - a.x);
  return {a.waterline_z - slope * a.x, a.waterline_z + slope * (hull.lpp - a.x)};
}

}  // namespace

EmpiricalShip empirical_ship(const LoadedHull& hull) {
  EmpiricalShip out;
  out.lpp = hull.lpp;
  out.breadth = hull.breadth;
  const Draughts t = draughts(hull);
  out.draught = std::max(t.aft, t.fore);
  out.trim = std::fabs(t.aft - t.fore);
  out.cb = hull.hydrostatics.cb;
  out.pitch_gyradius = std::sqrt(hull.body.iyy / hull.body.mass) / hull.lpp;
  out.density = hull.density;
  out.gravity = hull.gravity;
  const auto end = hull.half_breadth.begin() + static_cast<std::ptrdiff_t>(hull.num_sections);
  const double wanted = kFullBreadth * *std::max_element(hull.half_breadth.begin(), end);
  const double lcb = hull.hydrostatics.lcb;
  const double entrance = hull.lpp - (lcb + place_of_breadth(hull, wanted, true));
  const double run = lcb + place_of_breadth(hull, wanted, false);
  out.entrance = std::atan2(0.5 * kFullBreadth * hull.breadth, std::max(0.0, entrance));
  out.run = std::atan2(0.5 * kFullBreadth * hull.breadth, std::max(0.0, run));
  return out;
}

bool is_in_range(const EmpiricalShip& ship, double speed) {
  return kLength.holds(ship.lpp) && kLengthToBreadth.holds(ship.lpp / ship.breadth) &&
         kBreadthToDraught.holds(ship.breadth / ship.draught) && kBlock.holds(ship.cb) &&
         ship.trim <= kMostTrim * ship.lpp && speed >= 0.0 &&
         speed <= kMostFroude * std::sqrt(ship.gravity * ship.lpp);
}

EmpiricalWave empirical_wave(const EmpiricalShip& ship, double omega) {
  const double lambda = wave_length(omega, ship.gravity);
  const double longest = 2.5 * ship.lpp;
  const double decay = -4.0 * kPi * (1.0 / lambda - 1.0 / longest);
  return {omega, std::log(omega), decay, 1.0 - std::exp(decay * ship.draught), lambda <= longest};
}

// alpha: from head waves, 0 ... pi, as [ITTC2021] has it.
EmpiricalResistance::EmpiricalResistance(const EmpiricalShip& ship, EncounterAngle mu, double speed)
    : ship_(ship), speed_(speed), log_flatness_(std::log(ship.breadth / ship.draught)) {
  const double alpha = std::clamp(kPi - std::fabs(wrap_pi(mu.radians)), 0.0, kPi);
  const double cos_alpha = std::cos(alpha);
  root_gl_ = std::sqrt(ship.gravity * ship.lpp);
  froude_ = speed / root_gl_;
  past_beam_ = std::max(0.0, alpha / (0.5 * kPi) - 1.0);
  ahead_ = ahead(past_beam_ > 0.0 ? 0.0 : cos_alpha);

  const double trim_angle = std::atan(ship.trim / ship.lpp);
  motion_scale_ = 3859.2 * ship.density * ship.gravity * ship.breadth * ship.breadth / ship.lpp *
                  std::pow(ship.cb, 1.34) * ship.pitch_gyradius * ship.pitch_gyradius *
                  (1.0 + 28.7 * trim_angle);
  const double by_heading = (-1.377 * froude_ * froude_ + 1.157 * froude_) * std::fabs(cos_alpha) +
                            0.618 * (13.0 + std::cos(2.0 * alpha)) / 14.0;
  // sqrt(L / lambda) = omega sqrt(L / (2 pi g))
  log_omega_bar_ = std::log(2.142 * std::cbrt(ship.pitch_gyradius) *
                            std::sqrt(ship.lpp / (kTwoPi * ship.gravity)) * std::pow(ship.cb / 0.65, 0.17) *
                            (1.0 - 0.111 / ship.cb * (log_flatness_ - std::log(2.75))) * by_heading);
  d_low_ = 566.0 * std::pow(ship.lpp * ship.cb / ship.breadth, -2.66);
  d_high_ = -566.0 * std::pow(ship.lpp / ship.breadth, -2.66) * (4.0 - 125.0 * trim_angle);

  const auto add = [&](bool is_reached, double angle, double to_alpha, Face& sum) {
    if (is_reached) {
      const Face one = face(angle, to_alpha, cos_alpha);
      sum.square += one.square;
      sum.speed += one.speed;
    }
  };
  add(alpha <= kPi - ship.entrance, ship.entrance, -alpha, forward_);
  add(alpha <= ship.entrance, ship.entrance, alpha, forward_);
  add(alpha >= ship.run, ship.run, alpha, aft_);
  add(alpha >= kPi - ship.run, ship.run, -alpha, aft_);
  const double f = alpha <= ship.entrance ? cos_alpha : 0.0;
  bluntness_ = std::pow(0.87 / ship.cb, (1.0 + 4.0 * std::sqrt(froude_)) * f);
  const double root = std::sqrt(std::fabs(cos_alpha));
  draught_aft_ = ship.draught * (ship.cb <= 0.75 ? (4.0 + root) / 5.0 : (2.0 + root) / 3.0);
}

EmpiricalResistance::Face EmpiricalResistance::face(double angle, double to_alpha, double cos_alpha) {
  const double s = std::sin(angle - to_alpha);
  return {s * s, cos_alpha - std::cos(angle) * std::cos(angle - to_alpha)};
}

double EmpiricalResistance::speed_factor(double froude) const {
  return froude < 0.12 ? 0.0072 + 0.1676 * froude : std::pow(froude, 1.5) * std::exp(-3.5 * froude);
}

EmpiricalResistance::Factors EmpiricalResistance::ahead(double cos_alpha) const {
  const double form =
      std::pow(0.87 / ship_.cb, (1.0 + froude_) * cos_alpha) * (1.0 + 2.0 * cos_alpha) / 3.0 / log_flatness_;
  return {form, speed_factor(froude_)};
}

// The ship overtakes the waves' energy beyond their group velocity: then as in head waves at the difference.
EmpiricalResistance::Factors EmpiricalResistance::following(double omega) const {
  const double group = 0.5 * ship_.gravity / omega;
  const double relative = (speed_ - group) / root_gl_;
  const double form = 0.87 / ship_.cb;
  return {(relative >= 0.12 ? std::pow(form, 1.0 + relative) : form) / log_flatness_,
          relative <= 0.0 ? 0.0072 * (2.0 * speed_ / group - 1.0) : speed_factor(relative)};
}

double EmpiricalResistance::by_motion(const EmpiricalWave& wave) const {
  Factors a = ahead_;
  if (past_beam_ > 0.0) {
    const Factors f = following(wave.omega);
    a.form += past_beam_ * (f.form - a.form);
    a.speed += past_beam_ * (f.speed - a.speed);
  }
  const double log_bar = log_omega_bar_ + wave.log_omega;
  const double b = log_bar < 0.0 ? 11.0 : -8.5;
  const double d = log_bar < 0.0 ? d_low_ : d_high_;
  const double shape = std::exp(b * log_bar + b / d * (1.0 - std::exp(d * log_bar)));
  return motion_scale_ * a.form * a.speed * shape;
}

double EmpiricalResistance::by_reflection(const EmpiricalWave& wave) const {
  if (!wave.is_short) {
    return 0.0;
  }
  const double by_speed = 2.0 * wave.omega * speed_ / ship_.gravity;
  const double ahead_of = wave.at_draught * bluntness_ * (forward_.square + by_speed * forward_.speed);
  const double behind = (1.0 - std::exp(wave.decay * draught_aft_)) * (aft_.square + by_speed * aft_.speed);
  return 2.25 / 4.0 * ship_.density * ship_.gravity * ship_.breadth * (ahead_of - behind);
}

}  // namespace quickstrip
