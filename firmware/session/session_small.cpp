// In the place of session_large.cpp in the profile of capacities m7: no grid, response, outlook, comparison.
#include "firmware/session/session.hpp"

namespace quickstrip {

void Session::forget_predicted() {}

void Session::send_grid(std::int64_t /*now*/, Outbox& /*outbox*/) {}

void Session::send_responses(std::int64_t /*now*/, Outbox& /*outbox*/) {
  queries_.clear();
}

void Session::send_outlook(std::int64_t /*now*/, Outbox& /*outbox*/) {}

void Session::send_comparison(std::int64_t /*now*/, Outbox& /*outbox*/) {}

}  // namespace quickstrip
