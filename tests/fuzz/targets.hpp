// What is fuzzed: each target takes any bytes and must neither crash, nor hang, nor break a promise. The
// ordinary tests run each on its seeds, on the findings of before and on seeded mutations of both
// (short_fuzz_test.cpp); libFuzzer runs them as long as one likes (README.md).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace quickstrip::fuzz {

using Bytes = std::vector<std::uint8_t>;

struct Target {
  std::string_view name;
  void (*run)(std::span<const std::uint8_t> bytes);
  std::vector<Bytes> (*seeds)();
  int num_mutations;  // in the ordinary tests: about a second's worth
};

std::span<const Target> targets();

/// Null for an unknown name.
const Target* target_of(std::string_view name);

/// A promise: when it is broken, one line and abort, which a fuzzer takes for a finding.
void require(bool holds, std::string_view promise);

/// A refusal of a file: one line that begins with the file's name.
void require_one_line(std::string_view line, std::string_view file);

// By file.
void run_hull(std::span<const std::uint8_t> bytes);
void run_limits(std::span<const std::uint8_t> bytes);
void run_sea(std::span<const std::uint8_t> bytes);
void run_voyage(std::span<const std::uint8_t> bytes);
void run_log(std::span<const std::uint8_t> bytes);
std::vector<Bytes> hull_seeds();
std::vector<Bytes> limits_seeds();
std::vector<Bytes> sea_seeds();
std::vector<Bytes> voyage_seeds();
std::vector<Bytes> log_seeds();
void run_hull_table(std::span<const std::uint8_t> bytes);
std::vector<Bytes> hull_table_seeds();

// Messages: the bytes are laid over a good message behind its fingerprint, and also taken as they are.
void run_sea_state(std::span<const std::uint8_t> bytes);
void run_wave_spectrum(std::span<const std::uint8_t> bytes);
void run_sea_forecast(std::span<const std::uint8_t> bytes);
void run_own_ship(std::span<const std::uint8_t> bytes);
void run_loading(std::span<const std::uint8_t> bytes);
void run_motion(std::span<const std::uint8_t> bytes);
void run_query(std::span<const std::uint8_t> bytes);
void run_alert_ack(std::span<const std::uint8_t> bytes);
void run_time(std::span<const std::uint8_t> bytes);
std::vector<Bytes> no_seeds();

/// NMEA 0183 lines and datagrams.
void run_nmea(std::span<const std::uint8_t> bytes);
std::vector<Bytes> nmea_seeds();

/// Advice, grid and limits read back and drawn.
void run_picture(std::span<const std::uint8_t> bytes);

/// What a browser posts to the display: every form, without a hull and with one.
void run_entry(std::span<const std::uint8_t> bytes);
std::vector<Bytes> entry_seeds();

/// A whole session: messages, times and cycles in any order.
void run_session(std::span<const std::uint8_t> bytes);
std::vector<Bytes> session_seeds();

/// Raw numbers into the core's step.
void run_step(std::span<const std::uint8_t> bytes);
std::vector<Bytes> step_seeds();

// Other readers.
void run_state(std::span<const std::uint8_t> bytes);
void run_ndbc(std::span<const std::uint8_t> bytes);
void run_transfer(std::span<const std::uint8_t> bytes);
void run_list(std::span<const std::uint8_t> bytes);
std::vector<Bytes> state_seeds();
std::vector<Bytes> ndbc_seeds();
std::vector<Bytes> transfer_seeds();
std::vector<Bytes> list_seeds();

/// A board's serial line: frames, and the session behind them.
void run_frames(std::span<const std::uint8_t> bytes);
std::vector<Bytes> frames_seeds();

/// A configuration file of the kind that --config reads.
void run_config(std::span<const std::uint8_t> bytes);
std::vector<Bytes> config_seeds();

}  // namespace quickstrip::fuzz
