// Vertical motion of the water relative to a point of the ship: s = zeta - Z, positive when the water rises
// against the hull.
//
// Assumes: the undisturbed incident wave; neither the ship's own waves nor swell-up ([Journee1992] §3 names
// both and leaves them out); on fine hulls at speed they add some 10 to 30 % at the bow (Blok, Huisman 1984).
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
