// The ship's motions in every wave cell, and from them the complex amplitudes of a block.
//
// Loads are solved directly at wave frequencies 0.03 sqrt(g/L) apart in every beam and interpolated between
// them by cubics (they are smooth, and turn by less than half a radian at the ship's ends from one to the
// next); the equations of motion are then solved at every cell by itself, so the roll peak is as it is. Where
// the stencil meets the encounter-frequency floor, and where the method forces loads to zero, the cell's
// loads are solved directly. Apart from the advisor's 48 frequencies, its interpolation and its roll-peak
// points.
//
// Rows of a cell: the six motions of G, the wave at G, the wave at every position that a relative motion is
// watched at. Cost: some 25 us a node, 1 us a cell; memory 8 bytes a row and cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/response/watch.hpp"
#include "core/strip/loaded_hull.hpp"
#include "sim/seaway/fourier.hpp"
#include "sim/seaway/gaussian.hpp"
#include "sim/seaway/wave_cells.hpp"

namespace quickstrip::seaway {

inline constexpr std::size_t kWaveRow = 6;  // after the six motions

/// Amplitudes by bin and row: value(n, r) of omega_e = n d_omega >= 0.
class BinAmplitudes {
 public:
  void resize(std::size_t num_bins, std::size_t num_rows) {
    num_bins_ = num_bins;
    stride_ = num_rows;
    re.assign(num_bins * stride_, 0.0);
    im.assign(num_bins * stride_, 0.0);
  }
  [[nodiscard]] std::size_t num_bins() const { return num_bins_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] Complex value(std::size_t bin, std::size_t row) const {
    return {re[bin * stride_ + row], im[bin * stride_ + row]};
  }
  void add(std::size_t bin, std::size_t row, Complex amount) {
    re[bin * stride_ + row] += amount.real();
    im[bin * stride_ + row] += amount.imag();
  }
  std::vector<double> re;
  std::vector<double> im;

 private:
  std::size_t num_bins_ = 0;
  std::size_t stride_ = 0;
};

/// Response times the square root of the cell's energy, conjugate where omega_e is negative: the amplitudes
/// of a block are sums of these times independent complex normal numbers.
struct WaveAnswers {
  std::size_t num_rows = 0;
  std::size_t num_bins = 0;  // bins above are empty
  double step = 0.0;         // d_omega [rad/s]
  double speed = 0.0;        // of the ship [m/s]
  std::vector<std::uint32_t> bin;
  std::vector<float> re;  // by cell, then row
  std::vector<float> im;
  std::vector<std::size_t> wave_row;  // by channel of the watch; where its form has a wave
};

/// Errors: kSingular.
Result<WaveAnswers> wave_answers(const LoadedHull& hull, const Watch& watch, const Beams& sea,
                                 const CellGrid& grid, std::span<const WaveCell> cells);

/// One block: every cell gets an amplitude of its own. `out` is resized to num_bins.
void draw_block(const WaveAnswers& answers, Gaussian& random, BinAmplitudes& out);

/// Amplitudes of a channel by bin from those of the rows.
void channel_amplitudes(const WaveAnswers& answers, const BinAmplitudes& block, const Channel& channel,
                        std::size_t wave_row, std::vector<Complex>& out);

/// m0, m2, m4 of a channel as simulated: sums over the cells.
struct SpectralMoments {
  double m0 = 0.0;
  double m2 = 0.0;
  double m4 = 0.0;
};
SpectralMoments channel_moments(const WaveAnswers& answers, const Channel& channel, std::size_t wave_row);

}  // namespace quickstrip::seaway
