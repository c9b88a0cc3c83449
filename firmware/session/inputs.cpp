#include "firmware/session/inputs.hpp"

#include <algorithm>
#include <utility>

#include "msgs/convert/motion_message.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr FitnessReasons kSeaReasons{NoAdvice::kSeaMissing, NoAdvice::kSeaStale, NoAdvice::kSeaImplausible};
constexpr FitnessReasons kOwnShipReasons{NoAdvice::kOwnShipMissing, NoAdvice::kOwnShipStale,
                                         NoAdvice::kOwnShipImplausible};
constexpr FitnessReasons kLoadingReasons{NoAdvice::kLoadingMissing, NoAdvice::kLoadingStale,
                                         NoAdvice::kLoadingImplausible};

/// The age at which a sea is too old [s]: its own valid-until may come before our limit.
template <typename Message>
double sea_limit_s(const Message& message, double stale_after_s) {
  if ((message.valid & Message::VALID_UNTIL) == 0) {
    return stale_after_s;
  }
  return std::min(stale_after_s, seconds_between(message.utime, message.valid_until_utime));
}

/// Of two seas neither of which can be used the one nearer to use speaks.
int nearness(const Fitness& fitness) {
  return fitness.reason == NoAdvice::kSeaStale ? 2 : fitness.reason == NoAdvice::kSeaImplausible ? 1 : 0;
}

}  // namespace

void Inputs::configure(const Hull& hull, const StaleAfter& stale_after) {
  hull_ = &hull;
  stale_after_ = stale_after;
  sea_state_.forget();
  wave_spectrum_.forget();
  own_ship_.forget();
  loading_.forget();
  loading_.hold_default(hull.loading);
  motion_.forget();
  other_counters_.fill(InputCounters{});
}

Conversion Inputs::accept(const sea_state_t& message, std::int64_t now, InputUse use) {
  return sea_state_.accept(message, now, use, stale_after_.future_tolerance_s,
                           [](const sea_state_t& from, DescribedSea& out) {
                             out.source_kind = from.source_kind;
                             return to_sea_state(from, out.sea, out.assumed);
                           });
}

Conversion Inputs::accept(const wave_spectrum_t& message, std::int64_t now, InputUse use) {
  return wave_spectrum_.accept(message, now, use, stale_after_.future_tolerance_s,
                               [](const wave_spectrum_t& from, DirectionalSpectrum& out) {
                                 return to_directional_spectrum(from, out);
                               });
}

Conversion Inputs::accept(const own_ship_t& message, std::int64_t now, InputUse use) {
  return own_ship_.accept(message, now, use, stale_after_.future_tolerance_s,
                          [](const own_ship_t& from, OwnShipReading& out) { return to_own_ship(from, out); });
}

Conversion Inputs::accept(const loading_t& message, std::int64_t now, InputUse use) {
  return loading_.accept(
      message, now, use, stale_after_.future_tolerance_s,
      [this](const loading_t& from, Loading& out) { return to_loading(from, *hull_, out); });
}

Conversion Inputs::accept(const motion_t& message, std::int64_t now) {
  return motion_.accept(
      message, now, InputUse::kLive, stale_after_.future_tolerance_s,
      [](const motion_t& from, MeasuredMotion& out) { return to_measured_motion(from, out); });
}

const MeasuredMotion* Inputs::motion(std::int64_t now) const {
  const Fitness fitness = motion_.fitness(now, stale_after_.motion_s, stale_after_.future_tolerance_s, {});
  return fitness.ok() ? &motion_.value() : nullptr;
}

StatedUncertainty Inputs::uncertainty(Input sea_in_force, double gm) const {
  StatedUncertainty out = sea_in_force == Input::kSeaState ? uncertainty_of(sea_state_.message())
                                                           : uncertainty_of(wave_spectrum_.message());
  add_ship_uncertainty(loading_.value(), gm, out);
  return out;
}

Fitness Inputs::sea(std::int64_t now, Input& in_force) const {
  const double tolerance = stale_after_.future_tolerance_s;
  const Fitness state =
      sea_state_.fitness(now, sea_limit_s(sea_state_.message(), stale_after_.sea_s), tolerance, kSeaReasons);
  const Fitness spectrum = wave_spectrum_.fitness(
      now, sea_limit_s(wave_spectrum_.message(), stale_after_.sea_s), tolerance, kSeaReasons);
  const bool state_is_newer = sea_state_.message().utime > wave_spectrum_.message().utime;
  if (state.ok() && (!spectrum.ok() || state_is_newer)) {
    in_force = Input::kSeaState;
    return state;
  }
  in_force = Input::kWaveSpectrum;
  if (spectrum.ok()) {
    return spectrum;
  }
  const bool state_speaks =
      nearness(state) > nearness(spectrum) || (nearness(state) == nearness(spectrum) && state_is_newer);
  return state_speaks ? state : spectrum;
}

Fitness Inputs::own_ship(std::int64_t now) const {
  return own_ship_.fitness(now, stale_after_.own_ship_s, stale_after_.future_tolerance_s, kOwnShipReasons);
}

Fitness Inputs::loading(std::int64_t now) const {
  return loading_.fitness(now, stale_after_.loading_s, stale_after_.future_tolerance_s, kLoadingReasons);
}

UsedInput Inputs::used(Input input) const {
  switch (input) {
    case Input::kSeaState:
      return sea_state_.used();
    case Input::kWaveSpectrum:
      return wave_spectrum_.used();
    case Input::kOwnShip:
      return own_ship_.used();
    case Input::kLoading:
      return loading_.used();
    case Input::kMotion:
      return motion_.used();
    default:
      return {};
  }
}

double Inputs::age_s(Input input, std::int64_t now) const {
  const UsedInput held = used(input);
  const bool is_measured = held.use == InputUse::kLive || held.use == InputUse::kRestored;
  return is_measured ? std::max(0.0, seconds_between(held.utime, now)) : -1.0;
}

double Inputs::stale_after_s(Input input) const {
  switch (input) {
    case Input::kSeaState:
    case Input::kWaveSpectrum:
      return stale_after_.sea_s;
    case Input::kOwnShip:
      return stale_after_.own_ship_s;
    case Input::kLoading:
      return stale_after_.loading_s;
    case Input::kMotion:
      return stale_after_.motion_s;
    default:
      return -1.0;
  }
}

const InputCounters& Inputs::counters(Input input) const {
  switch (input) {
    case Input::kSeaState:
      return sea_state_.counters();
    case Input::kWaveSpectrum:
      return wave_spectrum_.counters();
    case Input::kOwnShip:
      return own_ship_.counters();
    case Input::kLoading:
      return loading_.counters();
    case Input::kMotion:
      return motion_.counters();
    default:
      return other_counters_[static_cast<std::size_t>(input)];
  }
}

InputCounters& Inputs::counters(Input input) {
  return const_cast<InputCounters&>(std::as_const(*this).counters(input));  // NOLINT: one list of kinds
}

void Inputs::keep(KeptInputs& out) const {
  out.has_sea_state = sea_state_.is_measured();
  out.has_wave_spectrum = wave_spectrum_.is_measured();
  out.has_own_ship = own_ship_.is_measured();
  out.has_loading = loading_.is_measured();
  out.sea_state = sea_state_.message();
  out.wave_spectrum = wave_spectrum_.message();
  out.own_ship = own_ship_.message();
  out.loading = loading_.message();
}

}  // namespace quickstrip
