// The journal on standard error: one line per change of state, none per cycle. The cycle's thread notes what
// has changed (Journal: no heap, no lock, no system call); a thread of its own words and writes it
// (JournalWriter). A line that cannot be written in time is lost, and how many were is written next.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "firmware/advisor/missed_deadlines.hpp"
#include "firmware/advisor/record_ring.hpp"
#include "firmware/session/session.hpp"

namespace quickstrip {

/// What a line is made of.
struct JournalRecord {
  enum class Kind : std::uint8_t { kAdvice, kNoAdvice, kRefusal, kMissed };
  Kind kind = Kind::kAdvice;
  bool is_spectrum = false;  // of the sea in force
  std::int64_t utime = 0;
  int verdict = 0;
  double heading_deg = 0.0;
  double speed_kn = 0.0;
  std::array<char, 257> text{};  // reasons, or why there is no advice; ends with NUL
  std::size_t input = 0;         // of a refusal
  Conversion refusal;
  MissedDeadline missed;  // the worst of num_missed
  int num_missed = 0;
};

using JournalRing = RecordRing<JournalRecord, 32>;

class Journal {
 public:
  explicit Journal(JournalRing& ring) : ring_(ring) {}

  /// Notes when the verdict, the reason for no advice, or the kind of sea has changed.
  void follow(const advice_t& advice);

  /// Notes when messages were refused for the first time.
  void follow(const Inputs& inputs, std::int64_t utime);

  /// Call each cycle: notes misses at once, then at most every ten seconds.
  void follow(MissedDeadlines& missed, double steady_s);

  void note(const MissedDeadlines& missed);

 private:
  JournalRing& ring_;
  bool has_line_ = false;
  int no_advice_ = 0;
  int verdict_ = 0;
  int sea_input_ = -1;
  bool has_refused_ = false;
};

class JournalWriter {
 public:
  explicit JournalWriter(JournalRing& ring) : ring_(ring) {}
  ~JournalWriter() { stop(); }
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  void start();
  /// After a last look.
  void stop();

 private:
  void write();

  JournalRing& ring_;
  std::int64_t num_lost_ = 0;  // that were told
  std::atomic<bool> is_running_{false};
  std::thread thread_;
};

}  // namespace quickstrip
