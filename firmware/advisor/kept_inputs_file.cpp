#include "firmware/advisor/kept_inputs_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>

#include "firmware/advisor/standard_streams.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kLook{200};
// A restart finds it at most so old: well within the age at which own ship goes stale (10 s).
constexpr std::int64_t kOwnShipEvery_us = 2'000'000;

/// Writes events and, last, the digest of them all: LCM logs have no checksum, and a flipped bit must not
/// come back as a lower sea.
class SealedLog {
 public:
  FileStatus open(const std::filesystem::path& path) { return log_.open(path); }
  template <typename Message>
  FileStatus append(const std::string& channel, const Message& message) {
    static std::array<std::uint8_t, kMaxMessageBytes> buffer;  // one thread writes
    const auto bytes = encode(message, buffer);
    digest_.add(channel);
    digest_.add(bytes);
    return log_.append(message.utime, channel, bytes);
  }
  FileStatus finish(const std::string& prefix) {
    const std::array<std::uint8_t, 8> bytes = seal_bytes(digest_);
    FileStatus status = log_.append(0, prefix + kSealChannel, bytes);
    return status ? log_.finish() : status;
  }

  static constexpr const char* kSealChannel = "STATE_DIGEST";
  static std::array<std::uint8_t, 8> seal_bytes(const Fnv1a& digest) {
    return std::bit_cast<std::array<std::uint8_t, 8>>(digest.value());
  }

 private:
  LcmLogWriter log_;
  Fnv1a digest_;
};

/// Whether what came is worth a write after what was written.
bool is_due(const KeptInputs& kept, const KeptInputs& written) {
  return kept.sea_state.utime != written.sea_state.utime ||
         kept.wave_spectrum.utime != written.wave_spectrum.utime ||
         kept.loading.utime != written.loading.utime ||
         kept.own_ship.utime - written.own_ship.utime >= kOwnShipEvery_us ||
         kept.own_ship.utime < written.own_ship.utime;
}

bool is_sound(const limits_t& limits) {
  return limits.num_criteria >= 0 &&
         static_cast<std::size_t>(limits.num_criteria) <= sizeof(limits.limit) / sizeof(limits.limit[0]);
}

template <typename Message>
int restore(const LogEvent& event, std::int64_t now, Session& session) {
  const auto message = std::make_unique<Message>();
  return decode(event.data, *message) && session.accept(*message, now, InputUse::kRestored).ok() ? 1 : 0;
}

bool holds_nothing(const std::filesystem::path& path) {
  std::error_code error;
  return !std::filesystem::exists(path, error) || std::filesystem::file_size(path, error) == 0;
}

/// A file that is not there, or empty, holds nothing; neither does a damaged one.
template <typename See>
FileStatus for_each_event(const std::filesystem::path& path, const std::string& prefix, const See& see) {
  bool is_whole = false;
  if (FileStatus status = look_at_state(path, prefix, is_whole);
      !status || !is_whole || holds_nothing(path)) {
    return status;
  }
  LcmLogReader log;
  if (FileStatus status = log.open(path); !status) {
    return status;
  }
  LogEvent event;
  while (log.next(event)) {
    see(event);
  }
  return {};
}

}  // namespace

FileStatus look_at_state(const std::filesystem::path& path, const std::string& prefix, bool& is_whole) {
  is_whole = true;
  if (holds_nothing(path)) {
    return {};
  }
  LcmLogReader log;
  if (FileStatus status = log.open(path); !status) {
    return status;
  }
  Fnv1a digest;
  LogEvent event;
  bool is_sealed = false;
  while (log.next(event)) {
    if (is_sealed) {
      is_sealed = false;  // something behind the seal
      break;
    }
    const auto seal = SealedLog::seal_bytes(digest);
    is_sealed = event.channel == prefix + SealedLog::kSealChannel &&
                std::equal(event.data.begin(), event.data.end(), seal.begin(), seal.end());
    digest.add(event.channel);
    digest.add(event.data);
  }
  is_whole = is_sealed && log.num_faults() == 0;
  return {};
}

FileStatus write_kept_inputs(const std::filesystem::path& path, const std::string& prefix,
                             const KeptInputs& kept, const limits_t& limits) {
  SealedLog log;
  FileStatus status = log.open(path);
  if (status) {
    status = log.append(prefix + "LIMITS", limits);
  }
  if (status && kept.has_sea_state) {
    status = log.append(prefix + "SEA_STATE", kept.sea_state);
  }
  if (status && kept.has_wave_spectrum) {
    status = log.append(prefix + "WAVE_SPECTRUM", kept.wave_spectrum);
  }
  if (status && kept.has_own_ship) {
    status = log.append(prefix + "OWN_SHIP", kept.own_ship);
  }
  if (status && kept.has_loading) {
    status = log.append(prefix + "LOADING", kept.loading);
  }
  return status ? log.finish(prefix) : status;
}

FileStatus restore_inputs(const std::filesystem::path& path, const std::string& prefix, std::int64_t now,
                          Session& session, int& num_restored) {
  num_restored = 0;
  return for_each_event(path, prefix, [&](const LogEvent& event) {
    if (event.channel == prefix + "SEA_STATE") {
      num_restored += restore<sea_state_t>(event, now, session);
    } else if (event.channel == prefix + "WAVE_SPECTRUM") {
      num_restored += restore<wave_spectrum_t>(event, now, session);
    } else if (event.channel == prefix + "OWN_SHIP") {
      num_restored += restore<own_ship_t>(event, now, session);
    } else if (event.channel == prefix + "LOADING") {
      num_restored += restore<loading_t>(event, now, session);
    }
  });
}

FileStatus read_kept_limits(const std::filesystem::path& path, const std::string& prefix, limits_t& out) {
  out = limits_t{};
  return for_each_event(path, prefix, [&](const LogEvent& event) {
    const bool is_limits = event.channel == prefix + "LIMITS";
    if (is_limits && !(decode(event.data, out) && is_sound(out))) {
      out = limits_t{};  // as if none were known: nothing to compare with
    }
  });
}

InputKeeper::InputKeeper(std::filesystem::path path, std::string prefix, const limits_t& limits)
    : path_(std::move(path)), prefix_(std::move(prefix)), limits_(limits), thread_([this] { keep(); }) {}

InputKeeper::~InputKeeper() {
  stop();
}

void InputKeeper::hand_over(const Inputs& inputs) {
  inputs.keep(newest_.back());
  newest_.publish();
}

void InputKeeper::stop() {
  is_running_ = false;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void InputKeeper::keep() {
  const auto written = std::make_unique<KeptInputs>();
  bool has_failed = false;
  bool has_written = false;
  while (true) {
    const bool was_running = is_running_.load();
    if (newest_.take() && (!has_written || is_due(newest_.front(), *written) || !was_running)) {
      const FileStatus status = write_kept_inputs(path_, prefix_, newest_.front(), limits_);
      has_written = status.ok();
      *written = newest_.front();
      if (!status && !has_failed) {
        tell("inputs are not kept: {}", status.line());
      }
      has_failed = !status;
    }
    if (!was_running) {
      return;  // after a last look
    }
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace quickstrip
