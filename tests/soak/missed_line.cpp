#include "tests/soak/missed_line.hpp"

#include <ctime>
#include <regex>

namespace quickstrip::soak {

std::optional<MissedLine> read_missed_line(const std::string& line) {
  static const std::regex kForm(
      R"((\S+Z) (?:a deadline was|(\d+) deadlines were) missed.*, took [0-9.]+ of )"
      R"(([0-9.]+) ms, had the processor for ([0-9.]+) ms and gave it up (\d+) times)");
  std::smatch parts;
  if (!std::regex_match(line, parts, kForm)) {
    return std::nullopt;
  }
  std::tm utc{};
  if (strptime(parts[1].str().c_str(), "%Y-%m-%dT%H:%M:%SZ", &utc) == nullptr) {
    return std::nullopt;
  }
  MissedLine out;
  out.second = timegm(&utc);
  out.num = parts[2].matched ? std::stoi(parts[2].str()) : 1;
  out.period_ms = std::stod(parts[3].str());
  out.processor_ms = std::stod(parts[4].str());
  out.num_waits = std::stoi(parts[5].str());
  return out;
}

}  // namespace quickstrip::soak
