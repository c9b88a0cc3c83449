// Confidence intervals of a counted rate or probability, with the clustering of the events in them.
//
// Method: the run is made of blocks that know nothing of each other (an hour each). With e_i events among n_i
// encounters in block i, P = sum e / sum n, and the scatter of e_i - P n_i from block to block against what
// Poisson's law would give is the dispersion D: above 1 where events come in groups, below 1 where they are
// regular (most encounters have one). The interval is Jeffreys' for a Poisson count (gamma quantiles at
// count + 1/2) of the count divided by D, times D; for large counts it is the normal interval of the block
// scatter. With few blocks D is uncertain: widened by Student's t over normal quantiles, squared.
// Covers its nominal share within some per cent from 2 events on (tests/seaway). Fewer than kLeastBlocks
// blocks: none. Source: Jeffreys' interval: [BrownCaiDasGupta2003]; dispersion: quasi-likelihood,
// [McCullaghNelder1989] §6.2.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace quickstrip::seaway {

inline constexpr double kConfidence = 0.90;
inline constexpr std::size_t kLeastBlocks = 4;

/// Events among encounters (or hours) of one block.
struct BlockCount {
  double events = 0.0;
  double exposure = 0.0;
};

struct RatioInterval {
  double ratio = 0.0;
  double low = 0.0;
  double high = 0.0;
  double dispersion = 1.0;
};

/// None without exposure or with too few blocks.
std::optional<RatioInterval> ratio_interval(std::span<const BlockCount> blocks);

/// x at which the gamma distribution of this shape > 0 (scale 1) has the probability p in (0, 1) below it.
double gamma_quantile(double shape, double p);

/// The 95 % quantile of Student's t with so many degrees of freedom (>= 1), within 1 % from 3 on.
double student_quantile_95(std::size_t degrees);

}  // namespace quickstrip::seaway
