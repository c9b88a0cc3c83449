#include "tests/faults/oracle.hpp"

#include <array>

#include "core/base/check.hpp"

namespace quickstrip::faults {
namespace {

class NoOutbox : public Outbox {
 public:
  bool send(OutChannel, std::span<const std::uint8_t>) override { return true; }
};

/// What a message says, whoever sent it and when.
template <typename Message>
std::string meaning(Message message) {
  static std::array<std::uint8_t, kMaxMessageBytes> buffer;
  message.utime = 0;
  message.seq = 0;
  message.source_id = 0;
  const auto bytes = encode(message, buffer);
  return {bytes.begin(), bytes.end()};
}

template <typename Message>
void take(Session& session, Message message, std::int64_t now) {
  message.utime = now;
  QS_CHECK(session.accept(message, now).ok());
}

}  // namespace

Oracle::Oracle(const std::string& hull_file) : files_(std::make_unique<ShipFiles>()) {
  QS_CHECK(read_ship_files(hull_file, "", *files_).ok());
}

const Opinion& Oracle::of(const sea_state_t& sea, const own_ship_t& ship, const loading_t* loading) {
  const std::string key =
      meaning(sea) + meaning(ship) + (loading == nullptr ? std::string() : meaning(*loading));
  std::unique_ptr<Opinion>& opinion = known_[key];
  if (opinion == nullptr) {
    constexpr std::int64_t kNow = 1'567'600'800'000'000;
    const auto session = std::make_unique<Session>();
    NoOutbox nowhere;
    SessionOptions options;
    options.profile = files_->profile;
    QS_CHECK(session->configure(files_->hull, files_->criteria, options).ok());
    take(*session, sea, kNow);
    take(*session, ship, kNow);
    if (loading != nullptr) {
      take(*session, *loading, kNow);
      session->cycle(kNow, nowhere);
      session->rebuild();
    }
    session->cycle(kNow + 1, nowhere);
    opinion = std::make_unique<Opinion>(Opinion{session->advice(), session->grid()});
  }
  return *opinion;
}

}  // namespace quickstrip::faults
