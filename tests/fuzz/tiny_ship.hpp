// The S-175 on a grid of two speeds and four headings, and a session of it: quick to configure and to step.
#pragma once

#include "core/hull/hull.hpp"
#include "firmware/session/session.hpp"

namespace quickstrip::fuzz {

/// 0 and 12 kn, every 90 degrees.
GridDefinition tiny_grid();

const Hull& tiny_ship();

/// Anew, with the default criteria.
void configure(Session& session);

/// Decodes what the session sends: every message decodes, and the advisor's readers take it.
class CheckingOutbox : public Outbox {
 public:
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override;
};

}  // namespace quickstrip::fuzz
