// The inputs that a session holds, and which of them may be used at a given time: held_input.hpp has the
// rules. No heap, no clock. Cost: accepting a spectrum some 20 microseconds, the others below 1. Memory about
// 120 kB (5 kB in the profile m7, which takes no spectrum): static.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/hull/hull.hpp"
#include "core/sea/sea_state.hpp"
#include "firmware/session/held_input.hpp"
#include "msgs/convert/ship_message.hpp"
#include "msgs/convert/uncertainty.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {

/// health_t's INPUT_...; the first six are advice_t's too.
enum class Input : std::uint8_t {
  kSeaState = 0,
  kWaveSpectrum = 1,
  kSeaForecast = 2,
  kOwnShip = 3,
  kLoading = 4,
  kMotion = 5,
  kTime = 6,
  kQuery = 7,
  kAlertAck = 8,
};
inline constexpr std::size_t kNumInputs = 9;

/// After how many seconds an input is too old (contract §5), and how far ahead of our clock a sender's may
/// be.
struct StaleAfter {
  double own_ship_s = 10.0;
  double sea_s = 90.0 * 60.0;
  double loading_s = 24.0 * 3600.0;
  double motion_s = 15.0 * 60.0;  // after the end of its window; only what measured motion confirms
  double future_tolerance_s = 5.0;
};

/// The last inputs as messages, to be kept on disk.
struct KeptInputs {
  bool has_sea_state = false;
  bool has_wave_spectrum = false;
  bool has_own_ship = false;
  bool has_loading = false;
  sea_state_t sea_state{};
  wave_spectrum_t wave_spectrum{};
  own_ship_t own_ship{};
  loading_t loading{};
};

/// A sea state and what it left out.
struct DescribedSea {
  SeaState sea;
  std::uint32_t assumed = 0;  // SeaAssumption
  int source_kind = 0;        // sea_state_t's SOURCE_...
};

#if defined(QUICKSTRIP_CAPACITY_M7)
using HeldSpectrum = AbsentInput<wave_spectrum_t, DirectionalSpectrum>;  // 34 kB
#else
using HeldSpectrum = HeldInput<wave_spectrum_t, DirectionalSpectrum>;
#endif

class Inputs {
 public:
  /// Forgets everything; the hull's default loading is in force. `hull` must outlive this object.
  void configure(const Hull& hull, const StaleAfter& stale_after);

  /// `use`: kLive, or kRestored for what was kept from before a restart.
  Conversion accept(const sea_state_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const wave_spectrum_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const own_ship_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const loading_t& message, std::int64_t now, InputUse use = InputUse::kLive);
  Conversion accept(const motion_t& message, std::int64_t now);

  /// Which sea is in force at `now`: the newer usable one of kSeaState and kWaveSpectrum, the spectrum if
  /// both are of one time. Without a usable one the fitness says why.
  Fitness sea(std::int64_t now, Input& in_force) const;
  [[nodiscard]] Fitness own_ship(std::int64_t now) const;
  [[nodiscard]] Fitness loading(std::int64_t now) const;

  [[nodiscard]] const DescribedSea& sea_state() const { return sea_state_.value(); }
  [[nodiscard]] const DirectionalSpectrum& wave_spectrum() const { return wave_spectrum_.value(); }
  [[nodiscard]] const OwnShipReading& ship() const { return own_ship_.value(); }
  [[nodiscard]] const Loading& present_loading() const { return loading_.value(); }
  /// What was measured lately; null when that is nothing, or too long ago.
  [[nodiscard]] const MeasuredMotion* motion(std::int64_t now) const;
  [[nodiscard]] const motion_t& motion_message() const { return motion_.message(); }
  /// Of the sea in force and the loading; gm [m].
  [[nodiscard]] StatedUncertainty uncertainty(Input sea_in_force, double gm) const;

  [[nodiscard]] UsedInput used(Input input) const;
  [[nodiscard]] double age_s(Input input, std::int64_t now) const;  // -1: never received
  [[nodiscard]] double stale_after_s(Input input) const;            // -1: does not go stale
  [[nodiscard]] const InputCounters& counters(Input input) const;
  InputCounters& counters(Input input);
  void keep(KeptInputs& out) const;

 private:
  const Hull* hull_ = nullptr;
  StaleAfter stale_after_;
  HeldInput<sea_state_t, DescribedSea> sea_state_;
  HeldSpectrum wave_spectrum_;
  HeldInput<own_ship_t, OwnShipReading> own_ship_;
  HeldInput<loading_t, Loading> loading_;
  HeldInput<motion_t, MeasuredMotion> motion_;
  std::array<InputCounters, kNumInputs> other_counters_{};  // of the kinds that are not held
};

}  // namespace quickstrip
