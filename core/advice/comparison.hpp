// Predicted beside measured: what the advisor said of the past window, and what sensors felt in it.
//
// Predictions of every cycle are kept by the minute, as variances, for as long as a window may be; the mean
// over the minutes of a window is what its RMS should have been. Bounds: 95 % of windows lie within 1.96
// standard deviations, of the sample (response/window_rms.hpp) and of the wave height together, if the
// prediction is right. A measured RMS outside its bounds on the same side for kLastingGap lowers the stated
// confidence. Nothing is re-tuned. No clock: times are the caller's [s], only differences count.
// Memory: 60 kB: static. Cost of a note: some 50 additions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/advice/cell_response.hpp"
#include "core/advice/step.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"
#include "core/response/quantity.hpp"

namespace quickstrip {

inline constexpr double kLastingGap = 3600.0;        // s, ours
inline constexpr double kConfidenceBounds = 1.96;    // standard deviations: 95 %
inline constexpr double kAccelerometerNearby = 1.0;  // m: a point of the hull file stands for it. Ours
inline constexpr double kLeastCoverage = 0.5;        // of a window that predictions must cover. Ours

enum class GapState : std::uint8_t {
  kAgrees = 0,
  kAbovePredicted = 1,
  kBelowPredicted = 2,
  kNotCompared = 3
};

struct ComparedLine {
  Quantity quantity = Quantity::kRoll;
  std::uint8_t place = 0;               // index into the hull's points; motions: 0
  bool is_place_known = true;           // false: no point of the hull file is where the accelerometer is
  double predicted_rms = kNotComputed;  // m, rad or m/s2
  double measured_rms = 0.0;
  double low_rms = kNotComputed;
  double high_rms = kNotComputed;
  GapState state = GapState::kNotCompared;
  double gap_since = 0.0;  // s
};

inline constexpr std::size_t kMaxComparedLines = 3 + 3 * kMaxAccelerometers;

struct Comparison {
  StaticVector<ComparedLine, kMaxComparedLines> lines;
  double predicted_over = 0.0;  // s of the window
  bool has_lasting_gap = false;
};

class PredictedMotion {
 public:
  void forget();

  /// The prediction of this cycle. Not called without advice: then nothing was predicted.
  void note(double time, const CellResponse& present);

  /// `height_part`: relative standard deviation of the wave height; `end`: of the window.
  void compare(const MeasuredMotion& measured, const Hull& hull, double end, double height_part,
               Comparison& out);

 private:
  static constexpr double kBin = 60.0;         // s
  static constexpr std::size_t kNumBins = 90;  // the longest window: an hour and a half
  static constexpr std::size_t kNumTracked = 3 + 3 * kMaxPoints;

  struct Sums {
    float variance = 0.0F;
    float t1 = 0.0F;  // times the variance
    float t2 = 0.0F;
  };
  struct Bin {
    double start = -1.0;
    float count = 0.0F;
    float roll_damping = 0.0F;
    std::array<Sums, kNumTracked> sums{};
  };
  struct Gap {
    int side = 0;  // -1 below, 1 above
    double since = 0.0;
  };
  struct Mean {
    double variance = 0.0;
    double t1 = 0.0;
    double t2 = 0.0;
    double roll_damping = 0.0;
    double covered = 0.0;  // s
  };

  [[nodiscard]] Mean mean_of(std::size_t tracked, double from, double to) const;
  void compare_one(std::size_t tracked, double window, double end, double height_part, ComparedLine& line,
                   Comparison& out);

  std::array<Bin, kNumBins> bins_{};
  std::array<Gap, kNumTracked> gaps_{};
};

}  // namespace quickstrip
