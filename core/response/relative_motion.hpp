// Vertical motion of the water relative to a point of the ship: s = zeta - Z, positive when the water rises
// against the hull.
//
// Assumes: the undisturbed incident wave; the ship's own waves, swell-up, are a factor on it (swell_up.hpp).
// Cost: one sine and cosine.
// Source: NOTATION.md.
#pragma once

#include <complex>

#include "core/base/angles.hpp"
#include "core/response/point_motion.hpp"
#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

/// zeta at (x_b, y_b) for a unit wave with its crest at G: e^{-ik (x_b cos mu + y_b sin mu)}. wave_number >=
/// 0.
std::complex<double> incident_wave(const Position& position, double wave_number, EncounterAngle mu);

/// m per m.
std::complex<double> relative_motion(const MotionTransfer& transfer, const Position& position,
                                     double wave_number, EncounterAngle mu);

}  // namespace quickstrip
