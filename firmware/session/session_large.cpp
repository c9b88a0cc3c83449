// What a session sends of grid, responses, outlook and comparison: not in the profile m7 (session_small.cpp).
#include <span>

#include "firmware/session/session.hpp"
#include "msgs/convert/comparison_message.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/outlook_message.hpp"
#include "msgs/convert/response_message.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {

void Session::forget_predicted() {
  large_.predicted.forget();
  large_.comparison = Comparison{};
}

const grid_t& Session::grid() const {
  return large_.grid;
}

void Session::send_grid(std::int64_t now, Outbox& outbox) {
  to_message(output_->grid, limits_.digest, large_.grid);
  stamp(large_.grid, now);
  send(OutChannel::kGrid, large_.grid, outbox);
}

void Session::send_responses(std::int64_t now, Outbox& outbox) {
  if (output_->advice.no_advice == NoAdvice::kNone) {
    to_message(output_->present, *hull_, criteria_, limits_.digest, large_.response);
    large_.response.query_id = 0;
    large_.response.query_source_id = 0;
  } else {
    to_refusal({.id = 0, .source_id = 0, .heading = {}, .speed = 0.0}, Refusal::kNotReady, large_.response);
  }
  stamp(large_.response, now);
  send(OutChannel::kResponse, large_.response, outbox);
  for (const Query& query : queries_) {
    answer(query, now, outbox);
  }
  queries_.clear();
}

void Session::answer(const Query& query, std::int64_t now, Outbox& outbox) {
  const Status status = advisor_.respond_at(query.heading, query.speed, large_.asked);
  if (status) {
    to_message(large_.asked, *hull_, criteria_, limits_.digest, large_.response);
    large_.response.query_id = query.id;
    large_.response.query_source_id = query.source_id;
  } else {
    const bool is_outside = status.error() == Error::kSpeedOutOfGrid;
    to_refusal(query, is_outside ? Refusal::kSpeedOutsideGrid : Refusal::kNotReady, large_.response);
  }
  stamp(large_.response, now);
  send(OutChannel::kResponse, large_.response, outbox);
}

void Session::send_outlook(std::int64_t now, Outbox& outbox) {
  to_message(*output_, criteria_, uncertainty_.assumed, large_.outlook);
  stamp(large_.outlook, now);
  large_.outlook.limits_digest = limits_.digest;
  send(OutChannel::kOutlook, large_.outlook, outbox);
}

void Session::send_comparison(std::int64_t now, Outbox& outbox) {
  if (output_->advice.no_advice == NoAdvice::kNone) {
    large_.predicted.note(seconds_between(0, now), output_->present);
  }
  if (!is_comparison_due_ || inputs_.motion(now) == nullptr) {
    return;
  }
  is_comparison_due_ = false;
  const motion_t& motion = inputs_.motion_message();
  const auto systems = std::span(output_->systems).first(output_->num_systems);
  large_.predicted.compare(*inputs_.motion(now), *hull_, seconds_between(0, motion.utime),
                           height_deviation(uncertainty_.of, systems), large_.comparison);
  to_message(large_.comparison, *hull_, motion.window_s, large_.comparison_message);
  large_.comparison_message.utime = motion.utime;
  ++large_.comparison_message.seq;
  large_.comparison_message.source_id = options_.source_id;
  large_.comparison_message.motion_source_id = motion.source_id;
  large_.comparison_message.motion_seq = motion.seq;
  send(OutChannel::kComparison, large_.comparison_message, outbox);
  alerts_.follow(large_.comparison_message, now);
}

}  // namespace quickstrip
