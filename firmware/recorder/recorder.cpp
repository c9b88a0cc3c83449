#include "firmware/recorder/recorder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "firmware/recorder/folder.hpp"
#include "firmware/session/outbox.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr std::array<std::string_view, 4> kOnce{"QUERY", "ALERT_ACK", "LOGBOOK", "TIME"};

template <typename Names>
bool is_among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_due(std::int64_t last, std::int64_t now, double period_s) {
  return now < last || seconds_between(last, now) >= period_s;
}

}  // namespace

std::string_view Recorder::name_of(std::string_view channel) const {
  return channel.substr(std::min(options_.prefix.size(), channel.size()));
}

void Recorder::take(std::int64_t now, std::string_view channel, std::span<const std::uint8_t> data) {
  ++counts_.messages;
  const bool is_full = segment_.size() + data.size() > options_.segment_bytes;
  const bool is_over = is_full || is_due(begun_, now, options_.segment_s);
  if (!segment_.is_open() || (is_over && trouble_.empty())) {  // in trouble what is gathered is kept
    begin_segment(now);
  }
  if (segment_.is_open() && segment_.append(now, channel, data)) {
    counts_.bytes += data.size();
  } else {
    ++counts_.lost;
  }
  remember(channel, data);
}

void Recorder::remember(std::string_view channel, std::span<const std::uint8_t> data) {
  if (is_among(kOnce, name_of(channel))) {
    return;
  }
  auto found = last_.find(channel);
  if (found == last_.end()) {
    if (last_.size() == kMaxRepeated) {
      return;
    }
    found = last_.emplace(channel, LastTwo{}).first;
  }
  LastTwo& two = found->second;
  if (!is_among(kOutChannelNames, name_of(channel))) {
    std::swap(two.last, two.before);
  }
  two.last.assign(data.begin(), data.end());
}

/// Inputs first, then what rests on them.
void Recorder::repeat(std::int64_t now) {
  for (const bool is_output : {false, true}) {
    for (const auto& [channel, two] : last_) {
      if (is_among(kOutChannelNames, name_of(channel)) != is_output) {
        continue;
      }
      if (!two.before.empty()) {
        static_cast<void>(segment_.append(now, channel, two.before));
      }
      static_cast<void>(segment_.append(now, channel, two.last));
    }
  }
}

void Recorder::begin_segment(std::int64_t now) {
  if (!segment_.is_open() && !trouble_.empty() && !is_due(begun_, now, options_.flush_s)) {
    return;  // tried just now
  }
  begun_ = now;
  flushed_ = now;
  if (const FileStatus closed = segment_.close(); !closed) {
    note(closed);
  }
  counts_.lost += segment_.num_gathered();  // what close() could not write
  const FileStatus status = segment_.open(options_.folder / segment_name(now));
  if (!status) {
    note(status);
    return;
  }
  ++counts_.segments;
  repeat(now);
  note(segment_.flush());
  counts_.deleted += static_cast<std::uint64_t>(keep_quota(
      options_.folder, options_.quota_bytes - std::min(options_.quota_bytes, options_.segment_bytes),
      segment_.path()));
}

void Recorder::turn(std::int64_t now) {
  if (segment_.is_open() && is_due(flushed_, now, options_.flush_s)) {
    flushed_ = now;
    note(segment_.flush());
  }
}

void Recorder::note(const FileStatus& status) {
  if (!status && trouble_.empty()) {
    std::fprintf(stderr, "%s; recording goes on when there is room\n", status.line().c_str());
  }
  if (status && !trouble_.empty() && segment_.is_open()) {
    std::fprintf(stderr, "recording goes on; %llu messages were lost\n",
                 static_cast<unsigned long long>(counts_.lost));
  }
  trouble_ = status ? std::string() : status.line();
}

}  // namespace quickstrip
