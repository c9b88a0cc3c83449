#include "sim/pilot/storm.hpp"

#include <fmt/format.h>

#include <cmath>

#include "msgs/convert/units.hpp"
#include "sim/seaway/gaussian.hpp"

namespace quickstrip::pilot {
namespace {

constexpr int kHalfHours = 60;
constexpr std::int64_t kHalfHour_us = 1'800'000'000;
constexpr std::uint64_t kStream = 41'010;  // of the generator

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed, kStream) {}
  double between(double from, double to) { return from + (to - from) * random_.uniform(); }
  double side() { return random_.uniform() < 0.5 ? -1.0 : 1.0; }

 private:
  seaway::Gaussian random_;
};

WaveFrom from_degrees(double d) {
  return {wrap_two_pi(radians(d))};
}

}  // namespace

Storm synthetic_storm(std::uint64_t seed) {
  Draw draw(seed);
  const double h0 = draw.between(1.0, 2.0);
  const double h1 = draw.between(4.0, 9.0);
  const double peak_h = draw.between(9.0, 16.0);
  const double rise_h = draw.between(3.0, 6.0);
  const double fall_h = draw.between(4.0, 8.0);
  const double steepness = draw.between(4.1, 4.9);
  const double d0 = draw.between(0.0, 360.0);
  const double veer = draw.side() * draw.between(30.0, 120.0);
  const double swell_hs = draw.between(1.0, 3.0);
  const double swell_tp = draw.between(11.0, 16.0);
  const double swell_from = d0 + draw.side() * draw.between(40.0, 140.0);
  Storm storm;
  storm.name = fmt::format("seed {}", seed);
  storm.intended = {radians(5.0 * std::floor(draw.between(0.0, 72.0)))};
  storm.intended_speed = from_knots(std::floor(draw.between(14.0, 19.0)));
  for (int i = 0; i < kHalfHours; ++i) {
    const double t = 0.5 * i;
    const double x = (t - peak_h) / (t < peak_h ? rise_h : fall_h);
    WaveSystem wind_sea;
    wind_sea.hs = h0 + (h1 - h0) * std::exp(-0.5 * x * x);
    wind_sea.period = steepness * std::sqrt(wind_sea.hs);
    wind_sea.from = from_degrees(d0 + 0.5 * veer * (1.0 + std::tanh((t - peak_h) / 6.0)));
    wind_sea.spreading = radians(30.0);
    wind_sea.shape = SpectrumShape::kJonswap;
    WaveSystem swell;
    swell.hs = swell_hs * std::fmin(1.0, (1.0 + 4.0 * i / kHalfHours) / 3.0);
    swell.period = swell_tp;
    swell.from = from_degrees(swell_from);
    swell.spreading = radians(15.0);
    swell.shape = SpectrumShape::kJonswap;
    SeaState state;
    static_cast<void>(state.systems.push_back(wind_sea));
    static_cast<void>(state.systems.push_back(swell));
    storm.states.push_back(state);
  }
  return storm;
}

Storm measured_storm(const std::string& name, const SeaSeries& series, std::int64_t from_us,
                     std::int64_t to_us, Heading intended, double intended_speed) {
  Storm storm{name, intended, intended_speed, {}, {}};
  for (std::int64_t t = from_us; t < to_us; t += kHalfHour_us) {
    const SeaRecord* const record = record_at(series, t);
    if (record == nullptr) {
      break;
    }
    storm.records.push_back(record);
  }
  return storm;
}

}  // namespace quickstrip::pilot
