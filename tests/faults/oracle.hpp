// What a session in this process says on the same inputs, afresh: the running advisor's numbers must be
// these, bit for bit, and what it shows must not be better. (That the numbers themselves are right, other
// tests show.)
#pragma once

#include <map>
#include <memory>
#include <string>

#include "firmware/session/session.hpp"
#include "msgs/files/ship_files.hpp"

namespace quickstrip::faults {

struct Opinion {
  advice_t advice{};
  grid_t grid{};
};

class Oracle {
 public:
  explicit Oracle(const std::string& hull_file);

  /// `loading`: null for the hull file's own.
  const Opinion& of(const sea_state_t& sea, const own_ship_t& ship, const loading_t* loading);
  [[nodiscard]] const Hull& hull() const { return files_->hull; }

 private:
  std::unique_ptr<ShipFiles> files_;
  std::map<std::string, std::unique_ptr<Opinion>> known_;
};

}  // namespace quickstrip::faults
