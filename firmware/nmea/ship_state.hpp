// The newest reading of each quantity by who sent it, and what of it makes a QS_OWN_SHIP.
//
// Each quantity ages by itself: what is older than stale_after drops out, alone. Of several senders the one
// named first (sources in the order of the command line, within a source talkers in the order of their list)
// is believed while it is fresh; another that differs from it by more than a tolerance is counted, not
// averaged: two gyros that disagree are not one gyro in between. No heap, no clock: times are arguments,
// microseconds since the epoch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "firmware/nmea/reading.hpp"
#include "quickstrip/own_ship_t.hpp"

namespace quickstrip::nmea {

/// Who sent a reading; the smaller the more is it believed.
using Rank = std::uint32_t;

constexpr Rank rank_of(std::size_t source, std::size_t talker_rank) {
  return static_cast<Rank>(source * 64 + talker_rank);
}

class ShipState {
 public:
  explicit ShipState(double stale_after_s = 5.0) : stale_after_s_(stale_after_s) {}

  /// True when this sender is the one to believe for that quantity now.
  bool take(const Reading& reading, Rank rank, std::int64_t utime);

  struct Value {
    double value = 0.0;
    std::int64_t utime = 0;
  };
  /// Of the most believed sender that is fresh at `now`.
  [[nodiscard]] std::optional<Value> fresh(Quantity quantity, std::int64_t now) const;

  /// Nothing without a heading and a speed, both fresh. Its utime is that of the older of the two: what is
  /// told is never younger than it is. `seq` and `source_id` are the caller's. Speed over ground is given
  /// beside the speed through the water, and without it alone: the advisor then says so.
  [[nodiscard]] std::optional<own_ship_t> own_ship(std::int64_t now) const;

  /// Readings that differed from a fresh one of a more believed sender.
  [[nodiscard]] std::int64_t num_disagreements() const { return num_disagreements_; }

 private:
  static constexpr std::size_t kMaxSenders = 8;  // of one quantity; of more the least believed is forgotten
  struct Sender {
    bool is_used = false;
    Rank rank = 0;
    Value newest;
  };
  using Senders = std::array<Sender, kMaxSenders>;

  [[nodiscard]] bool is_fresh(const Sender& sender, std::int64_t now) const;
  [[nodiscard]] const Sender* believed(const Senders& senders, std::int64_t now) const;
  Sender& slot(Senders& senders, Rank rank);

  double stale_after_s_;
  std::array<Senders, kNumQuantities> senders_{};
  std::int64_t num_disagreements_ = 0;
};

}  // namespace quickstrip::nmea
