// QS_RESPONSE from the response of one cell. No heap.
#pragma once

#include <cstdint>

#include "core/advice/cell_response.hpp"
#include "core/advice/criteria.hpp"
#include "core/hull/hull.hpp"
#include "msgs/convert/refusal.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/response_t.hpp"

namespace quickstrip {

/// A cell that is asked for, SI.
struct Query {
  std::int64_t id = 0;
  std::int16_t source_id = 0;
  Heading heading;
  double speed = 0.0;
};

/// Whether the speed is swept is the caller's to say (kSpeedOutsideGrid). On refusal `out` is as it was.
Conversion to_query(const query_t& message, Query& out);

/// Fills all but utime, seq, source_id, query_id and query_source_id.
void to_message(const CellResponse& response, const Hull& hull, const Criteria& criteria,
                std::int64_t limits_digest, response_t& out);

/// The answer to a query that cannot be answered: ids, heading and speed echoed, the reason, nothing else.
/// Leaves utime, seq and source_id.
void to_refusal(const Query& query, Refusal refusal, response_t& out);

}  // namespace quickstrip
