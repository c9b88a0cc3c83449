#include "tests/fuzz/tiny_ship.hpp"

#include <cmath>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/base/angles.hpp"
#include "core/base/check.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/own_messages.hpp"
#include "msgs/convert/units.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::fuzz {
namespace {

template <typename Message, typename Check>
void require_good(std::span<const std::uint8_t> bytes, const Check& check) {
  static const auto message = std::make_unique<Message>();
  require(decode(bytes, *message), "what the session sends decodes");
  require(check(*message).ok(), "what the session sends is in range");
}

}  // namespace

GridDefinition tiny_grid() {
  return {.speed_from = 0.0,
          .speed_to = from_knots(12.0),
          .speed_step = from_knots(12.0),
          .heading_step = radians(90.0)};
}

const Hull& tiny_ship() {
  static const std::unique_ptr<const Hull> kShip = [] {
    auto hull = std::make_unique<Hull>(test::s175());
    hull->grid = tiny_grid();
    return hull;
  }();
  return *kShip;
}

void configure(Session& session) {
  const Result<Criteria> criteria = nordforsk_merchant(tiny_ship());
  QS_CHECK(criteria.ok() && session.configure(tiny_ship(), *criteria, {}).ok());
}

bool CheckingOutbox::send(OutChannel channel, std::span<const std::uint8_t> bytes) {
  switch (channel) {
    case OutChannel::kAdvice:
      require_good<advice_t>(bytes, check_advice);
      break;
    case OutChannel::kGrid:
      require_good<grid_t>(bytes, check_grid);
      break;
    case OutChannel::kLimits:
      require_good<limits_t>(bytes, check_limits);
      break;
    default:
      require(!bytes.empty(), "what the session sends is encoded");
      break;
  }
  return true;
}

}  // namespace quickstrip::fuzz
