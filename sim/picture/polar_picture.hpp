// The polar picture of one advice: verdict over heading (direction) and speed (radius), north up, with the
// waves, the ship as she goes and the changes that would help. Made to be read without colour too: the four
// verdicts differ in lightness, and what is not known is hatched.
//
// Colours: light teal, amber, brick red on white: distinct for the common kinds of colour blindness
// (blue-green against orange-red) and in grey (lightness about 90, 77 and 40 of 100).
#pragma once

#include <string>
#include <vector>

#include "quickstrip/advice_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/limits_t.hpp"

namespace quickstrip {

struct PictureWave {
  double hs_m = 0.0;
  double tp_s = 0.0;
  double dir_from_deg = 0.0;
};

struct PolarPicture {
  std::string time;                // "2019-09-04 12:40 UTC"
  double hs_m = 0.0;               // of the whole sea
  std::vector<PictureWave> waves;  // by wave system, any order
  advice_t advice{};
  grid_t grid{};      // may hold no speeds: the picture then says why there is no advice
  limits_t limits{};  // num_criteria 0: letters and names are left out
};

/// A gnuplot script that draws the picture into `png` (pngcairo, 1,600 x 1,186).
std::string polar_script(const PolarPicture& picture, const std::string& png);

}  // namespace quickstrip
