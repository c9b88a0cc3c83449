#include "sim/hull_tool/transfer_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <optional>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/sea_files/number_list.hpp"

namespace quickstrip::hull_tool {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  return fields;
}

class TransferFile {
 public:
  explicit TransferFile(const std::string& path) : path_(path), stream_(path) {
    if (!stream_) {
      throw InputError{path + ": cannot be read"};
    }
  }

  std::vector<TransferValue> read() {
    if (!next_line()) {
      refuse("holds no header line");
    }
    find_columns();
    std::vector<TransferValue> values;
    while (next_line()) {
      add_line(values);
    }
    if (values.empty()) {
      throw InputError{path_ + ": holds no transfer function"};
    }
    return values;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // The next line that is not blank and not a comment, parted into fields_.
  bool next_line() {
    while (std::getline(stream_, line_)) {
      ++number_;
      if (!line_.empty() && line_.back() == '\r') {
        line_.pop_back();
      }
      if (!line_.empty() && line_.front() != '#') {
        fields_ = fields_of(line_);
        return true;
      }
    }
    return false;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError{fmt::format("{}: line {}: {}", path_, number_, what)};
  }

  [[nodiscard]] std::size_t column(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
      const auto at = std::find(fields_.begin(), fields_.end(), name);
      if (at != fields_.end()) {
        return static_cast<std::size_t>(at - fields_.begin());
      }
    }
    return kNone;
  }

  void find_columns() {
    num_columns_ = fields_.size();
    speed_ = column({"speed_kn"});
    mu_ = column({"mu_deg", "direction_deg"});
    omega_ = column({"omega", "omega_rad_s"});
    dof_ = column({"dof"});
    amplitude_ = column({"amplitude"});
    for (std::size_t i = 0; i < kMotionNames.size(); ++i) {
      motion_[i] = column({fmt::format("{}_amp", kMotionNames[i])});
    }
    const bool is_long = dof_ != kNone && amplitude_ != kNone;
    const bool is_wide =
        std::any_of(motion_.begin(), motion_.end(), [](std::size_t c) { return c != kNone; });
    if (speed_ == kNone || mu_ == kNone || omega_ == kNone || is_long == is_wide) {
      refuse(
          "the header names its columns: speed_kn, mu_deg, omega, and either dof,amplitude or surge_amp "
          "... yaw_amp");
    }
  }

  [[nodiscard]] double number(std::size_t column, std::string_view name, ListRange range) const {
    const std::optional<double> value = parse_number(fields_[column]);
    if (!value || *value < range.from || *value > range.to) {
      refuse(fmt::format("{} = {}: a number in [{:g}, {:g}] is wanted", name, fields_[column], range.from,
                         range.to));
    }
    return *value;
  }

  void add_line(std::vector<TransferValue>& values) const {
    if (fields_.size() != num_columns_) {
      refuse(fmt::format("{} fields, the header names {}", fields_.size(), num_columns_));
    }
    TransferValue value;
    value.speed_kn = number(speed_, "speed_kn", {0.0, 60.0});
    value.mu_deg = number(mu_, "mu_deg", {-360.0, 360.0});
    value.omega = number(omega_, "omega", {1e-3, 20.0});
    if (dof_ != kNone) {
      value.motion = motion_of(fields_[dof_]);
      value.amplitude = number(amplitude_, "amplitude", kAmplitudes);
      values.push_back(value);
      return;
    }
    for (std::size_t i = 0; i < motion_.size(); ++i) {
      if (motion_[i] != kNone && !fields_[motion_[i]].empty()) {
        value.motion = i;
        value.amplitude = number(motion_[i], fmt::format("{}_amp", kMotionNames[i]), kAmplitudes);
        values.push_back(value);
      }
    }
  }

  [[nodiscard]] std::size_t motion_of(std::string_view name) const {
    const auto at = std::find(kMotionNames.begin(), kMotionNames.end(), name);
    if (at == kMotionNames.end()) {
      refuse(fmt::format("dof = {}: one of {} is wanted", name, fmt::join(kMotionNames, ", ")));
    }
    return static_cast<std::size_t>(at - kMotionNames.begin());
  }

  static constexpr ListRange kAmplitudes{0.0, 1000.0};

  std::string path_;
  std::ifstream stream_;
  std::string line_;
  std::size_t number_ = 0;
  std::vector<std::string_view> fields_;
  std::size_t num_columns_ = 0;
  std::size_t speed_ = kNone;
  std::size_t mu_ = kNone;
  std::size_t omega_ = kNone;
  std::size_t dof_ = kNone;
  std::size_t amplitude_ = kNone;
  std::array<std::size_t, 6> motion_{};
};

}  // namespace

std::vector<TransferValue> read_transfer_file(const std::string& path) {
  return TransferFile(path).read();
}

}  // namespace quickstrip::hull_tool
