#include "firmware/advisor/kept_inputs_file.hpp"

#include <array>
#include <chrono>
#include <cstdio>

#include "msgs/convert/encode.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kLook{200};
// A restart finds it at most so old: well within the age at which own ship goes stale (10 s).
constexpr std::int64_t kOwnShipEvery_us = 2'000'000;

template <typename Message>
FileStatus append(LcmLogWriter& log, const std::string& channel, const Message& message) {
  static std::array<std::uint8_t, kMaxMessageBytes> bytes;  // one thread writes
  return log.append(message.utime, channel, encode(message, bytes));
}

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

/// A file that is not there holds nothing.
template <typename See>
FileStatus for_each_event(const std::filesystem::path& path, const See& see) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return {};
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

FileStatus write_kept_inputs(const std::filesystem::path& path, const std::string& prefix,
                             const KeptInputs& kept, const limits_t& limits) {
  LcmLogWriter log;
  FileStatus status = log.open(path);
  if (status) {
    status = append(log, prefix + "LIMITS", limits);
  }
  if (status && kept.has_sea_state) {
    status = append(log, prefix + "SEA_STATE", kept.sea_state);
  }
  if (status && kept.has_wave_spectrum) {
    status = append(log, prefix + "WAVE_SPECTRUM", kept.wave_spectrum);
  }
  if (status && kept.has_own_ship) {
    status = append(log, prefix + "OWN_SHIP", kept.own_ship);
  }
  if (status && kept.has_loading) {
    status = append(log, prefix + "LOADING", kept.loading);
  }
  return status ? log.finish() : status;
}

FileStatus restore_inputs(const std::filesystem::path& path, const std::string& prefix, std::int64_t now,
                          Session& session, int& num_restored) {
  num_restored = 0;
  return for_each_event(path, [&](const LogEvent& event) {
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
  return for_each_event(path, [&](const LogEvent& event) {
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
        std::fprintf(stderr, "inputs are not kept: %s\n", status.line().c_str());
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
