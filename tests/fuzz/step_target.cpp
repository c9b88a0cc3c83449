// Any numbers into Advisor::step: every field of its inputs from raw bytes, NaN, infinities and denormals
// among them, and the loading rebuilt where it is due. What holds of every step:
// tests/support/step_promises.hpp.
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "core/base/check.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"
#include "tests/support/step_promises.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr int kMaxSteps = 6;
constexpr int kMaxRebuilds = 2;  // 10 ms each

/// A number: of a list, the usual one, or eight raw bytes.
class Numbers {
 public:
  explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool is_over() const { return at_ >= bytes_.size(); }
  std::uint8_t byte() { return is_over() ? std::uint8_t{0} : bytes_[at_++]; }
  double number(double usual) {
    constexpr std::array kSpecial{std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::max(),
                                  0.0,
                                  -0.0,
                                  -1.0,
                                  1e-9,
                                  1e9};
    const std::size_t what = byte();
    if (what < 128) {
      return usual * (1.0 + 0.01 * static_cast<double>(what));  // 0: as usual
    }
    if (what < 192) {
      return kSpecial[what % kSpecial.size()];
    }
    std::array<std::uint8_t, 8> raw{};
    for (std::uint8_t& b : raw) {
      b = byte();
    }
    double value = 0.0;
    std::memcpy(&value, raw.data(), sizeof(value));
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// What a step is given; too large for the stack.
struct Given {
  SeaState sea;
  DirectionalSpectrum spectrum;
  OwnShip ship;
  Loading loading;
  MeasuredMotion motion;
};

void read_sea(Numbers& in, SeaState& sea) {
  sea.systems.clear();
  const std::size_t count = in.byte() % (kMaxWaveSystems + 1);
  for (std::size_t i = 0; i < count; ++i) {
    WaveSystem system;
    system.hs = in.number(3.0);
    system.period = in.number(9.0);
    system.period_kind = static_cast<PeriodKind>(in.byte() % 3);
    system.from.radians = in.number(1.0);
    system.spreading = in.number(0.4);
    system.shape = static_cast<SpectrumShape>(in.byte() % 3);
    system.peakedness = in.number(3.3);
    static_cast<void>(sea.systems.push_back(system));
  }
}

void read_spectrum(Numbers& in, DirectionalSpectrum& spectrum) {
  spectrum.frequencies.clear();
  spectrum.directions.clear();
  const std::size_t num_frequencies = in.byte() % 8u;
  const std::size_t num_directions = in.byte() % 9u;
  for (std::size_t f = 0; f < num_frequencies; ++f) {
    static_cast<void>(spectrum.frequencies.push_back(in.number(0.4 + 0.1 * static_cast<double>(f))));
  }
  for (std::size_t d = 0; d < num_directions; ++d) {
    const double evenly = kTwoPi * static_cast<double>(d) / static_cast<double>(num_directions);
    static_cast<void>(spectrum.directions.push_back(in.number(evenly)));
  }
  for (std::size_t f = 0; f < num_frequencies; ++f) {
    for (std::size_t d = 0; d < num_directions; ++d) {
      spectrum.density[f][d] = in.number(0.3);
    }
  }
}

void read_rest(Numbers& in, Given& given, StepInputs& step) {
  given.ship.heading.radians = in.number(0.5);
  given.ship.speed = in.number(3.0);
  given.ship.water_depth.reset();
  if (in.byte() % 2 == 1) {
    given.ship.water_depth = in.number(50.0);
  }
  given.motion.window = in.number(600.0);
  given.motion.roll_rms = in.number(0.05);
  given.motion.roll_period = in.number(18.0);
  given.motion.pitch_rms = in.number(0.02);
  given.motion.pitch_period = in.number(9.0);
  step.time = in.number(1000.0);
  step.ensemble_members = in.byte() % 3u;
  step.uncertainty.gm = in.number(0.05);
  step.uncertainty.roll_damping_part = in.number(0.2);
  for (std::size_t s = 0; s < 2; ++s) {
    step.uncertainty.height_part[s] = in.number(0.1);
    step.uncertainty.period_part[s] = in.number(0.05);
    step.uncertainty.direction[s] = in.number(0.1);
  }
}

void read_loading(Numbers& in, Loading& loading) {
  for (double* const field : {&loading.draught_aft, &loading.draught_fwd, &loading.kg, &loading.roll_gyradius,
                              &loading.pitch_gyradius, &loading.yaw_gyradius, &loading.water_density,
                              &loading.viscosity, &loading.gravity}) {
    *field = in.number(*field);
  }
  if (in.byte() % 2 == 1) {
    loading.gm = in.number(1.0);
  }
  if (in.byte() % 2 == 1) {
    loading.measured_roll_period = in.number(20.0);
  }
}

}  // namespace

void run_step(std::span<const std::uint8_t> bytes) {
  static const Criteria kCriteria = *nordforsk_merchant(tiny_ship());
  static const auto kFresh = [] {
    auto advisor = std::make_unique<Advisor>();
    QS_CHECK(advisor->configure(tiny_ship(), kCriteria, {}).ok());
    return advisor;
  }();
  static const auto advisor = std::make_unique<Advisor>();
  static const auto given = std::make_unique<Given>();
  *advisor = *kFresh;
  given->loading = tiny_ship().loading;
  int rebuilds = 0;
  Numbers in(bytes);
  for (int i = 0; i < kMaxSteps && (i == 0 || !in.is_over()); ++i) {
    StepInputs step;
    const unsigned int what = in.byte();
    if ((what & 1u) != 0) {
      read_spectrum(in, given->spectrum);
      step.spectrum = &given->spectrum;
    } else {
      read_sea(in, given->sea);
      step.sea_state = &given->sea;
    }
    read_rest(in, *given, step);
    if ((what & 2u) != 0) {
      read_loading(in, given->loading);
    }
    step.own_ship = (what & 4u) != 0 ? nullptr : &given->ship;
    step.loading = &given->loading;
    step.motion = (what & 8u) != 0 ? &given->motion : nullptr;
    const std::string_view broken = test::broken_promise(advisor->step(step), kCriteria);
    require(broken.empty(), broken);
    if (advisor->is_rebuild_due() && rebuilds++ < kMaxRebuilds) {
      static_cast<void>(advisor->rebuild());
    }
  }
}

std::vector<Bytes> step_seeds() {
  // One system, as usual; with a loading and motion; a spectrum of seven by eight.
  return {Bytes{0, 1}, Bytes{10, 2, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0}, Bytes{1, 7, 8},
          Bytes{0, 1, 130, 200}};
}

}  // namespace quickstrip::fuzz
