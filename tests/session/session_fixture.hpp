// A session of the S-175 on a coarse grid, messages to feed it, and an outbox that decodes what it says.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "core/advice/nordforsk.hpp"
#include "firmware/session/session.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/units.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::test {

inline constexpr std::int64_t kSecond = 1'000'000;
inline constexpr std::int64_t kMinute = 60 * kSecond;
inline constexpr std::int64_t kStart = 1'567'600'800 * kSecond;  // 2019-09-04 12:40 UTC

/// Keeps the last bytes of each channel in place; counts. No heap.
class LastBytes : public Outbox {
 public:
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override {
    const auto c = static_cast<std::size_t>(channel);
    ++count[c];
    size[c] = bytes.size();
    std::copy(bytes.begin(), bytes.end(), last[c].begin());
    return !is_broken;
  }
  template <typename Message>
  [[nodiscard]] Message decoded(OutChannel channel) const {
    const auto c = static_cast<std::size_t>(channel);
    Message message{};
    QS_CHECK(decode(std::span<const std::uint8_t>{last[c].data(), size[c]}, message));
    return message;
  }
  [[nodiscard]] int sent(OutChannel channel) const { return count[static_cast<std::size_t>(channel)]; }

  bool is_broken = false;
  std::array<int, kNumOutChannels> count{};
  std::array<std::size_t, kNumOutChannels> size{};
  std::array<std::array<std::uint8_t, kMaxMessageBytes>, kNumOutChannels> last{};
};

inline sea_state_t swell(std::int64_t utime, double hs_m, double dir_from_deg, std::int32_t seq = 1) {
  sea_state_t sea{};
  sea.utime = utime;
  sea.seq = seq;
  sea.source_id = 20;
  sea.num_systems = 1;
  sea.hs_m[0] = hs_m;
  sea.period_s[0] = 11.0;
  sea.dir_from_deg[0] = dir_from_deg;
  return sea;
}

inline own_ship_t ship(std::int64_t utime, double heading_deg, double speed_kn, std::int32_t seq = 1) {
  own_ship_t own{};
  own.utime = utime;
  own.seq = seq;
  own.source_id = 30;
  own.valid = 3;  // heading and speed through the water
  own.heading_deg = heading_deg;
  own.speed_through_water_kn = speed_kn;
  return own;
}

inline loading_t loaded(std::int64_t utime, double kg_m, std::int32_t seq = 1) {
  loading_t loading{};
  loading.utime = utime;
  loading.seq = seq;
  loading.source_id = 40;
  loading.valid = 2 + 4;  // KG and free-surface correction
  loading.kg_m = kg_m;
  return loading;
}

/// A narrow spectrum, 8 bands by 8 directions, all from 45 degrees x `direction`.
inline wave_spectrum_t spectrum(std::int64_t utime, double density, int direction, std::int32_t seq = 1) {
  wave_spectrum_t out{};
  out.utime = utime;
  out.seq = seq;
  out.source_id = 21;
  out.num_frequencies = 8;
  out.num_directions = 8;
  for (int f = 0; f < 8; ++f) {
    out.frequency_hz[f] = 0.06 + 0.01 * f;
    out.density_m2_hz_deg[f][direction] = static_cast<float>(f > 0 && f < 7 ? density : 0.0);
  }
  for (int d = 0; d < 8; ++d) {
    out.dir_from_deg[d] = 45.0 * d;
  }
  return out;
}

/// S-175, five speeds of 6 kn by 12 headings: configured in a fraction of the time of the full grid.
inline Hull coarse_s175() {
  Hull hull = s175();
  hull.grid.speed_from = 0.0;
  hull.grid.speed_to = from_knots(24.0);
  hull.grid.speed_step = from_knots(6.0);
  hull.grid.heading_step = radians(30.0);
  return hull;
}

/// Made once, outside what is measured: too big for the stack.
struct Bridge {
  Hull hull = coarse_s175();
  Session session;
  LastBytes outbox;

  explicit Bridge(const SessionOptions& options) {
    const Result<Criteria> criteria = nordforsk_merchant(hull);
    QS_CHECK(criteria.ok());
    QS_CHECK(session.configure(hull, *criteria, options).ok());
  }
  const advice_t& cycle(std::int64_t now) {
    session.cycle(now, outbox);
    if (session.is_rebuild_due()) {
      session.rebuild();
    }
    return session.advice();
  }
  [[nodiscard]] std::string no_advice_text() const {
    return std::string(get_text(session.advice().no_advice_text));
  }
};

inline std::unique_ptr<Bridge> bridge(const SessionOptions& options = {}) {
  return std::make_unique<Bridge>(options);
}

/// With a sea and a ship at kStart.
inline std::unique_ptr<Bridge> bridge_at_sea(const SessionOptions& options = {}) {
  auto out = bridge(options);
  QS_CHECK(out->session.accept(swell(kStart, 3.0, 90.0), kStart).ok());
  QS_CHECK(out->session.accept(ship(kStart, 0.0, 15.0), kStart).ok());
  return out;
}

inline int code(NoAdvice reason) {
  return static_cast<int>(reason);
}

}  // namespace quickstrip::test
