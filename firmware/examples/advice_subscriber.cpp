// Prints what the advisor says: the verdict, the limit that governs, how far off it is, and what would help.
//   g++ -std=c++20 -I GENERATED advice_subscriber.cpp -llcm     GENERATED: lcm-gen --cpp --cpp-hpath
//   GENERATED *.lcm advice_subscriber [URL [NUMBER OF MESSAGES]]
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "quickstrip/advice_t.hpp"

namespace {

using quickstrip::advice_t;

/// Text on the wire is NUL-padded bytes.
template <typename Field>
std::string text(const Field& field) {
  return std::string(reinterpret_cast<const char*>(field),
                     strnlen(reinterpret_cast<const char*>(field), sizeof(field)));
}

const char* verdict(int code) {
  switch (code) {
    case advice_t::VERDICT_GOOD:
      return "good";
    case advice_t::VERDICT_CAUTION:
      return "caution";
    case advice_t::VERDICT_EXCEEDED:
      return "limits exceeded";
    default:
      return "not known";  // never to be shown as good
  }
}

void print(const advice_t& advice) {
  using std::chrono::duration_cast;
  using std::chrono::microseconds;
  const std::int64_t now =
      duration_cast<microseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
  if (now > advice.valid_until_utime) {
    std::printf("advice %d has come too late to be shown\n", advice.seq);
  } else if (advice.no_advice != 0) {
    std::printf("%s\n", text(advice.no_advice_text).c_str());
  } else {
    std::printf("%03.0f deg, %.1f kn: %s; governed by %s, waves may grow by the factor %.2f\n",
                advice.heading_deg, advice.speed_kn, verdict(advice.verdict),
                advice.governing < 0 ? "nothing" : text(advice.governing_name).c_str(), advice.margin);
    if (advice.num_changes > 0) {
      std::printf("  best change: %s\n", text(advice.change_text[0]).c_str());
    }
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  lcm::LCM bus(argc > 1 ? argv[1] : "udpm://239.255.76.67:7667?ttl=0");
  if (!bus.good()) {
    std::fprintf(stderr, "LCM does not open: is there a multicast route?\n");
    return 1;
  }
  int left = argc > 2 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : -1;  // for ever
  bus.subscribeFunction<advice_t, int*>(
      "QS_ADVICE",
      [](const lcm::ReceiveBuffer*, const std::string&, const advice_t* advice, int* to_come) {
        print(*advice);
        --*to_come;
      },
      &left);
  while (left != 0) {
    // Silence is not "safe": an advisor that has ended says nothing.
    if (bus.handleTimeout(3000) == 0) {
      std::printf("No advice, because the advisor is silent\n");
      std::fflush(stdout);
    }
  }
  return 0;
}
