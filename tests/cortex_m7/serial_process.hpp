// A program that speaks frames on its standard input and output: the emulated board, or the same session on
// this machine.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "firmware/cortex-m7/serial/framing.hpp"

namespace quickstrip::test {

/// What came for one QS_TIME, by channel; the last of each.
using Answer = std::map<std::uint8_t, std::vector<std::uint8_t>>;

class SerialProcess {
 public:
  explicit SerialProcess(const std::vector<std::string>& command);
  ~SerialProcess();
  SerialProcess(const SerialProcess&) = delete;
  SerialProcess& operator=(const SerialProcess&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  /// Up to the line report that ends a cycle; without one when `most_s` pass or the program ends.
  Answer read_answer(double most_s);
  [[nodiscard]] const FrameCounters& counters() const { return decoder_.counters(); }

 private:
  pid_t pid_ = -1;
  int to_ = -1;
  int from_ = -1;
  FrameDecoder decoder_;
  std::vector<std::uint8_t> waiting_;
};

}  // namespace quickstrip::test
