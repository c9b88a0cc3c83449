// The journal on standard error: one line per change of state, none per cycle. No heap.
#pragma once

#include <cstdint>

#include "firmware/session/session.hpp"

namespace quickstrip {

class Journal {
 public:
  /// Writes a line when the verdict, the reason for no advice, or the kind of sea has changed.
  void follow(const advice_t& advice);

  /// Writes a line when messages were refused since the last look.
  void follow(const Inputs& inputs, std::int64_t utime);

 private:
  bool has_line_ = false;
  int no_advice_ = 0;
  int verdict_ = 0;
  int sea_input_ = -1;
  std::int64_t num_refused_ = 0;
};

}  // namespace quickstrip
